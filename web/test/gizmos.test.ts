import assert from "node:assert/strict";
import { test } from "node:test";
import { Ray, Vector3 } from "three";
import { readCatalogue } from "../src/model/catalogue";
import { readDocument } from "../src/model/document";
import type { Json, JsonObject } from "../src/model/json";
import type { ParameterValues } from "../src/model/parameters";
import { inGraph, inScene, snapped, tidy } from "../src/view3d/drag";
import { axisDrag, planeDrag, radiusDrag, tipDrag } from "../src/view3d/gizmo_drags";
import { anchorsOf, gizmosOf, type Vec } from "../src/view3d/gizmo_values";

const vector = { types: ["vector"], default: [0, 0, 1] };
const catalogue = readCatalogue({
  nodes: [
    {
      id: "ring",
      title: "Ring",
      inputs: [
        { name: "center", types: ["point"], default: [0, 0, 0], handle: { kind: "position" } },
        { name: "normal", ...vector, handle: { kind: "direction", at: "center" } },
        { name: "radius", types: ["number"], default: 1, handle: { kind: "radius", at: "center", normal: "normal" } },
        { name: "count", types: ["integer"], default: 3 },
      ],
      outputs: [{ name: "ring", types: ["circle"] }],
    },
  ],
} as Json);

function gizmos(inputs: JsonObject, values: ParameterValues = {}) {
  const parameters = { place: { type: "vector", default: [4, 5, 6] }, size: { type: "number", default: 2 } };
  const result = readDocument({ format: 1, parameters, nodes: { a: { type: "ring", inputs } } });
  if ("error" in result) throw new Error(result.error);
  return gizmosOf({ document: result.document, catalogue, values, selected: "a" });
}

test("every input with a hint has a gizmo, at its literal or its default", () => {
  const all = gizmos({ center: [1, 2, 3] });
  assert.deepEqual(
    all.map((gizmo) => [gizmo.kind, gizmo.value]),
    [
      ["position", [1, 2, 3]],
      ["direction", [0, 0, 1]],
      ["radius", 1],
    ],
  );
  assert.ok(all.every((gizmo) => gizmo.kind === "position" || gizmo.at.join() === "1,2,3"));
});

test("a parameter is dragged in place of the input it drives, and a wire is not dragged", () => {
  const [place] = gizmos({ center: { parameter: "place" } }, { place: [7, 0, 0] });
  assert.deepEqual(place?.value, [7, 0, 0]);
  assert.ok(place?.target.kind === "parameter" && place.target.parameter.name === "place");
  const wired = gizmos({ center: { from: "b" }, radius: 2 });
  assert.deepEqual(wired, [], "nothing is drawn where the page does not know the place");
  const size = gizmos({ radius: { parameter: "size" }, normal: { from: "b" } });
  assert.deepEqual(
    size.map((gizmo) => gizmo.kind),
    ["position"],
  );
});

test("what hangs on a wired place is drawn once the server has said where that is", () => {
  const json = { a: { type: "ring", inputs: { center: { from: "b" }, radius: 2 } }, b: { type: "ring" } };
  const result = readDocument({ format: 1, nodes: json });
  assert.ok("document" in result);
  const source = { document: result.document, catalogue, values: {}, selected: "a" };
  assert.deepEqual(anchorsOf(source), [{ port: "center", node: "b", output: "ring" }]);
  assert.deepEqual(gizmosOf(source), []);
  const all = gizmosOf({ ...source, wired: new Map([["center", [1, 2, 3] as Vec]]) });
  assert.deepEqual(
    all.map((gizmo) => [gizmo.kind, gizmo.kind !== "position" && gizmo.at]),
    [
      ["direction", [1, 2, 3]],
      ["radius", [1, 2, 3]],
    ],
  );
});

test("values that are no place in space have no gizmo", () => {
  for (const center of [[1, 2], [1, 2, null], "here", [1, 2, "3"], [[0], 1, 2]] as Json[]) {
    assert.deepEqual(gizmos({ center, normal: [0, 0, 1] }), []);
  }
  assert.equal(gizmos({ normal: [0, 0, 0] }).length, 1, "an arrow without length cannot be turned");
});

const view = { direction: () => new Vector3(0, 0, -1), cell: () => 0.2 };
const ray = (x: number, y: number) => new Ray(new Vector3(x, y, 10), new Vector3(0, 0, -1));

test("a drag moves by what the pointer moved, not to where it is", () => {
  const value = (): Vec => [1, 0, 2];
  // The scene's Y is the graph's Z; the eye looks along the graph's Y.
  const free = planeDrag(view, undefined, value)(ray(1.05, 2.05));
  assert.deepEqual(free(ray(1.35, 1.85), false), [1.3, 0, 1.8]);
  assert.deepEqual(free(ray(1.35, 1.85), true), [1.3, 0, 1.8]);
  assert.deepEqual(free(ray(1.42, 1.9), true), [1.4, 0, 1.9]);
  const along = axisDrag(view, 2, value)(ray(0, 2));
  assert.deepEqual(along(ray(9, 2.5), false), [1, 0, 2.5]);
  const towards = axisDrag(view, 1, value)(ray(1, 2));
  assert.equal(towards(ray(1, 3), false), undefined, "an axis towards the eye cannot be dragged");
});

test("an arrow's tip and a ring's edge are written as direction and radius", () => {
  const tip = tipDrag(
    view,
    () => [1, 0, 1],
    () => [0, 0, 1],
  )(ray(1, 2));
  assert.deepEqual(tip(ray(1.5, 2), false), [0.5, 0, 1]);
  assert.equal(tip(ray(1, 1), false), undefined, "an arrow never becomes nothing");
  const radius = radiusDrag(
    view,
    () => [0, 0, 0],
    () => [0, -1, 0],
  )(ray(1, 0));
  assert.equal(radius(ray(3, 4), false), 5);
  assert.ok((radius(ray(0, 0), false) ?? 0) > 0);
});

test("graph and scene coordinates are turned into each other, and dragged numbers are short", () => {
  assert.deepEqual(inGraph(inScene([1, 2, 3])), [1, 2, 3]);
  assert.equal(snapped(0.33, 0.1), 0.3);
  assert.equal(tidy(0.123456789, 0.2), 0.123);
  assert.equal(tidy(123456.789, 1000), 123457);
});
