// Nodes on the clipboard: JSON text that another page, or a text editor, can take as well.

import { type Driver, driven, driversFor, parametersOf } from "./clip_parameters";
import type { GraphDocument } from "./document";
import { addNodes, type Edit, freeId, inOrder, type NewNode, withUi } from "./edit";
import { withLinks } from "./edit_links";
import { addParameter } from "./edit_parameters";
import { addFrame, addNote, freeName } from "./edit_ui";
import { broughtGroups, definitionsFor } from "./group_files";
import { asArray, asNumber, asObject, asString, isObject, type Json, type JsonObject, parseJson } from "./json";
import { type ParameterValues, readParameter } from "./parameters";
import { documentWithValues, valuesIn } from "./saved_values";
import { type Frame, frameKey, type Note, noteKey, type Position } from "./ui";

/** Color, label and whether it is collapsed, as `ui` has them of a node. */
export type Look = Partial<Pick<JsonObject, (typeof LOOKS)[number]>>;

const LOOKS = ["color", "label", "collapsed"] as const;

/** What copied nodes are: a piece of a document, so that it can be read as one too. */
export interface Clip {
  nodes: JsonObject;
  /** The groups that the nodes need, and what is noted of their drawing. */
  groups: JsonObject;
  drawnGroups: JsonObject;
  /** Definitions of the parameters that drive the nodes, and those of their values that differ from the defaults. */
  parameters: JsonObject;
  values: ParameterValues;
  places: ReadonlyMap<string, Position>;
  /** Whether the text says of any node where it is. */
  isPlaced: boolean;
  /** What the nodes look like, beside their places. */
  looks: ReadonlyMap<string, Look>;
  frames: readonly Frame[];
  notes: readonly Note[];
}

export const DUPLICATE_SHIFT = 32;

/**
 * The text of the given nodes, frames and notes, with the wires among them, the wires that come in, and the parameters
 * that drive them.
 */
export function copyText(
  document: GraphDocument,
  ids: ReadonlySet<string>,
  values: ParameterValues = {},
): string | undefined {
  const all = asObject(document.scope["nodes"]);
  const nodes: JsonObject = {};
  for (const id of document.nodes.keys()) if (ids.has(id)) nodes[id] = all[id];
  const frames = document.frames.filter((frame) => ids.has(frameKey(frame.id)));
  const notes = document.notes.filter((note) => ids.has(noteKey(note.id)));
  if (Object.keys(nodes).length + frames.length + notes.length === 0) return undefined;
  const places = Object.fromEntries(
    [...document.positions]
      .filter(([id]) => ids.has(id))
      .map(([id, place]) => [id, { ...place, ...lookIn(asObject(asObject(document.scope["ui"])["nodes"])[id]) }]),
  );
  const ui: JsonObject = { nodes: places };
  if (frames.length > 0) ui["frames"] = frames.map((frame) => ({ ...frame }));
  if (notes.length > 0) ui["notes"] = notes.map((note) => ({ ...note }));
  const known = asObject(document.scope["parameters"]);
  const used = [...parametersOf(nodes)].filter((name) => Object.hasOwn(known, name));
  const parameters = Object.fromEntries(used.map((name) => [name, known[name]])) as JsonObject;
  const { groups, notes: drawn } = definitionsFor(
    document,
    Object.values(nodes).map((node) => asString(asObject(node)["type"])),
  );
  const hasGroups = Object.keys(groups).length > 0;
  if (hasGroups) ui["groups"] = drawn;
  const given = Object.fromEntries(Object.entries(values).filter(([name]) => used.includes(name)));
  return JSON.stringify(
    documentWithValues(
      { json: { format: hasGroups ? 2 : 1, parameters, ...(hasGroups && { groups }), nodes, ui } },
      given,
    ),
    null,
    1,
  );
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
  if ((root["format"] !== 1 && root["format"] !== 2) || !isObject(root["nodes"])) return undefined;
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
  const parameters = asObject(root["parameters"]);
  const read = Object.entries(parameters).map(([name, item]) => readParameter(name, asObject(item)));
  return {
    nodes: root["nodes"],
    groups: asObject(root["groups"]),
    drawnGroups: asObject(ui["groups"]),
    parameters,
    values: valuesIn(ui, read),
    places,
    isPlaced: Object.keys(root["nodes"]).some((id) => asNumber(asObject(asObject(ui["nodes"])[id])["x"]) !== undefined),
    looks: new Map(Object.keys(root["nodes"]).map((id) => [id, lookIn(asObject(ui["nodes"])[id])])),
    frames: asArray(ui["frames"])
      .map(asObject)
      .map((item) => ({
        ...box(item),
        title: asString(item["title"]),
        color: asString(item["color"]),
        nodes: asArray(item["nodes"]).map(asString),
        ...(item["collapsed"] === true && { collapsed: true }),
      })),
    notes: asArray(ui["notes"])
      .map(asObject)
      .map((item) => ({ ...box(item), text: asString(item["text"]) })),
  };
}

