import assert from "node:assert/strict";
import { test } from "node:test";
import { beginningValues } from "../src/model/beginnings";
import { colorScales } from "../src/model/color_scales";
import { readDocument } from "../src/model/document";
import { viewGraph } from "../src/model/graph";
import type { Json } from "../src/model/json";
import type { ParameterValues } from "../src/model/parameters";
import { catalogue } from "./real";

const nodes = (color: Json): Json => ({
  format: 1,
  parameters: { most: { type: "number", default: 4, min: 0, max: 9 } },
  nodes: {
    ball: { type: "sphere_mesh", inputs: {} },
    first: { type: "curvature_color", inputs: { shape: { from: "ball" } } },
    ...(color as object),
    out: { type: "export", inputs: { model: { from: "seen" } } },
  },
});

function scalesOf(graph: Json, values: ParameterValues = {}) {
  const read = readDocument(graph);
  if ("error" in read) throw new Error(read.error);
  return colorScales(read.document, catalogue, viewGraph(read.document, catalogue), values, "out");
}

test("the scale of the colors that are seen is told, and not that of colors below them", () => {
  const graph = nodes({
    seen: {
      type: "color_by",
      inputs: {
        shape: { from: "first" },
        value: 1,
        minimum: -2,
        maximum: { parameter: "most" },
        palette: "sequential",
      },
    },
  });
  const [scale, ...others] = scalesOf(graph, { most: 7 });
  assert.deepEqual(others, []);
  assert.equal(scale?.node, "seen");
  assert.deepEqual(scale?.ends, [-2, 7]);
  assert.deepEqual(scalesOf(graph)[0]?.ends, [-2, 4]);
  assert.equal(scale?.colors.length, 13);
});

test("a range of 0 is one that is found: the outputs that tell it are named", () => {
  const seen = (inputs: object): Json =>
    nodes({ seen: { type: "curvature_color", inputs: { shape: { from: "ball" }, ...inputs } } });
  const [found] = scalesOf(seen({}));
  assert.equal(found?.ends, undefined);
  assert.deepEqual(found?.found, ["minimum", "maximum"]);
  assert.equal(found?.unit, "m⁻²");
  const [given] = scalesOf(seen({ range: 3, kind: "mean" }));
  assert.deepEqual(given?.ends, [-3, 3]);
  assert.equal(given?.unit, "m⁻¹");
});

test("new nodes are given what their cards say, and nothing else", () => {
  const begun = [...catalogue.nodes.values()].filter((card) => Object.keys(beginningValues(card)).length > 0);
  assert.deepEqual(
    begun.map((card) => [card.id, beginningValues(card)]),
    [["warp", { softening: 0.5 }]],
  );
});
