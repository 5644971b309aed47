// Which values are drawn over the model: those of the flagged nodes, and what the selected ones make and take.

import { FILE_TYPE } from "./catalogue";
import type { ViewGraph, ViewNode } from "./graph";

export interface PreviewWish {
  /** "node" or "node.output", each once. */
  names: string[];
  /** Nodes that the selected ones only take from. */
  faint: ReadonlySet<string>;
}

/** The server takes more; a picture of more is not read. */
const MOST = 24;
/** Surfaces are in the model; drawn over it they would hide it. A person can still ask for one by its flag. */
const LARGE: ReadonlySet<string> = new Set(["mesh", FILE_TYPE]);

/** What to draw for a selection. Nodes in `broken` are left out, because one of them would fail all. */
export function previewWish(
  view: ViewGraph,
  selection: ReadonlySet<string>,
  broken: ReadonlySet<string> = new Set(),
): PreviewWish {
  const names = new Set<string>();
  const faint = new Set<string>();
  const add = (node: ViewNode | undefined, isWanted: (type: string, output: string) => boolean): boolean => {
    if (!node?.known || broken.has(node.id)) return false;
    const outputs = node.outputs.filter(({ type, name }) => type !== FILE_TYPE && isWanted(type, name));
    for (const { name } of outputs) names.add(`${node.id}.${name}`);
    return outputs.length > 0;
  };
  for (const node of view.nodes) if (node.preview) add(node, () => true);
  for (const id of selection) add(view.byId.get(id), (type) => !LARGE.has(type));
  for (const { from, output, to } of view.wires) {
    const source = view.byId.get(from);
    if (!selection.has(to) || selection.has(from) || source?.preview || broken.has(to)) continue;
    if (add(source, (type, name) => name === output && !LARGE.has(type))) faint.add(from);
  }
  return { names: [...names].slice(0, MOST), faint };
}
