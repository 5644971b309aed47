// A group of the document as if it were a document: its nodes, its inputs as parameters, and what is noted of its
// drawing. So everything that edits documents edits groups.

import { asArray, asObject, asString, isObject, type Json, type JsonObject } from "./json";

/** A step into a group: the instance that was entered, and the group that it stands for. */
export interface Inside {
  id: string;
  group: string;
}

/** Those of `nodes`, `parameters` and `ui` that are looked at. */
export type Scope = Readonly<JsonObject>;

/** What the type of an instance begins with. */
export const GROUP_PREFIX = "group/";

/** The group that a node type stands for; undefined for any other type. */
export function groupNamed(type: string): string | undefined {
  return type.startsWith(GROUP_PREFIX) ? type.slice(GROUP_PREFIX.length) : undefined;
}

export function scopeOf(json: JsonObject, inside: readonly Inside[]): Scope {
  const name = inside.at(-1)?.group;
  if (name === undefined) return json;
  const group = asObject(asObject(json["groups"])[name]);
  return {
    nodes: nodesAs(asObject(group["nodes"]), "input", "parameter"),
    parameters: parametersOf(asArray(group["inputs"])),
    ui: asObject(asObject(json["ui"])["groups"])[name],
  };
}

/** The document with other members of what is looked at. Anything but nodes, parameters and ui is the document's. */
export function withScope(json: JsonObject, inside: readonly Inside[], members: JsonObject): JsonObject {
  const name = inside.at(-1)?.group;
  if (name === undefined) return { ...json, ...members };
  const { nodes, parameters, ui, ...others } = members;
  const changed: JsonObject = { ...json, ...others };
  const group = { ...asObject(asObject(json["groups"])[name]) };
  if (isObject(nodes)) group["nodes"] = nodesAs(nodes, "parameter", "input");
  if (isObject(parameters)) group["inputs"] = inputsOf(parameters, asArray(group["inputs"]));
  if (nodes !== undefined || parameters !== undefined)
    changed["groups"] = { ...asObject(json["groups"]), [name]: group };
  if (ui !== undefined) {
    const all = asObject(json["ui"]);
    changed["ui"] = { ...all, groups: { ...asObject(all["groups"]), [name]: ui } };
  }
  return changed;
}

/** What a path of ids begins with in the names that the server gives to nodes within groups: "ring/". */
export function prefixOf(inside: readonly Inside[]): string {
  return inside.map(({ id }) => `${id}/`).join("");
}

const changedNodes = { input: new WeakMap<object, Json>(), parameter: new WeakMap<object, Json>() };

/** Nodes whose references are called otherwise. The same object for the same object, so that what is unchanged is known. */
function nodesAs(nodes: JsonObject, from: "input" | "parameter", to: "input" | "parameter"): JsonObject {
  const known = changedNodes[from];
  const kept = known.get(nodes);
  if (kept !== undefined) return kept as JsonObject;
  const renamed = (value: Json): Json => {
    if (Array.isArray(value)) return value.map(renamed);
    return isObject(value) && typeof value[from] === "string" ? { [to]: value[from] } : value;
  };
  const changed: JsonObject = {};
  for (const [id, item] of Object.entries(nodes)) {
    const node = asObject(item);
    let made = known.get(node);
    if (made === undefined) {
      const inputs = Object.entries(asObject(node["inputs"])).map(([name, value]) => [name, renamed(value)]);
      made = node["inputs"] === undefined ? { ...node } : { ...node, inputs: Object.fromEntries(inputs) as JsonObject };
      remember(node, made, from, to);
    }
    changed[id] = made;
  }
  remember(nodes, changed, from, to);
  return changed;
}

function remember(before: JsonObject, after: JsonObject, from: "input" | "parameter", to: "input" | "parameter"): void {
  changedNodes[from].set(before, after);
  changedNodes[to].set(after, before);
}

const readInputs = new WeakMap<object, JsonObject>();

/** The inputs of a group by name, as parameters that a form can show; those without a default come by wires only. */
function parametersOf(inputs: Json[]): JsonObject {
  const known = readInputs.get(inputs);
  if (known) return known;
  const parameters = Object.fromEntries(
    inputs
      .map(asObject)
      .map(({ name, ...input }) => [
        asString(name),
        { ...input, type: typeFor(input["default"]), label: asString(input["label"]) || asString(name) },
      ]),
  ) as JsonObject;
  readInputs.set(inputs, parameters);
  return parameters;
}

/** A group's inputs for parameters: what an input has and a parameter has not is kept. */
function inputsOf(parameters: JsonObject, before: readonly Json[]): Json[] {
  return Object.entries(parameters).map(([name, item]) => {
    const old = before.map(asObject).find((input) => input["name"] === name);
    const { default: initial, label, description } = asObject(item);
    const input: JsonObject = { ...old, name };
    if (initial !== undefined) input["default"] = initial;
    if (asString(label) && label !== name) input["label"] = label;
    else delete input["label"];
    if (asString(description)) input["description"] = description;
    return input;
  });
}

function typeFor(value: Json): string {
  if (value === undefined) return "link";
  if (typeof value === "boolean") return "boolean";
  if (typeof value === "string") return "text";
  return Array.isArray(value) ? "vector" : "number";
}

/** The node that a path begins with. */
export function firstOf(path: string): string {
  return path.split("/")[0] ?? "";
}
