// Places in groups, by the ids of the instances that lead there.

import { type GraphDocument, lookedAt } from "../model/document";
import { groupNamed, type Inside } from "../model/scope";

/** What is looked at inside of the group that a node stands for; undefined where it stands for none. */
export function placeInside({ nodes, inside }: GraphDocument, id: string): Inside[] | undefined {
  const group = groupNamed(nodes.get(id)?.type ?? "");
  return group === undefined ? undefined : [...inside, { id, group }];
}

/** Where a node stands that has the path "ring/circle" in the whole document; undefined if there is none. */
export function placeOf(document: GraphDocument, path: string): { inside: readonly Inside[]; id: string } | undefined {
  const ids = path.split("/");
  let at = lookedAt(document, []);
  for (const id of ids.slice(0, -1)) {
    const inside = placeInside(at, id);
    if (!inside) return undefined;
    at = lookedAt(at, inside);
  }
  const id = ids.at(-1) ?? "";
  return at.nodes.has(id) ? { inside: at.inside, id } : undefined;
}
