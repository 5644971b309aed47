// What of a graph is in sight when it opens. A graph that would have to shrink until its titles cannot be read shows its
// end instead, where the model is made; the map tells where the rest is.

import type { Box } from "../model/ui";

/** The smallest zoom at which titles are easily read. */
export const READABLE_ZOOM = 0.68;
/** Share of the pane that is left free on each side. */
export const OPENING_PADDING = 0.06;

/**
 * The nodes to fit into a pane of the given size in pixels: all of them where that stays readable, else those around
 * `end` that have room. Undefined means all. A pane without a size shows all.
 */
export function openingNodes(
  boxes: ReadonlyMap<string, Box>,
  end: string | undefined,
  pane: { width: number; height: number },
): string[] | undefined {
  if (boxes.size === 0 || pane.width <= 0 || pane.height <= 0) return undefined;
  const share = (1 - 2 * OPENING_PADDING) / READABLE_ZOOM;
  const [width, height] = [pane.width * share, pane.height * share];
  const fits = (box: Box): boolean => box.width <= width && box.height <= height;
  if (fits([...boxes.values()].reduce(around))) return undefined;
  const entries = [...boxes];
  const last = entries.find(([id]) => id === end) ?? entries.reduce((a, b) => (rightOf(b[1]) > rightOf(a[1]) ? b : a));
  // From the end backwards; in one column the nodes nearest to its height first.
  const level = middleOf(last[1]);
  const ordered = entries
    .filter((entry) => entry !== last)
    .sort(([, a], [, b]) => b.x - a.x || Math.abs(middleOf(a) - level) - Math.abs(middleOf(b) - level));
  const chosen = [last[0]];
  let sight = last[1];
  for (const [id, box] of ordered) {
    const larger = around(sight, box);
    if (!fits(larger)) continue;
    chosen.push(id);
    sight = larger;
  }
  return chosen;
}

/** The smallest box around two. */
function around(a: Box, b: Box): Box {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)];
  const [right, low] = [Math.max(rightOf(a), rightOf(b)), Math.max(a.y + a.height, b.y + b.height)];
  return { x, y, width: right - x, height: low - y };
}

function rightOf(box: Box): number {
  return box.x + box.width;
}

function middleOf(box: Box): number {
  return box.y + box.height / 2;
}
