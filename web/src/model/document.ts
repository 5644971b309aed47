// The graph document, formats 1 and 2, as the page reads it. The server is the judge of a document; here only what is needed
// to draw and edit it is read, and its JSON stays what is sent, whatever else it holds.

import { asObject, asString, isNumber, isObject, type Json, type JsonObject } from "./json";
import { type Parameter, type ParameterValues, readParameter } from "./parameters";
import { valuesIn, withoutValues } from "./saved_values";
import { type Inside, type Scope, scopeOf, withScope } from "./scope";
import { readUi, type UiState } from "./ui";

export type { Position } from "./ui";

/** What stands at an input: a literal, a wire from another node's output, or a parameter of the graph. */
export type Source =
  | { kind: "literal"; value: Json }
  | { kind: "link"; node: string; output?: string }
  | { kind: "parameter"; name: string };

export interface GraphNode {
  id: string;
  type: string;
  /** Several sources where the input takes several. */
  inputs: Map<string, Source[]>;
  bypass: boolean;
}

/** Where the page's camera stands when the document is opened, in the graph's coordinates (Z up). */
export interface CameraPlace {
  position: Triple;
  target: Triple;
}

export type Triple = readonly [number, number, number];

export interface GraphDocument extends UiState {
  /** The document itself: this is what is sent and saved, the rest is read from it. */
  json: JsonObject;
  /** The group that is looked at, and those around it, from outside to inside; none for the document itself. */
  inside: readonly Inside[];
  /** Nodes, parameters and notes of what is looked at: those of the document, or of a group as if it were one. */
  scope: Scope;
  title: string;
  description: string;
  /** Null where the document leaves it to the page. */
  camera: CameraPlace | null;
  parameters: Parameter[];
  nodes: Map<string, GraphNode>;
}

/** The document, and the form's values that were kept with it; they are not part of its JSON any more. */
export type ReadResult = { document: GraphDocument; values: ParameterValues } | { error: string };

const NEWEST_FORMAT = 2;
const UNTITLED = "Untitled graph";

/** A document without nodes. */
export function emptyDocument(): GraphDocument {
  return readMembers({
    // What does without groups is for older readers as well.
    format: 1,
    meta: { title: UNTITLED },
    parameters: {},
    nodes: {},
    ui: { nodes: {} },
  });
}

/** True if two documents are evaluated alike: they differ in titles and in what is noted of their drawing at most. */
export function isSameGraph(a: GraphDocument | null, b: GraphDocument | null): boolean {
  return ["nodes", "parameters", "groups"].every((name) => a?.json[name] === b?.json[name]);
}

/** Reads a parsed document. The error is one sentence for the person who opened it. */
export function readDocument(json: Json): ReadResult {
  if (!isObject(json)) return { error: "This is not a graph: a JSON object was expected." };
  const format = json["format"];
  if (!isNumber(format)) return { error: "This is not a graph: it has no format number." };
  if (format > NEWEST_FORMAT) {
    return { error: `This graph has format ${format}; this page reads formats up to ${NEWEST_FORMAT}.` };
  }
  if (!isObject(json["nodes"])) return { error: "This graph has no nodes." };
  const document = readMembers(withoutValues(json));
  return { document, values: valuesIn(json["ui"], document.parameters) };
}

/**
 * The document with other members; nodes, parameters and notes are those of what is looked at. What stays the same object
 * in the JSON stays the same object in what is read of it.
 */
export function rewritten(document: GraphDocument, members: JsonObject): GraphDocument {
  return readMembers(withScope(document.json, document.inside, members), document);
}

/** The document with other members, whatever of it is looked at. */
export function rewrittenWhole(document: GraphDocument, members: JsonObject): GraphDocument {
  return readMembers({ ...document.json, ...members }, document);
}

