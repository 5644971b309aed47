// Making groups of nodes and taking them apart, as changes of the document.

import type { Catalogue } from "./catalogue";
import { type GraphDocument, rewritten, rewrittenWhole } from "./document";
import { addNodes, type Edit, freeId, inOrder, linkText, removeNodes, withLinks } from "./edit";
import { isEqual } from "./equal";
import { groupsIn } from "./group_cards";
import { asArray, asNumber, asObject, asString, isObject, type Json, type JsonObject } from "./json";
import { GROUP_PREFIX, groupNamed } from "./scope";
import type { Position } from "./ui";

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
  const nodes: JsonObject = {};
  for (const [own, item] of Object.entries(all)) {
    if (!ids.has(own)) continue;
    nodes[own] = withValues(asObject(item), (value, port) => {
      const text = isObject(value) ? asString(value["from"]) : "";
      const parameter = isObject(value) ? asString(value["parameter"]) : "";
      if (!parameter && (!text || ids.has(text.split(".")[0] ?? ""))) return value;
      const key = text ? `from ${text}` : `parameter ${parameter}`;
      const input = inputs.get(key) ?? free(parameter || port);
      inputs.set(key, input);
      given[input] = value;
      return { input };
    });
  }
  taken.clear();
  const outputOf = ({ node, output }: { node: string; output?: string }): string => {
    const card = catalogue.nodes.get(document.nodes.get(node)?.type ?? "");
    const port = output ?? card?.outputs[0]?.name ?? "value";
    const key = linkText({ node, output: (card?.outputs.length ?? 1) > 1 ? port : undefined });
    const made = outputs.get(key) ?? free(port);
    outputs.set(key, made);
    return made;
  };
  const rest: JsonObject = {};
  for (const [own, item] of Object.entries(all)) {
    if (ids.has(own)) continue;
    const linked = withLinks(asObject(item), (link) =>
      ids.has(link.node) ? { node: id, output: outputOf(link) } : link,
    );
    rest[own] = withAxisNames(linked, catalogue, (axis) => (ids.has(axis) ? `${id}/${axis}` : axis));
  }
  if (outputs.size === 0) for (const node of lastOf(document, ids)) outputOf({ node });
  const group: JsonObject = {
    inputs: [...inputs.values()].map((input) => ({ name: input })),
    outputs: [...outputs].map(([from, output]) => ({ name: output, from })),
    nodes,
  };
  const places = [...document.positions].filter(([own]) => ids.has(own));
  const at = middleOf(places.map(([, place]) => place));
  const ui: JsonObject = {
    nodes: Object.fromEntries(places.map(([own]) => [own, asObject(asObject(document.scope["ui"])["nodes"])[own]])),
  };
  const edit = inOrder(
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
  const defaults = new Map(
    asArray(group["inputs"])
      .map(asObject)
      .map((input) => [input["name"], input["default"]]),
  );
  const values = (value: Json): Json => {
    if (!isObject(value) || typeof value["input"] !== "string") return value;
    return Object.hasOwn(given, value["input"]) ? given[value["input"]] : defaults.get(value["input"]);
  };
  const ui = asObject(asObject(asObject(asObject(document.json["ui"])["groups"])[name])["nodes"]);
  const places = Object.entries(ui).flatMap(([own, item]) => {
    const [x, y] = [asNumber(asObject(item)["x"]), asNumber(asObject(item)["y"])];
    return x === undefined || y === undefined ? [] : [[own, { x, y }] as const];
  });
  const middle = middleOf(places.map(([, place]) => place));
  const at = document.positions.get(id) ?? middle;
  const placeOf = new Map(places.map(([own, { x, y }]) => [own, { x: x - middle.x + at.x, y: y - middle.y + at.y }]));
  const added = Object.entries(inner).map(([own, item], index) => {
    const linked = withLinks(asObject(item), (link) => ({ ...link, node: renamed(link.node) }));
    const node = withAxisNames(withValues(linked, values), catalogue, renamed);
    return {
      id: renamed(own),
      type: asString(node["type"]),
      inputs: asObject(node["inputs"]),
      bypass: node["bypass"] === true,
      position: placeOf.get(own) ?? { x: at.x, y: at.y + 120 * index },
    };
  });
  const outputs = asArray(group["outputs"]).map(asObject);
  const rest: JsonObject = {};
  for (const [own, item] of Object.entries(asObject(document.scope["nodes"]))) {
    if (own === id) continue;
    const linked = withLinks(asObject(item), (link) => {
      if (link.node !== id) return link;
      const output = outputs.find((one) => link.output === undefined || one["name"] === link.output);
      const [node = "", ...port] = asString(output?.["from"]).split(".");
      return output && { node: renamed(node), output: port.length > 0 ? port.join(".") : undefined };
    });
    rest[own] = withAxisNames(linked, catalogue, (axis) =>
      axis.startsWith(`${id}/`) ? renamed(axis.slice(id.length + 1)) : axis,
    );
  }
  const edit = inOrder(
    (changed) => replaceNodes(changed, { ...rest }),
    removeNodes([id]),
    // Nodes that link to each other have to be there together.
    addNodes(added),
    withoutUnused(name),
  );
  return { edit, ids: [...names.values()] };
}

