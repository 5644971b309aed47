// A contact sheet whose variants fail, cannot be drawn, or are not wanted any more.

import assert from "node:assert/strict";
import { test } from "node:test";
import type { Json } from "../src/model/json";
import { readParameter } from "../src/model/parameters";
import { type Cell, fillSheet } from "../src/session/contact_sheet";
import { FakeView, fakeSession, lines, serve, settle } from "./fake_session";

const GRAPH: Json = { format: 1, nodes: { out: { type: "export" } } };
const first = readParameter("reach", { type: "number", default: 1, min: 0, max: 3 });
const AXES = { first, xs: [0, 1, 2], ys: [] };

const line = (reach: number): object => ({
  ...{ index: reach, parameters: { reach }, status: "done" },
  model: { sha256: `step-${reach}` },
});

test("one picture that cannot be drawn, or a variant that fails, leaves the others as they are", async () => {
  const errors = [{ code: "degenerate", detail: "no circle" }];
  serve((address) =>
    address.includes("artifacts")
      ? new Response(address.split("/").at(-1))
      : lines([line(0), { index: 1, parameters: { reach: 1 }, status: "failed", errors }, line(2)]),
  );
  const view = new FakeView();
  view.broken.add("step-0");
  let cells: readonly Cell[] = [];
  const problem = await fillSheet(fakeSession(GRAPH, view), AXES, new AbortController().signal, (told) => {
    cells = told;
  });
  assert.equal(problem, "");
  assert.deepEqual(
    cells.map(({ image, error }) => image || error),
    ["It cannot be drawn.", "no circle", "blob:picture-1"],
  );
  assert.equal(view.left, 0);
});

test("a sheet that is closed lets its pictures go and rejects nothing", async () => {
  const revoked: string[] = [];
  URL.revokeObjectURL = (address) => void (address && revoked.push(address));
  const request = new AbortController();
  serve(async (address) => {
    if (!address.includes("artifacts")) return lines([line(0), line(1), line(2)]);
    if (address.endsWith("step-1")) request.abort();
    return new Response(address.split("/").at(-1));
  });
  const view = new FakeView();
  let told = 0;
  const problem = await fillSheet(fakeSession(GRAPH, view), AXES, request.signal, () => void told++);
  await settle();
  assert.equal(problem, "");
  assert.deepEqual(revoked, ["blob:picture-1"]);
  assert.equal(told, 2, "the empty sheet, and one picture");
});
