import assert from "node:assert/strict";
import { test } from "node:test";
import { OPENING_PADDING, openingNodes, READABLE_ZOOM } from "../src/graph/opening";
import type { Box } from "../src/model/ui";

const PANE = { width: 700, height: 700 };

/** Columns of nodes 200 wide and 120 high, 262 apart, from left to right; named by column and row. */
function columns(...sizes: number[]): Map<string, Box> {
  const boxes = new Map<string, Box>();
  sizes.forEach((size, column) => {
    for (let row = 0; row < size; row++) {
      boxes.set(`${column}.${row}`, { x: 262 * column, y: 150 * (row - size / 2), width: 200, height: 120 });
    }
  });
  return boxes;
}

const NONE: ReadonlySet<string> = new Set();

/** The zoom at which the chosen nodes fill the pane. */
function zoomOf(boxes: Map<string, Box>, ids: readonly string[]): number {
  const chosen = ids.map((id) => boxes.get(id)).filter((box) => box !== undefined);
  const width = Math.max(...chosen.map((box) => box.x + box.width)) - Math.min(...chosen.map((box) => box.x));
  const height = Math.max(...chosen.map((box) => box.y + box.height)) - Math.min(...chosen.map((box) => box.y));
  return (1 - 2 * OPENING_PADDING) * Math.min(PANE.width / width, PANE.height / height);
}

test("a graph that is readable as a whole opens as a whole", () => {
  assert.equal(openingNodes(columns(2, 1), "1.0", NONE, PANE), undefined);
  assert.equal(openingNodes(new Map(), undefined, NONE, PANE), undefined);
  assert.equal(openingNodes(columns(9, 9, 9, 9, 9, 9), "5.0", NONE, { width: 0, height: 0 }), undefined);
});

test("a wide graph opens at its end, at a zoom at which it can be read", () => {
  const boxes = columns(1, 4, 3, 2, 1, 1, 1);
  const seen = openingNodes(boxes, "6.0", NONE, PANE) ?? [];
  assert.deepEqual(seen, ["6.0", "5.0"]);
  assert.ok(zoomOf(boxes, seen) >= READABLE_ZOOM);
});

test("of a tall graph the nodes beside the end are in sight", () => {
  const boxes = columns(20, 20, 1);
  const seen = openingNodes(boxes, "2.0", NONE, PANE) ?? [];
  assert.equal(seen[0], "2.0");
  assert.ok(seen.includes("1.10") && !seen.includes("1.0") && !seen.includes("1.19"));
  assert.ok(zoomOf(boxes, seen) >= READABLE_ZOOM);
});

test("a graph opens at the nodes that its form drives", () => {
  const boxes = columns(1, 4, 3, 2, 1, 1, 1);
  const seen = openingNodes(boxes, "6.0", new Set(["1.1", "1.2", "2.1"]), PANE) ?? [];
  assert.deepEqual(seen.slice(0, 3), ["2.1", "1.1", "1.2"]);
  assert.ok(!seen.includes("6.0"));
  assert.ok(zoomOf(boxes, seen) >= READABLE_ZOOM);
});

test("a graph opens where the most of what its form drives is together", () => {
  const boxes = columns(1, 4, 3, 2, 1, 1, 1);
  const seen = openingNodes(boxes, "6.0", new Set(["1.1", "2.1", "5.0"]), PANE) ?? [];
  assert.deepEqual(seen.slice(0, 2), ["2.1", "1.1"]);
  const even = openingNodes(boxes, "6.0", new Set(["1.1", "5.0"]), PANE) ?? [];
  assert.equal(even[0], "5.0");
});

test("a graph without an output opens at its rightmost node", () => {
  assert.equal(openingNodes(columns(1, 1, 1, 1, 1, 1), undefined, NONE, PANE)?.[0], "5.0");
});

test("an end that is wider than the pane is still what is shown", () => {
  const boxes = columns(1, 1, 1);
  assert.deepEqual(openingNodes(boxes, "1.0", NONE, { width: 50, height: 50 }), ["1.0"]);
});