/** Makes the outputs of nodes outputs of the group that is looked at; where all of them are, they are taken away. */
export function toggleOutputs(catalogue: Catalogue, ids: ReadonlySet<string>): Edit {
  return (document) => {
    const name = document.inside.at(-1)?.group;
    if (name === undefined) return document;
    const groups = asObject(document.json["groups"]);
    const group = asObject(groups[name]);
    const outputs = asArray(group["outputs"]).map(asObject);
    const wanted = [...ids].flatMap((node) =>
      (catalogue.nodes.get(document.nodes.get(node)?.type ?? "")?.outputs ?? []).map((output) => ({
        node,
        output: output.name,
      })),
    );
    const isShown = ({ node, output }: { node: string; output: string }): boolean =>
      outputs.some(({ from }) => from === node || from === linkText({ node, output }));
    let next = outputs;
    if (wanted.every(isShown)) {
      next = outputs.filter(({ from }) => !ids.has(asString(from).split(".")[0] ?? ""));
    } else {
      for (const place of wanted) {
        if (isShown(place)) continue;
        const free = (number: number): string => (number === 1 ? place.output : `${place.output}_${number}`);
        let number = 1;
        while (next.some((output) => output["name"] === free(number))) number++;
        next = [...next, { name: free(number), from: linkText(place) }];
      }
    }
    return rewrittenWhole(document, { groups: { ...groups, [name]: { ...group, outputs: next } } });
  };
}

/** What a group is called where people read it. */
export function renameGroup(name: string, label: string): Edit {
  return (document) => {
    const groups = asObject(document.json["groups"]);
    if (!isObject(groups[name])) return document;
    return rewrittenWhole(document, { groups: { ...groups, [name]: { ...groups[name], label } } });
  };
}

/** The groups that nodes need, as a document keeps them, with what it notes of their drawing. */
export function definitionsFor(
  document: GraphDocument,
  types: Iterable<string>,
): { groups: JsonObject; notes: JsonObject } {
  const all = asObject(document.json["groups"]);
  const notes = asObject(asObject(document.json["ui"])["groups"]);
  const wanted = new Set([...types].flatMap((type) => groupNamed(type) ?? []));
  for (const name of [...wanted]) for (const inner of groupsIn(all, name)) wanted.add(inner);
  const only = (members: JsonObject): JsonObject =>
    Object.fromEntries(Object.entries(members).filter(([name]) => wanted.has(name))) as JsonObject;
  return { groups: only(all), notes: only(notes) };
}

/**
 * Groups of another document for this one: those that it has already stay, those whose name means another group here come
 * under a free name. `typeOf` tells what a type is called then.
 */
export function broughtGroups(
  document: GraphDocument,
  groups: JsonObject,
  notes: JsonObject = {},
): { edit: Edit; typeOf: (type: string) => string } {
  const present = asObject(document.json["groups"]);
  const names = new Map<string, string>();
  const taken = new Set(Object.keys(present));
  for (const [name, group] of Object.entries(groups)) {
    const isSame = Object.hasOwn(present, name) && isEqual(present[name], group);
    let made = name;
    for (let number = 2; !isSame && taken.has(made); number++) made = `${name.slice(0, 56)}_${number}`;
    taken.add(made);
    names.set(name, made);
  }
  const typeOf = (type: string): string => {
    const name = groupNamed(type);
    return name === undefined ? type : GROUP_PREFIX + (names.get(name) ?? name);
  };
  const added: JsonObject = {};
  const drawn: JsonObject = {};
  for (const [name, group] of Object.entries(groups)) {
    const made = names.get(name) ?? name;
    if (Object.hasOwn(present, made)) continue;
    const nodes = Object.entries(asObject(asObject(group)["nodes"])).map(([id, node]) => [
      id,
      { ...asObject(node), type: typeOf(asString(asObject(node)["type"])) },
    ]);
    added[made] = { ...asObject(group), nodes: Object.fromEntries(nodes) as JsonObject };
    if (notes[name] !== undefined) drawn[made] = notes[name];
  }
  const isNothing = Object.keys(added).length === 0;
  return { edit: isNothing ? (same) => same : withDefinitions(added, drawn), typeOf };
}

/** A group, and those in it, as a document without nodes, which is what a file of a group is. */
export function groupFile(document: GraphDocument, name: string): JsonObject {
  const { groups, notes } = definitionsFor(document, [GROUP_PREFIX + name]);
  return { format: 2, meta: { title: name }, groups, nodes: {}, ui: { groups: notes } };
}

/** The groups of a file that stand in no other of its groups: those that it is about. */
export function outerGroups(groups: JsonObject): string[] {
  const inner = new Set(Object.keys(groups).flatMap((name) => groupsIn(groups, name)));
  return Object.keys(groups).filter((name) => !inner.has(name));
}

function withDefinitions(groups: JsonObject, notes: JsonObject): Edit {
  return (document) => {
    const ui = asObject(document.json["ui"]);
    return rewrittenWhole(document, {
      format: 2,
      groups: { ...asObject(document.json["groups"]), ...groups },
      ui: { ...ui, groups: { ...asObject(ui["groups"]), ...notes } },
    });
  };
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

/** The node with other names of axes at the inputs that name some. */
function withAxisNames(item: JsonObject, catalogue: Catalogue, change: (axis: string) => string): JsonObject {
  let changed = item;
  for (const card of catalogue.nodes.get(asString(item["type"]))?.inputs ?? []) {
    const isAxis = card.types.includes("text") && (card.makesAxis || card.emptyMeans !== "");
    const value = asObject(item["inputs"])[card.name];
    if (!isAxis || typeof value !== "string" || change(value) === value) continue;
    changed = { ...changed, inputs: { ...asObject(changed["inputs"]), [card.name]: change(value) } };
  }
  return changed;
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

function middleOf(places: readonly Position[]): Position {
  if (places.length === 0) return { x: 0, y: 0 };
  const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
  return { x: (Math.min(...xs) + Math.max(...xs)) / 2, y: (Math.min(...ys) + Math.max(...ys)) / 2 };
}
