// Groups on their way from one document to another: with copied nodes, and in files of their own.

import { type GraphDocument, rewrittenWhole } from "./document";
import type { Edit } from "./edit";
import { isEqual } from "./equal";
import { groupsIn } from "./group_cards";
import { asObject, asString, type JsonObject } from "./json";
import { GROUP_PREFIX, groupNamed } from "./scope";

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
  const isEqualHere = (name: string): boolean =>
    Object.hasOwn(groups, name) && Object.hasOwn(present, name) && isEqual(present[name], groups[name]);
  const names = new Map<string, string>();
  const taken = new Set(Object.keys(present));
  for (const name of Object.keys(groups)) {
    // The same words mean another group where a group that it holds is another one.
    const isSame = isEqualHere(name) && groupsIn(groups, name).every(isEqualHere);
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

/** True if one of the types is a group that is looked at, or holds one: in it, it would have no end. */
export function wouldHoldItself({ json, inside }: GraphDocument, types: Iterable<string>): boolean {
  const groups = asObject(json["groups"]);
  const around = new Set(inside.map(({ group }) => group));
  return [...types].some((type) => {
    const name = groupNamed(type);
    return name !== undefined && [name, ...groupsIn(groups, name)].some((one) => around.has(one));
  });
}

/** Puts definitions of groups into the document, with what is noted of their drawing. */
export function withDefinitions(groups: JsonObject, notes: JsonObject): Edit {
  return (document) => {
    const ui = asObject(document.json["ui"]);
    return rewrittenWhole(document, {
      format: 2,
      groups: { ...asObject(document.json["groups"]), ...groups },
      ui: { ...ui, groups: { ...asObject(ui["groups"]), ...notes } },
    });
  };
}