export interface Pasted {
  edit: Edit;
  /** Values of the parameters that came along. */
  values: ParameterValues;
  /** The names the nodes have in the document, and the keys of frames and notes. */
  ids: string[];
  /** How many incoming wires were left out. */
  cut: number;
  /** How the nodes' parameters became some of the document. */
  drivers: Driver[];
}

/** The clip's nodes under free names, `shift` from where they were. Incoming wires stay only if wanted and possible. */
export function paste(
  document: GraphDocument,
  clip: Clip,
  shift: Position,
  keepIncoming: boolean,
  present: ParameterValues = {},
): Pasted {
  const names = new Map<string, string>();
  const taken = new Set<string>();
  for (const id of Object.keys(clip.nodes)) {
    const name = freeId(document, id, taken);
    taken.add(name);
    names.set(id, name);
  }
  const drivers = driversFor(document, clip, present);
  const groupsBrought = broughtGroups(document, clip.groups, clip.drawnGroups);
  let cut = 0;
  const nodes: NewNode[] = Object.entries(clip.nodes).map(([id, item]) => {
    const wired = withLinks(driven(asObject(item), drivers), (link) => {
      const name = names.get(link.node);
      if (name !== undefined) return { ...link, node: name };
      if (keepIncoming && document.nodes.has(link.node)) return link;
      cut++;
      return undefined;
    });
    const place = clip.places.get(id) ?? { x: 0, y: 0 };
    return {
      id: names.get(id) ?? id,
      type: groupsBrought.typeOf(asString(wired["type"])),
      inputs: asObject(wired["inputs"]),
      bypass: wired["bypass"] === true,
      position: { x: place.x + shift.x, y: place.y + shift.y },
    };
  });
  const brought = drivers.filter((driver) => driver.kind === "brought");
  const edits: Edit[] = [
    groupsBrought.edit,
    ...brought.map(({ name, as }) => addParameter(as, asObject(clip.parameters[name]))),
    addNodes(nodes),
    withLooks(new Map([...clip.looks].map(([id, look]) => [names.get(id) ?? id, look]))),
  ];
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
  const values = Object.fromEntries(
    brought.flatMap(({ name, as }) => (Object.hasOwn(clip.values, name) ? [[as, clip.values[name] ?? 0]] : [])),
  );
  return { edit: inOrder(...edits), values, ids, cut, drivers };
}

function lookIn(item: Json): Look {
  const all = asObject(item);
  return Object.fromEntries(LOOKS.filter((name) => all[name] !== undefined).map((name) => [name, all[name]]));
}

function withLooks(looks: ReadonlyMap<string, Look>): Edit {
  return (document) => {
    if ([...looks.values()].every((look) => Object.keys(look).length === 0)) return document;
    const nodes: JsonObject = { ...asObject(asObject(document.scope["ui"])["nodes"]) };
    for (const [id, look] of looks) nodes[id] = { ...asObject(nodes[id]), ...look };
    return withUi(document, { nodes });
  };
}
