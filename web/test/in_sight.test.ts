import assert from "node:assert/strict";
import { test } from "node:test";
import { shareInSight } from "../src/graph/in_sight";

const PANE = { width: 400, height: 300 };
/** Ten in a row, 100 wide, with gaps of as much. */
const ROW = Array.from({ length: 10 }, (_, at) => ({ x: 200 * at, y: 0, width: 100, height: 50 }));

test("what a pane shows a part of is in sight", () => {
  assert.equal(shareInSight(ROW, { x: 0, y: 0, zoom: 1 }, PANE), 0.2);
  assert.equal(shareInSight(ROW, { x: -99, y: 0, zoom: 1 }, PANE), 0.3);
  assert.equal(shareInSight(ROW, { x: 0, y: 0, zoom: 0.2 }, PANE), 1);
  assert.equal(shareInSight(ROW, { x: 0, y: 300, zoom: 0.2 }, PANE), 0);
  assert.equal(shareInSight(ROW, { x: 0, y: -50, zoom: 1 }, PANE), 0);
});

test("nothing is in sight of an empty graph", () => {
  assert.equal(shareInSight([], { x: 0, y: 0, zoom: 1 }, PANE), 0);
});
