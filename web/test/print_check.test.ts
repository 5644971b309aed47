import assert from "node:assert/strict";
import { test } from "node:test";
import { verdict } from "../src/files/print_verdict";
import { readReport } from "../src/net/report";

const part = (name: string, more: object = {}): object => ({
  name,
  type: "mesh",
  watertight: true,
  components: 1,
  self_intersections: 0,
  ...more,
});
const said = (...parts: object[]): string => verdict(readReport({ parts: parts as never }).parts);

test("one part is spoken of by itself, several by their number", () => {
  assert.equal(said(part("a")), "It is closed and meets itself nowhere.");
  assert.equal(said(part("a"), part("b")), "All parts are closed and meet themselves nowhere.");
  assert.equal(said(part("a", { watertight: false })), "It is open. What is open cannot be printed.");
  assert.equal(said(part("a", { self_intersections: 2 }), part("b")), "1 of 2 parts meets itself.");
  assert.equal(
    said(part("a", { self_intersections: 2, watertight: false }), part("b", { watertight: false })),
    "2 of 2 parts are open. What is open cannot be printed. 1 of 2 parts meets itself.",
  );
});

test("a model without meshes has nothing to print", () => {
  assert.equal(said(), "There is nothing to print: only curves or points.");
});
