// What is drawn of a graph: the file that it makes, or, while no node makes one, what is selected or stands last.

import { type Catalogue, FILE_TYPE } from "./catalogue";
import type { GraphDocument } from "./document";
import { freeId } from "./edit";
import { linkText } from "./edit_links";
import { fileOutput, makesFile, type ViewGraph, type ViewNode } from "./graph";
import { asObject, type JsonObject } from "./json";

export interface DrawnGraph {
  graph: JsonObject;
  /** The node of `graph` whose file is shown. */
  output: string;
}

/**
 * The document as it is sent to be drawn. Where no node makes a file, one that does is put behind the selected node, else
 * behind the last one that has all it needs; it is sent only. Undefined where there is nothing to draw.
 */
export function drawnGraph(
  document: GraphDocument,
  catalogue: Catalogue,
  view: ViewGraph,
  selected: string | null,
): DrawnGraph | undefined {
  const own = fileOutput(document, catalogue);
  if (own !== undefined) return { graph: document.json, output: own };
  const end = [...catalogue.nodes.values()].find((card) => makesFile(card) && card.inputs[0]?.required);
  const socket = end?.inputs[0];
  if (!end || !socket) return undefined;
  const waiting = waitingNodes(view);
  const drawable = (node: ViewNode | undefined): string | undefined =>
    node && !waiting.has(node.id)
      ? node.outputs.find(({ type }) => type !== FILE_TYPE && socket.types.includes(type))?.name
      : undefined;
  const chosen = selected === null ? undefined : view.byId.get(selected);
  const source = drawable(chosen) !== undefined ? chosen : lastOf(view, (node) => drawable(node) !== undefined);
  const output = drawable(source);
  if (!source || output === undefined) return undefined;
  const id = freeId(document, end.id);
  const node = { type: end.id, inputs: { [socket.name]: { from: linkText({ node: source.id, output }) } } };
  return { graph: { ...document.json, nodes: { ...asObject(document.json["nodes"]), [id]: node } }, output: id };
}

/** Nodes that lack an input, and those behind them. */
function waitingNodes({ nodes, wires }: ViewGraph): ReadonlySet<string> {
  const waiting = new Set(
    nodes.filter((node) => !node.known || node.rows.some((row) => row.required && row.isDefault)).map(({ id }) => id),
  );
  const targets = new Map<string, string[]>();
  for (const { from, to } of wires) targets.set(from, [...(targets.get(from) ?? []), to]);
  // A set that grows while it is gone through is gone through to its end.
  for (const id of waiting) for (const to of targets.get(id) ?? []) waiting.add(to);
  return waiting;
}

/** The last node in the document that feeds no other one of its kind. */
function lastOf({ nodes, wires }: ViewGraph, isDrawable: (node: ViewNode) => boolean): ViewNode | undefined {
  const drawable = new Map(nodes.filter(isDrawable).map((node) => [node.id, node]));
  const fed = new Set(wires.filter(({ from, to }) => drawable.has(from) && drawable.has(to)).map(({ from }) => from));
  const ends = [...drawable.values()].filter(({ id }) => !fed.has(id));
  return ends.at(-1) ?? [...drawable.values()].at(-1);
}
