// Moving about the graph with the keyboard: from node to node, into a node and out of it.

import type { Box } from "../model/ui";
import type { Editor } from "../session/editor";

/** How much a node off the way counts as farther. */
const OFF_COURSE = 2.2;

/** Selects and focuses the nearest node in a direction; the first node where none is selected. */
export function goTo(editor: Editor, x: number, y: number): void {
  const { selected, document } = editor.session.store.get();
  const boxes = editor.canvas?.boxes();
  if (!boxes || !document) return;
  const from = boxes.get(focusedNode() ?? selected ?? "");
  const next = from ? nearest(boxes, from, x, y) : [...document.nodes.keys()][0];
  if (next === undefined) return;
  editor.session.select([next]);
  editor.canvas?.focusNode(next);
}

/** Puts the focus on the first socket or field of the selected node. */
export function openNode(editor: Editor): void {
  const id = focusedNode() ?? editor.session.store.get().selected;
  if (id === null || id === undefined) return;
  editor.session.select([id]);
  // The button in the head comes before the sockets and is seldom what is wanted.
  const stops = stopsIn(nodeElement(id));
  (stops.find((item) => !item.closest(".node-head")) ?? stops[0])?.focus();
}

/** The places inside a node that take the focus, in reading order. */
export function stopsIn(node: Element | null): HTMLElement[] {
  return [...(node?.querySelectorAll<HTMLElement>("[data-stop]") ?? [])].filter((item) => item.offsetParent !== null);
}

export function nodeElement(id: string): HTMLElement | null {
  return document.querySelector<HTMLElement>(`.react-flow__node[data-id="${CSS.escape(id)}"]`);
}

/** The node that has the focus, or holds what has it. */
function focusedNode(): string | undefined {
  return document.activeElement?.closest<HTMLElement>(".react-flow__node")?.dataset["id"];
}

function nearest(boxes: ReadonlyMap<string, Box>, from: Box, x: number, y: number): string | undefined {
  const middle = (box: Box): [number, number] => [box.x + box.width / 2, box.y + box.height / 2];
  const [fromX, fromY] = middle(from);
  let best: { id: string; cost: number } | undefined;
  for (const [id, box] of boxes) {
    const [dx, dy] = [middle(box)[0] - fromX, middle(box)[1] - fromY];
    const ahead = dx * x + dy * y;
    const aside = Math.abs(dx * y) + Math.abs(dy * x);
    if (ahead <= 1 || box === from) continue;
    const cost = ahead + OFF_COURSE * aside;
    if (!best || cost < best.cost) best = { id, cost };
  }
  return best?.id;
}
