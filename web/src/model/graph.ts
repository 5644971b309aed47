// What is drawn of a graph: nodes with rows of sockets, wires with types. Made from document and catalogue alone.

import { type Catalogue, FILE_TYPE, type InputCard, type NodeCard, takesWires, unitText } from "./catalogue";
import type { GraphDocument, GraphNode, Source } from "./document";
import { isEqual } from "./equal";
import { literalText } from "./format";
import type { Json } from "./json";
import { sentenceCase } from "./parameters";
import { OutputTypes } from "./types";

/** One input row: its socket, and the value or parameter that stands there. */
export interface InputRow {
  name: string;
  /** As people read it. */
  title: string;
  type: string;
  types: string[];
  description: string;
  linked: boolean;
  /** Text of the literal, or of the default where nothing is given. */
  value: string;
  /** The one literal that stands there, or the default; undefined where there is a wire, a parameter or nothing. */
  literal?: Json;
  /** Label of the graph parameter that drives the input. */
  parameter?: string;
  parameterName?: string;
  isDefault: boolean;
  required: boolean;
  /** Wires may end here. */
  hasSocket: boolean;
  /** What the catalogue says of it; undefined for an input it does not know. */
  card?: InputCard;
}

export interface OutputRow {
  name: string;
  title: string;
  type: string;
  description: string;
}

export interface ViewNode {
  id: string;
  /** The node type's title; the id where the catalogue does not know the type. */
  title: string;
  type: string;
  family: string;
  description: string;
  details: string;
  source: string;
  known: boolean;
  bypass: boolean;
  preview: boolean;
  collapsed: boolean;
  /** The name of a tint; empty for the usual one. */
  color: string;
  /** What it is called for people, in place of the title; empty where that says it. */
  label: string;
  /** Every input, in the catalogue's order. */
  rows: InputRow[];
  /** Inputs that are given or required: those shown while the others are folded away. */
  inputs: InputRow[];
  /** Inputs that stand at their default. */
  folded: InputRow[];
  outputs: OutputRow[];
}

export interface ViewWire {
  id: string;
  from: string;
  output: string;
  to: string;
  input: string;
  /** Place among the sources of the input. */
  index: number;
  type: string;
}

export interface ViewGraph {
  nodes: readonly ViewNode[];
  wires: readonly ViewWire[];
  byId: ReadonlyMap<string, ViewNode>;
}

export const EMPTY_VIEW: ViewGraph = { nodes: [], wires: [], byId: new Map() };

/**
 * The nodes and wires of a document. Links to missing nodes or outputs are left out: the server reports them. Nodes and
 * the list of wires that equal those of `before` are the same objects, so that only what changed is drawn again.
 */
export function viewGraph(document: GraphDocument, catalogue: Catalogue, before = EMPTY_VIEW): ViewGraph {
  const types = new OutputTypes(document, catalogue);
  const labels = new Map(document.parameters.map((parameter) => [parameter.name, parameter.label]));
  const nodes: ViewNode[] = [];
  const wires: ViewWire[] = [];
  for (const node of document.nodes.values()) {
    const old = before.byId.get(node.id);
    const drawn = viewNode(node, document, catalogue, labels, types, old?.rows);
    nodes.push(old && isEqual(old, drawn) ? old : drawn);
    for (const [input, sources] of node.inputs) wires.push(...wiresInto(node.id, input, sources, types));
  }
  const isSame = nodes.length === before.nodes.length && nodes.every((node, index) => node === before.nodes[index]);
  return {
    nodes: isSame ? before.nodes : nodes,
    wires: isEqual(before.wires, wires) ? before.wires : wires,
    byId: isSame ? before.byId : new Map(nodes.map((node) => [node.id, node])),
  };
}

/** The node whose file is shown: the only one, or the first, that makes a file. Undefined if there is none. */
export function fileOutput(document: GraphDocument, catalogue: Catalogue): string | undefined {
  for (const node of document.nodes.values()) if (makesFile(catalogue.nodes.get(node.type))) return node.id;
  return undefined;
}

export function makesFile(card: NodeCard | undefined): boolean {
  return card?.outputs.some((output) => output.types.includes(FILE_TYPE)) ?? false;
}

function viewNode(
  node: GraphNode,
  document: GraphDocument,
  catalogue: Catalogue,
  labels: Map<string, string>,
  types: OutputTypes,
  before: readonly InputRow[] = [],
): ViewNode {
  const card = catalogue.nodes.get(node.type);
  const names = [...(card?.inputs.map((input) => input.name) ?? [])];
  for (const name of node.inputs.keys()) if (!names.includes(name)) names.push(name);
  const rows = names.map((name) => {
    const input = card?.inputs.find((candidate) => candidate.name === name);
    const bare = inputRow(name, input, node.inputs.get(name) ?? [], labels, types);
    const row = { ...bare, hasSocket: bare.linked || (input !== undefined && takesWires(catalogue, input)) };
    return before.find((old) => old.name === name && isEqual(old, row)) ?? row;
  });
  return {
    id: node.id,
    title: card?.title ?? node.type,
    type: node.type,
    family: card?.family ?? "",
    description: card?.description ?? "",
    details: card?.details ?? "",
    source: card?.source ?? "",
    known: card !== undefined,
    bypass: node.bypass,
    preview: document.previews.has(node.id),
    collapsed: document.collapsed.has(node.id),
    color: document.colors.get(node.id) ?? "",
    label: document.labels.get(node.id) ?? "",
    rows,
    inputs: rows.filter((row) => !row.isDefault || row.required),
    folded: rows.filter((row) => row.isDefault && !row.required),
    outputs: (card?.outputs ?? []).map((output) => ({
      name: output.name,
      title: output.title,
      type: types.of(node.id, output.name) ?? "",
      description: output.description,
    })),
  };
}

function inputRow(
  name: string,
  input: InputCard | undefined,
  sources: readonly Source[],
  labels: Map<string, string>,
  types: OutputTypes,
): Omit<InputRow, "hasSocket"> {
  const link = sources.find((source) => source.kind === "link");
  const parameter = sources.find((source) => source.kind === "parameter");
  const literals = sources.flatMap((source) => (source.kind === "literal" ? [source.value] : []));
  const isDefault = sources.length === 0;
  const unit = unitText(input?.unit ?? "");
  const withUnit = (text: string) => (/^[-\d.]/.test(text) ? text + unit : text);
  const fallback =
    input?.fallback === undefined || input.fallback === null ? "" : withUnit(literalText(input.fallback));
  return {
    name,
    title: input?.title ?? sentenceCase(name),
    type: (link && types.of(link.node, link.output)) ?? input?.types[0] ?? "",
    types: input?.types ?? [],
    description: input?.description ?? "",
    linked: link !== undefined,
    value: isDefault ? fallback : literals.map((value) => withUnit(literalText(value))).join(", "),
    literal: isDefault ? input?.fallback : sources.length === 1 ? literals[0] : undefined,
    parameter: parameter && (labels.get(parameter.name) ?? parameter.name),
    parameterName: parameter?.name,
    isDefault,
    required: input?.required ?? false,
    card: input,
  };
}

function wiresInto(to: string, input: string, sources: readonly Source[], types: OutputTypes): ViewWire[] {
  return sources.flatMap((source, index) => {
    if (source.kind !== "link") return [];
    const output = types.outputName(source.node, source.output);
    if (output === undefined) return [];
    const type = types.of(source.node, output) ?? "";
    return [{ id: `${to}.${input}.${index}`, from: source.node, output, to, input, index, type }];
  });
}
