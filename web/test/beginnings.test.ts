import assert from "node:assert/strict";
import { test } from "node:test";
import { likelySource } from "../src/model/beginnings";
import { catalogue } from "./real";

test("the likeliest node for an input makes its type of what is set by hand", () => {
  const likely = (...types: string[]) => likelySource(catalogue, types)?.title;
  assert.equal(likely("generator"), "Point pair");
  assert.equal(likely("point", "circle", "sphere", "mesh"), "Circle");
  assert.equal(likely("sphere"), "Sphere");
  assert.equal(likely("no such type"), undefined);
});
