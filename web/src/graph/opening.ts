// What of a graph is in sight when it opens. A graph that would have to shrink until it cannot be read with ease shows the
// nodes that the form drives instead, or its end, where the model is made; the map tells where the rest is.

import type { Box } from "../model/ui";

/** The smallest zoom at which a graph opens; the largest is 1. */
export const READABLE_ZOOM = 0.9;
/** At this zoom a thousand nodes fit into a pane. */
export const LEAST_ZOOM = 0.03;
/** Share of the pane that is left free on each side. */
export const OPENING_PADDING = 0.06;

/**
 * The nodes to fit into a pane of the given size in pixels: all of them where that stays readable, else those in `wanted`
 * that have room, and others around them; without any, those around `end`. Undefined means all. A pane without a size
 * shows all.
 */
export function openingNodes(
  boxes: ReadonlyMap<string, Box>,
  end: string | undefined,
  wanted: ReadonlySet<string>,
  pane: { width: number; height: number },
): string[] | undefined {
  if (boxes.size === 0 || pane.width <= 0 || pane.height <= 0) return undefined;
  const share = (1 - 2 * OPENING_PADDING) / READABLE_ZOOM;
  const [width, height] = [pane.width * share, pane.height * share];
  const fits = (box: Box): boolean => box.width <= width && box.height <= height;
  if (fits([...boxes.values()].reduce(around))) return undefined;
  const entries = [...boxes];
  const rightmost = (among: typeof entries): (typeof entries)[number] | undefined =>
    among.length > 0 ? among.reduce((a, b) => (rightOf(b[1]) > rightOf(a[1]) ? b : a)) : undefined;
  const last =
    rightmost(entries.filter(([id]) => wanted.has(id))) ?? entries.find(([id]) => id === end) ?? rightmost(entries);
  if (!last) return undefined;
  // The wanted ones first, from the end backwards; in one column the nodes nearest to its height first.
  const level = middleOf(last[1]);
  const ordered = entries
    .filter((entry) => entry !== last)
    .sort(
      ([first, a], [second, b]) =>
        Number(wanted.has(second)) - Number(wanted.has(first)) ||
        Math.abs(a.x - last[1].x) - Math.abs(b.x - last[1].x) ||
        Math.abs(middleOf(a) - level) - Math.abs(middleOf(b) - level),
    );
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
