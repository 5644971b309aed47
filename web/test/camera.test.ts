import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";
import { readDocument } from "../src/model/document";
import type { Json } from "../src/model/json";
import { framingOf } from "../src/view3d/framing";

function cameraOf(camera: Json): unknown {
  const result = readDocument({ format: 1, meta: { camera }, nodes: {} });
  return "error" in result ? result.error : result.document.camera;
}

test("the camera of a document is read, and one that cannot be looked from is none", () => {
  const camera = { position: [1, -4, 2], target: [0, 0, 0.5], up: [0, 0, 1] };
  assert.deepEqual(cameraOf(camera), { position: [1, -4, 2], target: [0, 0, 0.5] });
  assert.equal(cameraOf({ position: [1, 1, 1], target: [1, 1, 1] }), null);
  assert.equal(cameraOf({ position: [1, 1], target: [0, 0, 0] }), null);
  assert.equal(cameraOf({ position: [1, 1, "1"], target: [0, 0, 0] }), null);
  assert.equal(cameraOf("above"), null);
});

test("a camera stands where the document says, Z up, and further back in a narrow view", () => {
  const place = { position: [0, -4, 3], target: [0, 0, 0] } as const;
  const [direction, wide] = framingOf(place, [new Vector3(0, 2, 0)], 2);
  assert.ok(direction.distanceTo(new Vector3(0, -3, -4)) < 1e-12);
  assert.deepEqual([wide.distance, wide.radius], [5, 2]);
  const [, narrow] = framingOf(place, [], 0.8);
  assert.equal(narrow.distance, 10);
});
