// Making groups of nodes and taking them apart, as changes of the document.

import { withAxisNames } from "./axis_names";
import type { Catalogue, NodeCard } from "./catalogue";
import { type GraphDocument, readLink, rewritten, rewrittenWhole } from "./document";
import { addNodes, type Edit, freeId, inOrder, removeNodes } from "./edit";
import { type Link, linkText, withLinks } from "./edit_links";
import { drawingOf, middleOf, moved, placesIn, withDrawing } from "./group_drawing";
import { withDefinitions } from "./group_files";
import { withGroupOutputs } from "./group_outputs";
import { asArray, asObject, asString, isObject, type Json, type JsonObject } from "./json";
import { firstOf, GROUP_PREFIX, groupNamed } from "./scope";

export interface MadeGroup {
  edit: Edit;
  /** What the group and the node in place of the chosen ones are called. */
  name: string;
  id: string;
  inputs: number;
  outputs: number;
}

/** A name for a new group that is not taken. */
export function freeGroupName(document: GraphDocument, wanted = "group"): string {
  const taken = asObject(document.json["groups"]);
  for (let number = 1; ; number++) {
    const name = number === 1 ? wanted : `${wanted}${number}`;
    if (!Object.hasOwn(taken, name)) return name;
  }
}

/**
 * Puts nodes into a group, and an instance in their place. What comes in by wires or from parameters becomes an input,
 * what goes out an output; without any, the outputs of the last nodes.
 */
export function makeGroup(document: GraphDocument, catalogue: Catalogue, ids: ReadonlySet<string>): MadeGroup {
  const name = freeGroupName(document);
  const id = freeId(document, name);
  const all = asObject(document.scope["nodes"]);
  const [inputs, given] = [new Map<string, string>(), {} as JsonObject];
  const outputs = new Map<string, string>();
  const taken = new Set<string>();
  const free = (wanted: string): string => {
    let made = wanted;
    for (let number = 2; taken.has(made); number++) made = `${wanted}_${number}`;
    taken.add(made);
    return made;
  };
  // A link may name the only output, or leave it out: both mean one wire.
  const outputText = (text: string): string => {
    const { node, output } = readLink(text);
    return linkText({ node, output: output ?? cardOf(document, catalogue, node)?.outputs[0]?.name });
  };
  const nodes: JsonObject = {};
  for (const [own, item] of Object.entries(all)) {
    if (!ids.has(own)) continue;
    nodes[own] = withValues(asObject(item), (value, port) => {
      const text = isObject(value) ? asString(value["from"]) : "";
      const parameter = isObject(value) ? asString(value["parameter"]) : "";
      if (!parameter && (!text || ids.has(text.split(".")[0] ?? ""))) return value;
      const key = text ? `from ${outputText(text)}` : `parameter ${parameter}`;
      const input = inputs.get(key) ?? free(parameter || port);
      inputs.set(key, input);
      given[input] = value;
      return { input };
    });
  }
  taken.clear();
  const outputOf = ({ node, output }: { node: string; output?: string }): string => {
    const card = cardOf(document, catalogue, node);
    const port = output ?? card?.outputs[0]?.name ?? "value";
    const key = linkText({ node, output: (card?.outputs.length ?? 1) > 1 ? port : undefined });
    const made = outputs.get(key) ?? free(port);
    outputs.set(key, made);
    return made;
  };
  const led = (link: Link): Link => (ids.has(link.node) ? { node: id, output: outputOf(link) } : link);
  const rest: JsonObject = {};
  for (const [own, item] of Object.entries(all)) {
    if (ids.has(own)) continue;
    const linked = withLinks(asObject(item), led);
    rest[own] = withAxisNames(linked, catalogue, (axis) => (ids.has(firstOf(axis)) ? `${id}/${axis}` : axis));
  }
  // What leaves the group around leaves this one first.
  const around = withGroupOutputs(document, led);
  if (outputs.size === 0) for (const node of lastOf(document, ids)) outputOf({ node });
  const group: JsonObject = {
    inputs: [...inputs.values()].map((input) => ({ name: input })),
    outputs: [...outputs].map(([from, output]) => ({ name: output, from })),
    nodes,
  };
  const places = [...document.positions].filter(([own]) => ids.has(own));
  const at = middleOf(places.map(([, place]) => place));
  const { ui, edit: framesGone } = drawingOf(document, ids);
  const edit = inOrder(
    () => around,
    framesGone,
    removeNodes(ids),
    withDefinitions({ [name]: group }, { [name]: ui }),
    (changed) => replaceNodes(changed, rest),
    addNodes([{ id, type: GROUP_PREFIX + name, position: at, inputs: given }]),
  );
  return { edit, name, id, inputs: inputs.size, outputs: outputs.size };
}

