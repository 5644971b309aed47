// Links in a node's JSON: what `{"from": "node.output"}` says, and replacing it.

import { readLink } from "./document";
import { asObject, isObject, type Json, type JsonObject } from "./json";

export interface Link {
  node: string;
  output?: string;
}

/** The same node with every link replaced; the same object if none is. Links that become undefined go. */
export function withLinks(item: JsonObject, change: (link: Link) => Link | undefined): JsonObject {
  let isChanged = false;
  const inputs: JsonObject = {};
  const changed = (value: Json): Json => {
    if (!isObject(value) || typeof value["from"] !== "string") return value;
    const link = readLink(value["from"]);
    const next = change(link);
    if (next === link) return value;
    isChanged = true;
    return next && { from: linkText(next) };
  };
  for (const [name, value] of Object.entries(asObject(item["inputs"]))) {
    const next = Array.isArray(value) ? listOf(value, changed) : changed(value);
    if (next !== undefined) inputs[name] = next;
  }
  return isChanged ? { ...item, inputs } : item;
}

export function linkText({ node, output }: Link): string {
  return output === undefined ? node : `${node}.${output}`;
}

function listOf(list: Json[], change: (value: Json) => Json): Json {
  const next = list.map(change);
  if (next.every((value, index) => value === list[index])) return list;
  const left = next.filter((value) => value !== undefined);
  return left.length > 0 ? left : undefined;
}

/** The same node without the links that are gone. */
export function withoutLinks(item: JsonObject, isGone: (link: Link) => boolean): JsonObject {
  return withLinks(item, (link) => (isGone(link) ? undefined : link));
}
