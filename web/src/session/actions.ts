// What a person does to the nodes: each action reads the selection, makes one edit and says what it did.

import type { GraphDocument } from "../model/document";
import { type Edit, inOrder, moveNodes, removeNodes, setBypass } from "../model/edit";
import { addFrame, addNote, changeFrame, freeName, removeFrame, removeNote, setFlag, setMark } from "../model/edit_ui";
import { disconnect, removeAndHeal } from "../model/edit_wires";
import { plural } from "../model/format";
import { layeredLayout, NODE_WIDTH, nodeHeight, nodeWidth, partOf, roomFor } from "../model/layout";
import { boundsOf, freePlace } from "../model/place";
import { type Box, FRAME_COLORS, frameKey, noteKey, type Position } from "../model/ui";
import type { Editor } from "./editor";

const COLORS: readonly string[] = FRAME_COLORS;
const FRAME_PADDING = 24;
const FRAME_HEAD = 30;
const NOTE_SIZE = { width: 200, height: 96 };

/** Removes selected nodes, wires, frames and notes; `heal` joins what the nodes stood between. */
export function remove(editor: Editor, heal: boolean): void {
  const { document, catalogue, selection, areas, view } = editor.session.store.get();
  const wires = (view?.wires ?? []).filter((wire) => editor.store.get().wires.has(wire.id));
  if (!document || !catalogue || selection.size + areas.size + wires.length === 0) return;
  // The last of several at an input first, so that the others keep their numbers.
  const edits: Edit[] = [...wires].sort((a, b) => b.index - a.index).map((wire) => disconnect(wire));
  for (const frame of document.frames) if (areas.has(frameKey(frame.id))) edits.push(removeFrame(frame.id));
  for (const note of document.notes) if (areas.has(noteKey(note.id))) edits.push(removeNote(note.id));
  if (selection.size > 0) edits.push(heal ? removeAndHeal(catalogue, selection) : removeNodes(selection));
  const what =
    selection.size > 0 ? plural(selection.size, "node") : wires.length > 0 ? plural(wires.length, "wire") : "area";
  editor.session.edit(`Delete ${what}`, inOrder(...edits));
  editor.store.set({ wires: new Set() });
  editor.say(heal ? `Deleted ${what} and joined its wires` : `Deleted ${what}`);
}

export function selectAll(editor: Editor): void {
  const { document } = editor.session.store.get();
  if (!document) return;
  const areas = [...document.frames.map(({ id }) => frameKey(id)), ...document.notes.map(({ id }) => noteKey(id))];
  editor.session.select([...document.nodes.keys(), ...areas]);
}

export function toggleBypass(editor: Editor): void {
  const { document, selection } = editor.session.store.get();
  if (!document || selection.size === 0) return;
  const on = ![...selection].every((id) => document.nodes.get(id)?.bypass);
  editor.session.edit(on ? "Bypass" : "Use again", setBypass(selection, on));
  editor.say(on ? `Bypassed ${plural(selection.size, "node")}: the first input passes through` : "In use again");
}

export function toggleFlag(editor: Editor, flag: "preview" | "collapsed", ids?: Iterable<string>): void {
  const { document, selection } = editor.session.store.get();
  const chosen = [...(ids ?? selection)];
  if (!document || chosen.length === 0) return;
  const marked = flag === "preview" ? document.previews : document.collapsed;
  const on = !chosen.every((id) => marked.has(id));
  const words = flag === "preview" ? (["Preview", "Stop the preview"] as const) : (["Collapse", "Expand"] as const);
  editor.session.edit(words[on ? 0 : 1], setFlag(chosen, flag, on));
}

/** Gives the selected nodes the next color; behind the last one comes none. */
export function recolor(editor: Editor): void {
  const { document, selection, selected } = editor.session.store.get();
  if (!document || selection.size === 0) return;
  const present = document.colors.get(selected ?? "") ?? "";
  const next = COLORS[COLORS.indexOf(present) + 1] ?? "";
  editor.session.edit("Color", setMark(selection, "color", next));
  editor.say(next ? `Colored ${next}` : "In the usual color");
}

/** Collapses the selected nodes and frames, or expands them again. */
export function collapse(editor: Editor): void {
  const { document, areas } = editor.session.store.get();
  toggleFlag(editor, "collapsed");
  for (const { id } of document?.frames ?? []) if (areas.has(frameKey(id))) toggleFrame(editor, id);
}

/** Shows a frame's head in place of its nodes, or the nodes again. */
export function toggleFrame(editor: Editor, id: string): void {
  const frame = editor.session.store.get().document?.frames.find((one) => one.id === id);
  if (!frame) return;
  const collapsed = !frame.collapsed;
  editor.session.edit(collapsed ? "Collapse the frame" : "Expand the frame", changeFrame(id, { collapsed }));
  if (collapsed) editor.session.select([frameKey(id)]);
  editor.say(collapsed ? `Collapsed ${frame.title}: ${plural(frame.nodes.length, "node")}` : `Expanded ${frame.title}`);
}

