// A node without wires that is dragged over a wire can be put into it.

import { socketsFor } from "../model/edit_wires";
import type { ViewWire } from "../model/graph";
import type { Box, Position } from "../model/ui";
import type { Editor } from "../session/editor";

const SAMPLES = 24;
/** How far inside its box a node must hold the wire. */
const INSET = 8;

/** The wire that the node at `box` would be put into; undefined if there is none it fits. */
export function wireUnder(
  editor: Editor,
  id: string,
  box: Box,
  endsOf: (wire: ViewWire) => [Position, Position] | undefined,
): ViewWire | undefined {
  const { document, catalogue, view } = editor.session.store.get();
  const card = catalogue?.nodes.get(document?.nodes.get(id)?.type ?? "");
  if (!document || !catalogue || !view || !card) return undefined;
  if (view.wires.some((wire) => wire.from === id || wire.to === id)) return undefined;
  return view.wires.find((wire) => {
    const ends = endsOf(wire);
    return ends !== undefined && runsThrough(ends[0], ends[1], box) && socketsFor(document, catalogue, card, wire);
  });
}

/** True if the curve of a wire runs through the box. */
export function runsThrough(from: Position, to: Position, box: Box): boolean {
  const reach = to.x >= from.x ? (to.x - from.x) / 2 : 6.25 * Math.sqrt(from.x - to.x);
  for (let step = 1; step < SAMPLES; step++) {
    const t = step / SAMPLES;
    const [a, b, c, d] = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
    const x = a * from.x + b * (from.x + reach) + c * (to.x - reach) + d * to.x;
    const y = (a + b) * from.y + (c + d) * to.y;
    const isIn =
      x > box.x + INSET && x < box.x + box.width - INSET && y > box.y + INSET && y < box.y + box.height - INSET;
    if (isIn) return true;
  }
  return false;
}