/** Puts the nodes of a group in the place of its instance. A group that nothing uses any more goes. */
export function ungroup(document: GraphDocument, catalogue: Catalogue, id: string): { edit: Edit; ids: string[] } {
  const name = groupNamed(document.nodes.get(id)?.type ?? "") ?? "";
  const group = asObject(asObject(document.json["groups"])[name]);
  const inner = asObject(group["nodes"]);
  const given = asObject(asObject(asObject(document.scope["nodes"])[id])["inputs"]);
  const names = new Map<string, string>();
  for (const own of Object.keys(inner)) names.set(own, freeId(document, own, new Set(names.values())));
  const renamed = (own: string): string => names.get(own) ?? own;
  // Axes are called after paths that begin with a node.
  const renamedAxis = (axis: string): string => renamed(firstOf(axis)) + axis.slice(firstOf(axis).length);
  const defaults = new Map(
    asArray(group["inputs"])
      .map(asObject)
      .map((input) => [input["name"], input["default"]]),
  );
  const inputOf = (value: Json): string | undefined =>
    isObject(value) && typeof value["input"] === "string" ? value["input"] : undefined;
  const withDefault = (value: Json): Json => {
    const input = inputOf(value);
    return input === undefined || Object.hasOwn(given, input) ? value : defaults.get(input);
  };
  const withGiven = (value: Json): Json => {
    const input = inputOf(value);
    return input === undefined ? value : given[input];
  };
  const drawn = asObject(asObject(asObject(document.json["ui"])["groups"])[name]);
  const places = placesIn(drawn);
  const middle = middleOf([...places.values()]);
  const at = document.positions.get(id) ?? middle;
  const shift = { x: at.x - middle.x, y: at.y - middle.y };
  const added = Object.entries(inner).map(([own, item], index) => {
    const linked = withLinks(asObject(item), (link) => ({ ...link, node: renamed(link.node) }));
    // What the group itself says of axes is said of its nodes; what the instance is given comes from around it.
    const node = withValues(withAxisNames(withValues(linked, withDefault), catalogue, renamedAxis), withGiven);
    const place = places.get(own);
    return {
      id: renamed(own),
      type: asString(node["type"]),
      inputs: asObject(node["inputs"]),
      bypass: node["bypass"] === true,
      position: place ? moved(place, shift) : { x: at.x, y: at.y + 120 * index },
    };
  });
  const outputs = asArray(group["outputs"]).map(asObject);
  const followed = (link: Link): Link | undefined => {
    if (link.node !== id) return link;
    const output = outputs.find((one) => link.output === undefined || one["name"] === link.output);
    const from = readLink(asString(output?.["from"]));
    return output && { ...from, node: renamed(from.node) };
  };
  const rest: JsonObject = {};
  for (const [own, item] of Object.entries(asObject(document.scope["nodes"]))) {
    if (own === id) continue;
    const linked = withLinks(asObject(item), followed);
    rest[own] = withAxisNames(linked, catalogue, (axis) =>
      axis.startsWith(`${id}/`) ? renamedAxis(axis.slice(id.length + 1)) : axis,
    );
  }
  const edit = inOrder(
    (changed) => withGroupOutputs(changed, followed),
    (changed) => replaceNodes(changed, { ...rest }),
    removeNodes([id]),
    // Nodes that link to each other have to be there together.
    addNodes(added),
    withDrawing(drawn, renamed, shift),
    withoutUnused(name),
  );
  return { edit, ids: [...names.values()] };
}

function withoutUnused(name: string): Edit {
  return (document) => {
    const { [name]: _, ...left } = asObject(document.json["groups"]);
    const nodes = [document.json["nodes"], ...Object.values(left).map((group) => asObject(group)["nodes"])];
    const isUsed = nodes.some((items) =>
      Object.values(asObject(items)).some((node) => asObject(node)["type"] === GROUP_PREFIX + name),
    );
    if (isUsed || document.inside.some(({ group }) => group === name)) return document;
    const ui = asObject(document.json["ui"]);
    const { [name]: __, ...notes } = asObject(ui["groups"]);
    return rewrittenWhole(document, { groups: left, ui: { ...ui, groups: notes } });
  };
}

function replaceNodes(document: GraphDocument, nodes: JsonObject): GraphDocument {
  const present = asObject(document.scope["nodes"]);
  const left = Object.keys(present).map((id) => [id, Object.hasOwn(nodes, id) ? nodes[id] : present[id]]);
  return rewritten(document, { nodes: Object.fromEntries(left) as JsonObject });
}

/** The node with every value at its inputs replaced. Lists take the place of an item; values that become undefined go. */
function withValues(item: JsonObject, change: (value: Json, port: string) => Json): JsonObject {
  const inputs: JsonObject = {};
  for (const [port, value] of Object.entries(asObject(item["inputs"]))) {
    if (!Array.isArray(value) || !value.some(isObject)) {
      const next = change(value, port);
      if (next !== undefined) inputs[port] = next;
      continue;
    }
    inputs[port] = value.flatMap((one) => {
      const next = change(one, port);
      if (next === undefined) return [];
      return Array.isArray(next) && next !== one ? next : [next];
    });
  }
  return { ...item, inputs };
}

/** Of the chosen nodes, those that feed no other one. */
function lastOf(document: GraphDocument, ids: ReadonlySet<string>): string[] {
  const fed = new Set<string>();
  for (const id of ids) {
    for (const sources of document.nodes.get(id)?.inputs.values() ?? []) {
      for (const source of sources) if (source.kind === "link") fed.add(source.node);
    }
  }
  return [...ids].filter((id) => !fed.has(id));
}

function cardOf(document: GraphDocument, catalogue: Catalogue, id: string): NodeCard | undefined {
  return catalogue.nodes.get(document.nodes.get(id)?.type ?? "");
}
