// The scales of the colors that nodes give to the model: found by the hints of their cards.

import type { Catalogue, LegendHint } from "./catalogue";
import type { GraphDocument } from "./document";
import type { ViewGraph, ViewNode } from "./graph";
import { isNumber, type Json } from "./json";
import { type ParameterValues, parameterValue } from "./parameters";

/** A node that colors what is drawn, and what its inputs say of the scale. */
export interface ColorScale {
  node: string;
  title: string;
  /** Linear red, green and blue at even places. */
  colors: readonly (readonly number[])[];
  unit: string;
  /** The numbers at both ends, as far as they are given and not found. */
  ends?: [number, number];
  /** Outputs that tell the least and the greatest number, where the ends or the model's share of them are to be found. */
  found?: [string, string];
}

/** The nodes whose colors are seen: those between `drawn` and what colors before them. All where `drawn` is none. */
export function colorScales(
  document: GraphDocument,
  catalogue: Catalogue,
  view: ViewGraph,
  values: ParameterValues,
  drawn: string | null,
): ColorScale[] {
  const scales: ColorScale[] = [];
  for (const node of seen(view, drawn, (one) => !one.bypass && hintOf(catalogue, one) !== undefined)) {
    const hint = hintOf(catalogue, node);
    const scale = hint && scaleOf(node, hint, document, values);
    if (scale) scales.push(scale);
  }
  return scales;
}

function hintOf(catalogue: Catalogue, node: ViewNode): LegendHint | undefined {
  return catalogue.nodes.get(node.type)?.legend;
}

/** Nodes that fulfil the test, from the end on; nothing is looked for behind them. */
function seen(view: ViewGraph, end: string | null, test: (node: ViewNode) => boolean): ViewNode[] {
  if (end === null || !view.byId.has(end)) return view.nodes.filter(test);
  const sources = new Map<string, string[]>();
  for (const { from, to } of view.wires) sources.set(to, [...(sources.get(to) ?? []), from]);
  const found: ViewNode[] = [];
  // A set that grows while it is gone through is gone through to its end.
  const reached = new Set([end]);
  for (const id of reached) {
    const node = view.byId.get(id);
    if (node && test(node)) found.push(node);
    else for (const from of sources.get(id) ?? []) reached.add(from);
  }
  return found;
}

function scaleOf(
  node: ViewNode,
  hint: LegendHint,
  document: GraphDocument,
  values: ParameterValues,
): ColorScale | undefined {
  const read = (name: string | undefined): Json => {
    const row = node.rows.find((one) => one.name === name);
    const parameter = document.parameters.find((one) => one.name === row?.parameterName);
    return parameter ? (parameterValue(parameter, values) as Json) : row?.literal;
  };
  const colors = hint.colors[String(read(hint.palette))];
  if (!colors || colors.length < 2) return undefined;
  const kind = String(read(hint.kind) ?? "");
  const scale: ColorScale = {
    node: node.id,
    title: hint.kind ? `${node.title}: ${kind.replaceAll("_", " ")}` : node.title,
    colors,
    unit: hint.units?.[kind] ?? "",
    found: hint.found,
  };
  const [low, high] = (hint.ends ?? []).map(read);
  const range = read(hint.range);
  if (isNumber(low) && isNumber(high)) return { ...scale, ends: [low, high] };
  if (isNumber(range) && range > 0) return { ...scale, ends: [-range, range] };
  return hint.found ? scale : undefined;
}
