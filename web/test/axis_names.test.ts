// A node that is called otherwise takes the names of its axes along.

import assert from "node:assert/strict";
import { test } from "node:test";
import { type GraphDocument, readDocument } from "../src/model/document";
import { renameNode } from "../src/model/edit";
import { withGroups } from "../src/model/group_cards";
import { asObject, type Json } from "../src/model/json";
import { catalogue } from "./real";

function open(json: Json): GraphDocument {
  const result = readDocument(json);
  if ("error" in result) throw new Error(result.error);
  return result.document;
}

function inputs(document: GraphDocument, id: string): Json {
  return asObject(asObject(document.json["nodes"])[id])["inputs"];
}

/** Turned over one axis, and made a surface over it. */
const fan = (turn: Json): GraphDocument =>
  open({
    format: 1,
    nodes: {
      turn: { type: "range", inputs: { count: 5, ...asObject(turn) } },
      height: { type: "expression", inputs: { formula: "x * x", x: { from: "turn" } } },
      skin: { type: "surface", inputs: { shape: { from: "height" }, over: "turn" } },
      other: { type: "surface", inputs: { shape: { from: "height" }, over: "turns" } },
    },
  });

test("an input that names the axis of a node follows its name", () => {
  const renamed = renameNode("turn", "angle", catalogue)(fan({}));
  assert.deepEqual(inputs(renamed, "skin"), { shape: { from: "height" }, over: "angle" });
  assert.deepEqual(inputs(renamed, "other"), { shape: { from: "height" }, over: "turns" });
  assert.deepEqual(inputs(renamed, "height"), { formula: "x * x", x: { from: "angle" } });
});

test("an axis with a name of its own keeps it", () => {
  const renamed = renameNode("turn", "angle", catalogue)(fan({ axis: "turn" }));
  assert.deepEqual(inputs(renamed, "angle"), { count: 5, axis: "turn" });
  assert.deepEqual(inputs(renamed, "skin"), { shape: { from: "height" }, over: "turn" });
});

test("an axis that comes out of a group follows the name of the group's node", () => {
  const document = open({
    format: 2,
    groups: { steps: { outputs: [{ name: "values", from: "count" }], nodes: { count: { type: "range" } } } },
    nodes: {
      stair: { type: "group/steps" },
      skin: { type: "surface", inputs: { shape: { from: "stair" }, over: "stair/count" } },
    },
  });
  const renamed = renameNode("stair", "ramp", withGroups(catalogue, document))(document);
  assert.deepEqual(inputs(renamed, "skin"), { shape: { from: "ramp" }, over: "ramp/count" });
});
