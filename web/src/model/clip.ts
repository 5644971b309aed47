// Nodes on the clipboard: JSON text that another page, or a text editor, can take as well.

import { readLink, type GraphDocument } from "./document";
import { addNodes, freeId, inOrder, withLinks, type Edit, type NewNode } from "./edit";
import { addFrame, addNote, freeName } from "./edit_ui";
import { asArray, asNumber, asObject, asString, isObject, parseJson, type Json, type JsonObject } from "./json";
import { frameKey, noteKey, type Frame, type Note, type Position } from "./ui";

/** What copied nodes are: a piece of a document, so that it can be read as one too. */
export interface Clip {
  nodes: JsonObject;
  places: ReadonlyMap<string, Position>;
  frames: readonly Frame[];
  notes: readonly Note[];
}

export const DUPLICATE_SHIFT = 32;

/** The text of the given nodes, frames and notes, with the wires among them and the wires that come in. */
export function copyText(document: GraphDocument, ids: ReadonlySet<string>): string | undefined {
  const all = asObject(document.json["nodes"]);
  const nodes: JsonObject = {};
  for (const id of document.nodes.keys()) if (ids.has(id)) nodes[id] = all[id];
  const frames = document.frames.filter((frame) => ids.has(frameKey(frame.id)));
  const notes = document.notes.filter((note) => ids.has(noteKey(note.id)));
  if (Object.keys(nodes).length + frames.length + notes.length === 0) return undefined;
  const places = Object.fromEntries(
    [...document.positions].filter(([id]) => ids.has(id)).map(([id, place]) => [id, { ...place }]),
  );
  const ui: JsonObject = { nodes: places };
  if (frames.length > 0) ui["frames"] = frames.map((frame) => ({ ...frame }));
  if (notes.length > 0) ui["notes"] = notes.map((note) => ({ ...note }));
  return JSON.stringify({ format: 1, nodes, ui }, null, 1);
}

/** Reads copied text; undefined if it is something else. */
export function readClip(text: string): Clip | undefined {
  let json: Json;
  try {
    json = parseJson(text);
  } catch {
    return undefined;
  }
  const root = asObject(json);
  if (root["format"] !== 1 || !isObject(root["nodes"])) return undefined;
  const ui = asObject(root["ui"]);
  const places = new Map<string, Position>();
  Object.keys(root["nodes"]).forEach((id, index) => {
    const place = asObject(asObject(ui["nodes"])[id]);
    places.set(id, { x: asNumber(place["x"]) ?? 0, y: asNumber(place["y"]) ?? index * 120 });
  });
  const box = (item: JsonObject): { id: string } & Position & { width: number; height: number } => ({
    id: asString(item["id"]),
    x: asNumber(item["x"]) ?? 0,
    y: asNumber(item["y"]) ?? 0,
    width: asNumber(item["width"]) ?? 240,
    height: asNumber(item["height"]) ?? 120,
  });
  return {
    nodes: root["nodes"],
    places,
    frames: asArray(ui["frames"])
      .map(asObject)
      .map((item) => ({
        ...box(item),
        title: asString(item["title"]),
        color: asString(item["color"]),
        nodes: asArray(item["nodes"]).map(asString),
      })),
    notes: asArray(ui["notes"])
      .map(asObject)
      .map((item) => ({ ...box(item), text: asString(item["text"]) })),
  };
}

export interface Pasted {
  edit: Edit;
  /** The names the nodes have in the document, and the keys of frames and notes. */
  ids: string[];
}

/** The clip's nodes under free names, `shift` from where they were. Incoming wires stay only if wanted and possible. */
export function paste(document: GraphDocument, clip: Clip, shift: Position, keepIncoming: boolean): Pasted {
  const names = new Map<string, string>();
  const taken = new Set<string>();
  for (const id of Object.keys(clip.nodes)) {
    const name = freeId(document, id, taken);
    taken.add(name);
    names.set(id, name);
  }
  const parameters = new Set(document.parameters.map((parameter) => parameter.name));
  const nodes: NewNode[] = Object.entries(clip.nodes).map(([id, item]) => {
    const wired = withLinks(withoutParameters(asObject(item), parameters), (link) => {
      const name = names.get(link.node);
      if (name !== undefined) return { ...link, node: name };
      return keepIncoming && document.nodes.has(link.node) ? link : undefined;
    });
    const place = clip.places.get(id) ?? { x: 0, y: 0 };
    return {
      id: names.get(id) ?? id,
      type: asString(wired["type"]),
      inputs: asObject(wired["inputs"]),
      bypass: wired["bypass"] === true,
      position: { x: place.x + shift.x, y: place.y + shift.y },
    };
  });
  const edits: Edit[] = [addNodes(nodes)];
  const ids = nodes.map(({ id }) => id);
  const frames = [...document.frames];
  for (const frame of clip.frames) {
    const members = frame.nodes.flatMap((id) => names.get(id) ?? []);
    const made = {
      ...frame,
      id: freeName(frames, "frame"),
      x: frame.x + shift.x,
      y: frame.y + shift.y,
      nodes: members,
    };
    frames.push(made);
    edits.push(addFrame(made));
    ids.push(frameKey(made.id));
  }
  const notes = [...document.notes];
  for (const note of clip.notes) {
    const made = { ...note, id: freeName(notes, "note"), x: note.x + shift.x, y: note.y + shift.y };
    notes.push(made);
    edits.push(addNote(made));
    ids.push(noteKey(made.id));
  }
  return { edit: inOrder(...edits), ids };
}

/** Every node a clip is linked to but does not bring along. */
export function linkedFrom(clip: Clip): Set<string> {
  const found = new Set<string>();
  const visit = (value: Json): void => {
    if (Array.isArray(value)) value.forEach(visit);
    else if (isObject(value) && typeof value["from"] === "string") found.add(readLink(value["from"]).node);
  };
  for (const node of Object.values(clip.nodes)) Object.values(asObject(asObject(node)["inputs"])).forEach(visit);
  for (const id of Object.keys(clip.nodes)) found.delete(id);
  return found;
}

/** A parameter that the document does not have cannot drive anything; the input falls back to its default. */
function withoutParameters(item: JsonObject, known: ReadonlySet<string>): JsonObject {
  const isUnknown = (value: Json): boolean =>
    isObject(value) && typeof value["parameter"] === "string" && !known.has(value["parameter"]);
  const inputs: JsonObject = {};
  for (const [name, value] of Object.entries(asObject(item["inputs"]))) {
    const left = Array.isArray(value) ? value.filter((one) => !isUnknown(one)) : isUnknown(value) ? undefined : value;
    if (left !== undefined && !(Array.isArray(left) && Array.isArray(value) && left.length === 0 && value.length > 0))
      inputs[name] = left;
  }
  return { ...item, inputs };
}
