// Changes of a document, each a pure function: the document given is left as it is, and what a change does not touch
// stays the same object. The JSON is what is changed; everything else is read from it again.

import { withAxesAfter } from "./axis_names";
import type { Catalogue } from "./catalogue";
import { type CameraPlace, type GraphDocument, rewritten, rewrittenWhole, type Triple } from "./document";
import { withLinks, withoutLinks } from "./edit_links";
import { withGroupOutputs } from "./group_outputs";
import { asObject, isObject, type Json, type JsonObject } from "./json";
import type { Position } from "./ui";

export type Edit = (document: GraphDocument) => GraphDocument;

export interface NewNode {
  id: string;
  type: string;
  position: Position;
  inputs?: JsonObject;
  bypass?: boolean;
}

/** One change after the other. */
export function inOrder(...edits: readonly Edit[]): Edit {
  return (document) => edits.reduce((changed, edit) => edit(changed), document);
}

/** A name for a new node that is not taken: the type's own, else with a number behind. */
export function freeId(document: GraphDocument, wanted: string, taken: ReadonlySet<string> = new Set()): string {
  const stem =
    wanted
      .replace(/[^A-Za-z0-9_-]+/g, "_")
      .replace(/^[^A-Za-z]+/, "")
      .slice(0, 56) || "node";
  const isTaken = (id: string): boolean => document.nodes.has(id) || taken.has(id);
  if (!isTaken(stem)) return stem;
  const bare = stem.replace(/_?\d+$/, "") || stem;
  for (let number = 2; ; number++) if (!isTaken(`${bare}_${number}`)) return `${bare}_${number}`;
}

/** A sentence if the name cannot be a node's or a parameter's. */
export function nameProblem(name: string): string | undefined {
  if (/^[A-Za-z][A-Za-z0-9_-]{0,63}$/.test(name)) return undefined;
  return "A name is a letter, then up to 63 letters, digits, _ or -.";
}

export function addNodes(added: readonly NewNode[]): Edit {
  return (document) => {
    const nodes: JsonObject = { ...asObject(document.scope["nodes"]) };
    for (const { id, type, inputs = {}, bypass } of added) nodes[id] = { type, inputs, ...(bypass && { bypass }) };
    const places = new Map(added.map(({ id, position }) => [id, position]));
    return moveNodes(places)(rewritten(document, { nodes }));
  };
}

export function removeNodes(ids: Iterable<string>): Edit {
  const gone = new Set(ids);
  return (document) => {
    const nodes: JsonObject = {};
    for (const [id, node] of Object.entries(asObject(document.scope["nodes"]))) {
      if (!gone.has(id)) nodes[id] = withoutLinks(asObject(node), (link) => gone.has(link.node));
    }
    const left = withGroupOutputs(document, (link) => (gone.has(link.node) ? undefined : link));
    return rewritten(left, { nodes, ...uiWithout(document, gone) });
  };
}

/** Calls a node otherwise, and with it all that refers to it: wires, frames, and with a catalogue the names of its axes. */
export function renameNode(from: string, to: string, catalogue: Catalogue | null = null): Edit {
  return (document) => {
    if (from === to || !document.nodes.has(from) || document.nodes.has(to) || nameProblem(to)) return document;
    const nodes: JsonObject = {};
    for (const [id, node] of Object.entries(asObject(document.scope["nodes"]))) {
      nodes[id === from ? to : id] = withLinks(asObject(node), (link) =>
        link.node === from ? { ...link, node: to } : link,
      );
    }
    const ui = asObject(document.scope["ui"]);
    const places = Object.entries(asObject(ui["nodes"])).map(([id, item]) => [id === from ? to : id, item]);
    const frames = Array.isArray(ui["frames"])
      ? ui["frames"].map((frame) => renamedIn(asObject(frame), from, to))
      : ui["frames"];
    const changed: JsonObject = { ...ui, nodes: Object.fromEntries(places) as JsonObject };
    if (frames !== undefined) changed["frames"] = frames;
    const led = withGroupOutputs(document, (link) => (link.node === from ? { ...link, node: to } : link));
    const told = catalogue ? withAxesAfter(document, nodes, catalogue, from, to) : nodes;
    return rewritten(led, { nodes: told, ui: changed });
  };
}

