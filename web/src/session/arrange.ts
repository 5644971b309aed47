// Lining up the selected nodes.

import { moveNodes } from "../model/edit";
import { plural } from "../model/format";
import type { Box, Position } from "../model/ui";
import type { Editor } from "./editor";

/** Puts the left edges of the selected nodes, or their upper ones, on the first of them. */
export function align(editor: Editor, edge: "left" | "top"): void {
  const boxes = selectedBoxes(editor);
  const axis = edge === "left" ? "x" : "y";
  const first = Math.min(...boxes.map(([, box]) => box[axis]));
  move(editor, boxes, 2, "Align", ([, box]) => ({ x: box.x, y: box.y, [axis]: first }));
}

/** Leaves the outer ones of the selected nodes where they are, and the same room between all. */
export function distribute(editor: Editor, way: "across" | "down"): void {
  const [axis, size] = way === "across" ? (["x", "width"] as const) : (["y", "height"] as const);
  const boxes = selectedBoxes(editor).sort(([, a], [, b]) => a[axis] - b[axis]);
  const [first, last] = [boxes[0]?.[1], boxes.at(-1)?.[1]];
  if (!first || !last) return;
  const taken = boxes.reduce((sum, [, box]) => sum + box[size], 0);
  const gap = (last[axis] + last[size] - first[axis] - taken) / Math.max(1, boxes.length - 1);
  let next = first[axis];
  move(editor, boxes, 3, "Distribute", ([, box]) => {
    const place = { x: box.x, y: box.y, [axis]: next };
    next += box[size] + gap;
    return place;
  });
}

type NamedBox = [string, Box];

function selectedBoxes(editor: Editor): NamedBox[] {
  const { selection } = editor.session.store.get();
  return [...(editor.canvas?.boxes() ?? [])].filter(([id]) => selection.has(id));
}

function move(
  editor: Editor,
  boxes: readonly NamedBox[],
  least: number,
  label: string,
  placeOf: (box: NamedBox) => Position,
): void {
  if (boxes.length < least) {
    editor.say(`Select at least ${plural(least, "node")} first.`, "refused");
    return;
  }
  editor.session.edit(label, moveNodes(new Map(boxes.map((box) => [box[0], placeOf(box)]))));
}