/** The same document, looked at inside of a group; outside of all without any. */
export function lookedAt(document: GraphDocument, inside: readonly Inside[]): GraphDocument {
  if (document.inside.length === 0 && inside.length === 0) return document;
  const known = inside.length === 0 ? wholes.get(document) : undefined;
  const read = known ?? readMembers(document.json, undefined, inside);
  if (inside.length === 0) wholes.set(document, read);
  return read;
}

/** Documents that are looked at inside of a group, looked at as a whole. */
const wholes = new WeakMap<GraphDocument, GraphDocument>();

function readMembers(json: JsonObject, before?: GraphDocument, inside = before?.inside ?? []): GraphDocument {
  const meta = asObject(json["meta"]);
  const scope = scopeOf(json, inside);
  const old = before?.scope;
  const nodes =
    before && old?.["nodes"] === scope["nodes"] ? before.nodes : readNodes(asObject(scope["nodes"]), before);
  const isSameUi = before !== undefined && old?.["ui"] === scope["ui"] && before.nodes.size === nodes.size;
  return {
    ...(isSameUi ? uiOf(before) : readUi(asObject(scope["ui"]), new Set(nodes.keys()))),
    json,
    inside,
    scope,
    title: asString(meta["title"]) || UNTITLED,
    description: asString(meta["description"]),
    camera: readCamera(asObject(meta["camera"])),
    parameters:
      before && old?.["parameters"] === scope["parameters"]
        ? before.parameters
        : Object.entries(asObject(scope["parameters"])).map(([name, item]) => readParameter(name, asObject(item))),
    nodes,
  };
}

function uiOf({ positions, previews, collapsed, colors, labels, frames, notes }: UiState): UiState {
  return { positions, previews, collapsed, colors, labels, frames, notes };
}

function readNodes(items: JsonObject, before?: GraphDocument): Map<string, GraphNode> {
  const known = asObject(before?.scope["nodes"]);
  const nodes = new Map<string, GraphNode>();
  for (const [id, item] of Object.entries(items)) {
    const same = known[id] === item ? before?.nodes.get(id) : undefined;
    nodes.set(id, same ?? readNode(id, asObject(item)));
  }
  return nodes;
}

/** A camera that looks nowhere, or not from a place in space, is none. Its `up` is not read: up is Z in every view. */
export function readCamera(item: JsonObject): CameraPlace | null {
  const [position, target] = [readTriple(item["position"]), readTriple(item["target"])];
  if (!position || !target || position.every((value, axis) => value === target[axis])) return null;
  return { position, target };
}

function readTriple(json: Json | undefined): Triple | undefined {
  const [x, y, z, ...more] = Array.isArray(json) ? json : [];
  return isNumber(x) && isNumber(y) && isNumber(z) && more.length === 0 ? [x, y, z] : undefined;
}

/** Splits "node.output" at its first dot; the output is left out where the node has one only. */
export function readLink(text: string): { node: string; output?: string } {
  const dot = text.indexOf(".");
  return dot < 0 ? { node: text } : { node: text.slice(0, dot), output: text.slice(dot + 1) };
}

function readNode(id: string, item: JsonObject): GraphNode {
  const inputs = new Map<string, Source[]>();
  for (const [name, value] of Object.entries(asObject(item["inputs"]))) inputs.set(name, readSources(value));
  return { id, type: asString(item["type"]), inputs, bypass: item["bypass"] === true };
}

/** What stands at an input, as written in the document. */
export function readSources(value: Json): Source[] {
  // A list is several sources only if a link or a parameter is among them; otherwise it is one literal, as [x, y, z].
  if (Array.isArray(value) && value.some(isReference)) return value.map(readSource);
  return [readSource(value)];
}

function isReference(value: Json): boolean {
  return isObject(value) && (typeof value["from"] === "string" || typeof value["parameter"] === "string");
}

function readSource(value: Json): Source {
  if (isObject(value)) {
    if (typeof value["from"] === "string") return { kind: "link", ...readLink(value["from"]) };
    if (typeof value["parameter"] === "string") return { kind: "parameter", name: value["parameter"] };
  }
  return { kind: "literal", value };
}