/** Writes what stands at an input; undefined takes it away, and the default is in force again. */
export function setInput(node: string, input: string, value: Json): Edit {
  return (document) => changeNode(document, node, (item) => withInput(item, input, value));
}

export function setBypass(ids: Iterable<string>, bypass: boolean): Edit {
  return (document) => {
    let changed = document;
    for (const id of ids) {
      changed = changeNode(changed, id, ({ bypass: _, ...item }) => (bypass ? { ...item, bypass } : item));
    }
    return changed;
  };
}

export function moveNodes(places: ReadonlyMap<string, Position>): Edit {
  return (document) => {
    let nodes = asObject(asObject(document.scope["ui"])["nodes"]);
    nodes = { ...nodes };
    for (const [id, { x, y }] of places) {
      if (document.nodes.has(id)) nodes[id] = { ...asObject(nodes[id]), x: Math.round(x), y: Math.round(y) };
    }
    return withUi(document, { nodes });
  };
}

export function setTitle(title: string): Edit {
  return (document) => rewritten(document, { meta: { ...asObject(document.json["meta"]), title } });
}

/** Where the camera stands when the document is opened. */
export function setCamera({ position, target }: CameraPlace): Edit {
  // Ten thousandths of the distance are not seen.
  const distance = Math.hypot(...position.map((value, axis) => value - (target[axis] ?? 0)));
  const decimals = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(distance))));
  const rounded = (place: Triple): Json => place.map((value) => Number(value.toFixed(decimals)));
  const camera = { position: rounded(position), target: rounded(target), up: [0, 0, 1] };
  return (document) => rewritten(document, { meta: { ...asObject(document.json["meta"]), camera } });
}

/** The document with other members below `ui`; members that are undefined go. */
export function withUi(document: GraphDocument, members: JsonObject): GraphDocument {
  const ui: JsonObject = { ...asObject(document.scope["ui"]), ...members };
  for (const [name, value] of Object.entries(ui)) if (value === undefined) delete ui[name];
  return rewritten(document, { ui });
}

/** The same below the `ui` of the whole document, whatever of it is looked at. */
export function withNotes(document: GraphDocument, members: JsonObject): GraphDocument {
  const ui: JsonObject = { ...asObject(document.json["ui"]), ...members };
  for (const [name, value] of Object.entries(ui)) if (value === undefined) delete ui[name];
  return rewrittenWhole(document, { ui });
}

/** The document with one node changed; the same document if there is no such node. */
export function changeNode(
  document: GraphDocument,
  id: string,
  change: (item: JsonObject) => JsonObject,
): GraphDocument {
  const nodes = asObject(document.scope["nodes"]);
  const item = nodes[id];
  if (!isObject(item)) return document;
  return rewritten(document, { nodes: { ...nodes, [id]: change(item) } });
}

export function withInput(item: JsonObject, input: string, value: Json): JsonObject {
  const { [input]: _, ...others } = asObject(item["inputs"]);
  if (value === undefined) return { ...item, inputs: others };
  // An input that is there keeps its place among the others.
  return { ...item, inputs: { ...asObject(item["inputs"]), [input]: value } };
}

function uiWithout(document: GraphDocument, gone: ReadonlySet<string>): JsonObject {
  const ui = asObject(document.scope["ui"]);
  if (Object.keys(ui).length === 0) return {};
  const places = Object.fromEntries(Object.entries(asObject(ui["nodes"])).filter(([id]) => !gone.has(id)));
  const changed: JsonObject = { ...ui, nodes: places };
  if (Array.isArray(ui["frames"])) {
    changed["frames"] = ui["frames"].map((frame) => {
      const item = asObject(frame);
      const members = Array.isArray(item["nodes"]) ? item["nodes"] : [];
      return { ...item, nodes: members.filter((id) => typeof id === "string" && !gone.has(id)) };
    });
  }
  return { ui: changed };
}

function renamedIn(frame: JsonObject, from: string, to: string): JsonObject {
  const members = Array.isArray(frame["nodes"]) ? frame["nodes"] : [];
  return { ...frame, nodes: members.map((id) => (id === from ? to : id)) };
}