/** A frame around the selected nodes, or an empty one where the pointer is. */
export function frameSelection(editor: Editor): void {
  const { document, selection } = editor.session.store.get();
  if (!document || !editor.canvas) return;
  const boxes = editor.canvas.boxes();
  const around = boundsOf([...selection].flatMap((id) => boxes.get(id) ?? []));
  const corner = editor.canvas.placeAt(editor.canvas.pointer());
  const box = around ?? { ...corner, width: 240, height: 120 };
  const id = freeName(document.frames, "frame");
  const frame = {
    ...{ id, title: "Frame", color: "blue", nodes: [...selection] },
    x: Math.round(box.x - FRAME_PADDING),
    y: Math.round(box.y - FRAME_PADDING - FRAME_HEAD),
    width: Math.round(box.width + 2 * FRAME_PADDING),
    height: Math.round(box.height + 2 * FRAME_PADDING + FRAME_HEAD),
  };
  editor.session.edit("Add frame", addFrame(frame));
  editor.store.set({ renaming: frameKey(id) });
}

export function addNoteHere(editor: Editor): void {
  const { document } = editor.session.store.get();
  if (!document || !editor.canvas) return;
  const at = editor.canvas.placeAt(editor.canvas.pointer());
  const free = freePlace(at, NOTE_SIZE, occupied(editor, document));
  const id = freeName(document.notes, "note");
  editor.session.edit("Add note", addNote({ id, text: "", ...free, ...NOTE_SIZE }));
  editor.store.set({ renaming: noteKey(id) });
}

/** Lays the selected nodes out from left to right where they stand, or all nodes. */
export function layout(editor: Editor): void {
  const { document, view, selection } = editor.session.store.get();
  if (!document || !view || view.nodes.length === 0) return;
  const chosen = selection.size > 1 ? selection : new Set(document.nodes.keys());
  const boxes = editor.canvas?.boxes() ?? new Map<string, Box>();
  const places = layeredLayout(partOf(view, chosen), (node) => boxes.get(node.id)?.height ?? nodeHeight(node));
  const [before, after] = [boundsOf(boxesAt(document.positions, chosen)), boundsOf(boxesAt(places, chosen))];
  if (!before || !after) return;
  const shifted = new Map(
    [...places].map(([id, { x, y }]) => [id, { x: x + before.x - after.x, y: y + before.y - after.y }]),
  );
  editor.session.edit("Lay out", moveNodes(shifted));
  editor.say(`Laid out ${plural(chosen.size, "node")}`);
  if (selection.size < 2) window.setTimeout(() => editor.canvas?.fit(), 50);
}

/** Moves the selected nodes by the given pixels; presses of the same key in a row are one step. */
export function nudge(editor: Editor, x: number, y: number): void {
  const { document, selection } = editor.session.store.get();
  if (!document || selection.size === 0) return;
  const places = new Map<string, Position>();
  for (const id of selection) {
    const at = document.positions.get(id);
    if (at) places.set(id, { x: at.x + x, y: at.y + y });
  }
  editor.session.edit("Move", moveNodes(places), { gesture: "nudge" });
}

/** Everything that stands on the canvas, as boxes to keep clear of. */
export function occupied(editor: Editor, document: GraphDocument): Box[] {
  const { view } = editor.session.store.get();
  const boxes = editor.canvas?.boxes();
  return [...document.positions].map(([id, at]) => {
    const node = view?.byId.get(id);
    // What it is missing may not be said on the node yet.
    const height = Math.max(boxes?.get(id)?.height ?? 0, node ? roomFor(node) : 0);
    const width = boxes?.get(id)?.width ?? (node ? nodeWidth(node) : NODE_WIDTH);
    return { ...at, width, height };
  });
}

function boxesAt(places: ReadonlyMap<string, Position>, ids: ReadonlySet<string>): Box[] {
  return [...places].flatMap(([id, at]) => (ids.has(id) ? [{ ...at, width: NODE_WIDTH, height: 100 }] : []));
}

/** Lets the name of the selected node, frame or note be typed. */
export function rename(editor: Editor): void {
  const { selected, areas } = editor.session.store.get();
  const chosen = selected ?? [...areas][0];
  if (chosen !== undefined) editor.store.set({ renaming: chosen });
}

/** Shows the inputs that stand at their default, or hides them again. */
export function unfoldSelection(editor: Editor): void {
  const { selection } = editor.session.store.get();
  const { unfolded } = editor.store.get();
  editor.unfold(selection, ![...selection].every((id) => unfolded.has(id)));
}
