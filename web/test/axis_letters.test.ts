import assert from "node:assert/strict";
import { test } from "node:test";
import { OrthographicCamera, PerspectiveCamera, Vector2, Vector3 } from "three";
import { letterShare } from "../src/view3d/axis_letters";

const SIZE = new Vector2(800, 400);
const ORIGIN = new Vector3();

function perspective(): PerspectiveCamera {
  const camera = new PerspectiveCamera(45, SIZE.x / SIZE.y, 0.1, 100);
  camera.position.set(0, 0, 10);
  camera.updateMatrixWorld();
  return camera;
}

/** Height above the middle of the view in pixels. */
function pixelsAbove(point: Vector3, camera: PerspectiveCamera | OrthographicCamera): number {
  return (point.clone().project(camera).y * SIZE.y) / 2;
}

test("the letter of an axis that is in sight stands at its end", () => {
  assert.equal(letterShare(ORIGIN, new Vector3(1, 1, 0), perspective(), SIZE), 1);
});

test("the letter of an axis that leaves the view stops before the toolbars", () => {
  const flat = new OrthographicCamera(-4, 4, 2, -2, 0.1, 100);
  flat.position.set(0, 0, 10);
  flat.updateMatrixWorld();
  for (const camera of [perspective(), flat]) {
    const tip = new Vector3(0, 6, 3);
    const share = letterShare(ORIGIN, tip, camera, SIZE);
    const above = pixelsAbove(tip.clone().multiplyScalar(share), camera);
    assert.ok(share > 0 && share < 1);
    assert.ok(Math.abs(above - (SIZE.y / 2 - 58)) < 1, `${above} pixels above the middle`);
  }
});

test("an axis towards the eye and beyond has its letter before the eye", () => {
  const share = letterShare(ORIGIN, new Vector3(3, 3, 40), perspective(), SIZE);
  assert.ok(share > 0 && share * 40 < 10);
});

test("no letter is told of an axis whose beginning is out of sight", () => {
  const far = new Vector3(50, 0, 0);
  assert.equal(letterShare(far, new Vector3(51, 0, 0), perspective(), SIZE), 0);
  assert.equal(letterShare(new Vector3(0, 2.7, 0), new Vector3(0, 90, 0), perspective(), SIZE), 0);
});
