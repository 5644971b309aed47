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
 * The nodes to fit into a pane of the given size in pixels: all of them where that stays readable, else as many in
 * `wanted` as have room together, and others around them; without any, those around `end`. Undefined means all. A pane
 * without a size shows all.
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
  const candidates = entries.filter(([id]) => wanted.has(id));
  if (candidates.length === 0) {
    const last = entries.find(([id]) => id === end) ?? entries.reduce(righter);
    return nodesAround(last, entries, wanted, fits);
  }
  // Where the most of the wanted ones are together; among such places the last.
  const count = (ids: string[]): number => ids.filter((id) => wanted.has(id)).length;
  return candidates
    .sort((first, second) => rightOf(second[1]) - rightOf(first[1]))
    .map((start) => nodesAround(start, entries, wanted, fits))
    .reduce((best, ids) => (count(ids) > count(best) ? ids : best));
}

type Entry = [id: string, box: Box];

/** Those in sight together with one: the wanted first, from it outwards; in one column the nodes nearest to its height first. */
function nodesAround(
  start: Entry,
  entries: Entry[],
  wanted: ReadonlySet<string>,
  fits: (box: Box) => boolean,
): string[] {
  const level = middleOf(start[1]);
  const ordered = entries
    .filter((entry) => entry !== start)
    .sort(
      ([first, a], [second, b]) =>
        Number(wanted.has(second)) - Number(wanted.has(first)) ||
        Math.abs(a.x - start[1].x) - Math.abs(b.x - start[1].x) ||
        Math.abs(middleOf(a) - level) - Math.abs(middleOf(b) - level),
    );
  const chosen = [start[0]];
  let sight = start[1];
  for (const [id, box] of ordered) {
    const larger = around(sight, box);
    if (!fits(larger)) continue;
    chosen.push(id);
    sight = larger;
  }
  return chosen;
}

function righter(a: Entry, b: Entry): Entry {
  return rightOf(b[1]) > rightOf(a[1]) ? b : a;
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
