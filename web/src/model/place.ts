// Free places for new nodes: as near as possible to where they are wanted, over no other node.

import type { Box, Position } from "./ui";

const MARGIN = 16;
const STEP = 24;
const MOST_RINGS = 200;

/** The position nearest to the wanted one at which a box of this size stands clear of the others. */
export function freePlace(wanted: Position, size: { width: number; height: number }, others: readonly Box[]): Position {
  const isFree = (x: number, y: number): boolean =>
    others.every(
      (box) =>
        x + size.width + MARGIN <= box.x ||
        box.x + box.width + MARGIN <= x ||
        y + size.height + MARGIN <= box.y ||
        box.y + box.height + MARGIN <= y,
    );
  const [left, top] = [Math.round(wanted.x), Math.round(wanted.y)];
  if (isFree(left, top)) return { x: left, y: top };
  // Rings of growing size; below and to the right first, as one reads.
  for (let ring = 1; ring < MOST_RINGS; ring++) {
    let best: (Position & { distance: number }) | undefined;
    const consider = (column: number, row: number): void => {
      const [x, y] = [left + column * STEP, top + row * STEP];
      const distance = column * column + row * row + (row < 0 ? 0.5 : 0) + (column < 0 ? 0.4 : 0);
      if ((!best || distance < best.distance) && isFree(x, y)) best = { x, y, distance };
    };
    for (let along = -ring; along <= ring; along++) {
      consider(along, ring);
      consider(ring, along);
      consider(along, -ring);
      consider(-ring, along);
    }
    if (best) return { x: best.x, y: best.y };
  }
  return { x: left, y: top };
}

/** The smallest box around the given ones. */
export function boundsOf(boxes: readonly Box[]): Box | undefined {
  if (boxes.length === 0) return undefined;
  const left = Math.min(...boxes.map((box) => box.x));
  const top = Math.min(...boxes.map((box) => box.y));
  const right = Math.max(...boxes.map((box) => box.x + box.width));
  const bottom = Math.max(...boxes.map((box) => box.y + box.height));
  return { x: left, y: top, width: right - left, height: bottom - top };
}
