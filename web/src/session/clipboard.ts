// Copying and pasting nodes, frames and notes, as text that another page can take as well.

import { type Clip, copyText, DUPLICATE_SHIFT, type Pasted, paste, readClip } from "../model/clip";
import { withPlaces } from "../model/clip_layout";
import type { GraphDocument } from "../model/document";
import { literalText, plural } from "../model/format";
import { viewGraph } from "../model/graph";
import { wouldHoldItself } from "../model/group_files";
import type { Json } from "../model/json";
import { NODE_WIDTH, roomFor } from "../model/layout";
import { boundsOf, freePlace } from "../model/place";
import type { Box, Position } from "../model/ui";
import { occupied, remove } from "./actions";
import type { Editor } from "./editor";
import { HOLDS_ITSELF } from "./grouping";

/** The selected nodes, frames and notes as text; undefined if nothing is selected. */
export function selectionText(editor: Editor): string | undefined {
  const { document, values, selection, areas } = editor.session.store.get();
  return document ? copyText(document, new Set([...selection, ...areas]), values) : undefined;
}

export async function copy(editor: Editor): Promise<boolean> {
  const text = selectionText(editor);
  if (text === undefined) return false;
  try {
    await navigator.clipboard.writeText(text);
    editor.say(`Copied ${plural(editor.session.store.get().selection.size, "node")}`);
    return true;
  } catch {
    editor.say("The browser did not allow copying.", "refused");
    return false;
  }
}

export async function cut(editor: Editor): Promise<void> {
  if (await copy(editor)) remove(editor, false);
}

/** Pastes what is on the clipboard where the pointer is. */
export async function pasteClipboard(editor: Editor, keepIncoming: boolean): Promise<void> {
  let text = "";
  try {
    text = await navigator.clipboard.readText();
  } catch {
    editor.say("The browser did not allow pasting.", "refused");
    return;
  }
  pasteText(editor, text, keepIncoming);
}

export function pasteText(editor: Editor, text: string, keepIncoming: boolean): void {
  const { document, catalogue } = editor.session.store.get();
  const read = readClip(text);
  if (!document || !read) {
    editor.say("There are no nodes on the clipboard.", "refused");
    return;
  }
  const clip = catalogue ? withPlaces(read, document, catalogue) : read;
  const corner = boundsOf(clipBoxes(clip)) ?? { x: 0, y: 0, width: 0, height: 0 };
  const canvas = editor.canvas;
  const wanted = canvas ? canvas.placeAt(canvas.pointer()) : corner;
  place(editor, document, clip, { x: wanted.x - corner.x, y: wanted.y - corner.y }, keepIncoming, "Paste");
}

/** A second copy beside the selection; it keeps the wires that come in. */
export function duplicate(editor: Editor): void {
  const { document } = editor.session.store.get();
  const clip = readClip(selectionText(editor) ?? "");
  if (document && clip) place(editor, document, clip, { x: DUPLICATE_SHIFT, y: DUPLICATE_SHIFT }, true, "Duplicate");
}

function place(
  editor: Editor,
  document: GraphDocument,
  clip: Clip,
  shift: Position,
  keepIncoming: boolean,
  label: string,
): void {
  const { values } = editor.session.store.get();
  const trial = paste(document, clip, shift, keepIncoming, values).edit(document);
  const types = [...trial.nodes.values()].flatMap(({ id, type }) => (document.nodes.has(id) ? [] : [type]));
  if (wouldHoldItself(trial, types)) {
    editor.say(HOLDS_ITSELF, "refused");
    return;
  }
  const added = roomOf(editor, trial, document);
  const bounds = boundsOf([...added, ...shifted([...clip.frames, ...clip.notes], shift)]);
  const free = bounds && freePlace(bounds, bounds, occupied(editor, document));
  const moved = bounds && free ? { x: shift.x + free.x - bounds.x, y: shift.y + free.y - bounds.y } : shift;
  const pasted = paste(document, clip, moved, keepIncoming, values);
  const { edit, ids } = pasted;
  editor.session.edit(`${label} ${plural(ids.length, "node")}`, edit, { values: pasted.values });
  editor.session.select(ids);
  editor.say(pastedText(pasted));
}

/** What came, what came along, and what did not. */
export function pastedText({ ids, cut, drivers }: Pasted): string {
  const parts = [`Added ${plural(ids.length, "node")}`];
  const brought = drivers.flatMap((driver) => (driver.kind === "brought" ? [driver.label] : []));
  if (brought.length > 0)
    parts.push(`with the ${brought.length > 1 ? "parameters" : "parameter"} ${brought.join(", ")}`);
  for (const driver of drivers) {
    if (driver.kind === "present" && driver.value !== undefined) {
      parts.push(`${driver.label} is ${literalText(driver.value as Json)} in this graph`);
    }
    if (driver.kind === "missing") {
      parts.push(`${driver.inputs.join(", ")} lost the parameter ${driver.name}, which this graph does not have`);
    }
  }
  if (cut > 0) parts.push(`${plural(cut, "incoming wire")} left out`);
  return parts.join("; ");
}

/** Boxes of the nodes that are in `after` and not in `before`, as high as they will be. */
function roomOf(editor: Editor, after: GraphDocument, before: GraphDocument): Box[] {
  const { catalogue } = editor.session.store.get();
  if (!catalogue) return [];
  return viewGraph(after, catalogue)
    .nodes.filter(({ id }) => !before.nodes.has(id))
    .map((node) => ({ ...(after.positions.get(node.id) ?? { x: 0, y: 0 }), width: NODE_WIDTH, height: roomFor(node) }));
}

function shifted(boxes: readonly Box[], { x, y }: Position): Box[] {
  return boxes.map((box) => ({ ...box, x: box.x + x, y: box.y + y }));
}

function clipBoxes(clip: Clip): Box[] {
  const nodes = [...clip.places.values()].map((at) => ({ ...at, width: NODE_WIDTH, height: 140 }));
  return [...nodes, ...clip.frames, ...clip.notes];
}
