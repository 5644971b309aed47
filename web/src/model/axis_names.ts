// Names of axes that follow from names of nodes: where an input that makes an axis is empty, the axis is called after its node.

import type { Catalogue } from "./catalogue";
import type { GraphDocument } from "./document";
import { asObject, asString, type JsonObject } from "./json";
import { firstOf, groupNamed } from "./scope";

/** The node with other names of axes at the inputs that name some. */
export function withAxisNames(item: JsonObject, catalogue: Catalogue, change: (axis: string) => string): JsonObject {
  let changed = item;
  for (const card of catalogue.nodes.get(asString(item["type"]))?.inputs ?? []) {
    const isAxis = card.types.includes("text") && (card.makesAxis || card.emptyMeans !== "");
    const value = asObject(item["inputs"])[card.name];
    if (!isAxis || typeof value !== "string" || change(value) === value) continue;
    changed = { ...changed, inputs: { ...asObject(changed["inputs"]), [card.name]: change(value) } };
  }
  return changed;
}

/** The nodes of the open graph, told that an axis called after `from` is called after `to`; unless none is. */
export function withAxesAfter(
  document: GraphDocument,
  nodes: JsonObject,
  catalogue: Catalogue,
  from: string,
  to: string,
): JsonObject {
  const node = asObject(asObject(document.scope["nodes"])[from]);
  const type = asString(node["type"]);
  const isCalled = catalogue.nodes
    .get(type)
    ?.inputs.some(({ name, makesAxis }) => makesAxis && (asObject(node["inputs"])[name] ?? "") === "");
  if (!isCalled && groupNamed(type) === undefined) return nodes;
  const renamed = (axis: string): string => (firstOf(axis) === from ? to + axis.slice(from.length) : axis);
  return Object.fromEntries(
    Object.entries(nodes).map(([id, item]) => [id, withAxisNames(asObject(item), catalogue, renamed)]),
  );
}
