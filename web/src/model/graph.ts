// What is drawn of a graph: nodes with rows of sockets, wires with types. Made from document and catalogue alone.

import { FILE_TYPE, unitText, type Catalogue, type InputCard, type NodeCard } from "./catalogue";
import type { GraphDocument, GraphNode, Source } from "./document";
import { literalText } from "./format";

/** One input row: its socket, and the value or parameter that stands there. */
export interface InputRow {
  name: string;
  type: string;
  types: string[];
  doc: string;
  linked: boolean;
  /** Text of the literal, or of the default where nothing is given. */
  value: string;
  /** Label of the graph parameter that drives the input. */
  parameter?: string;
  isDefault: boolean;
  required: boolean;
}

export interface OutputRow {
  name: string;
  type: string;
  doc: string;
}

export interface ViewNode {
  id: string;
  /** The node type's title; the id where the catalogue does not know the type. */
  title: string;
  type: string;
  family: string;
  doc: string;
  source: string;
  known: boolean;
  bypass: boolean;
  inputs: InputRow[];
  /** How many inputs stand at their default and are folded away. */
  folded: InputRow[];
  outputs: OutputRow[];
}

export interface ViewWire {
  id: string;
  from: string;
  output: string;
  to: string;
  input: string;
  type: string;
}

export interface ViewGraph {
  nodes: ViewNode[];
  wires: ViewWire[];
}

/** The nodes and wires of a document. Links to missing nodes or outputs are left out: the server reports them. */
export function viewGraph(document: GraphDocument, catalogue: Catalogue): ViewGraph {
  const types = new OutputTypes(document, catalogue);
  const nodes: ViewNode[] = [];
  const wires: ViewWire[] = [];
  const labels = new Map(document.parameters.map((parameter) => [parameter.name, parameter.label]));
  for (const node of document.nodes.values()) {
    const card = catalogue.nodes.get(node.type);
    const rows = inputRows(node, card, labels, types);
    nodes.push({
      id: node.id,
      title: card?.title ?? node.type,
      type: node.type,
      family: card?.family ?? "",
      doc: card?.doc ?? "",
      source: card?.source ?? "",
      known: card !== undefined,
      bypass: node.bypass,
      inputs: rows.filter((row) => !row.isDefault || row.required),
      folded: rows.filter((row) => row.isDefault && !row.required),
      outputs: (card?.outputs ?? []).map((output) => ({
        name: output.name,
        type: types.of(node.id, output.name) ?? "",
        doc: output.doc,
      })),
    });
    for (const [input, sources] of node.inputs) wires.push(...wiresInto(node.id, input, sources, types));
  }
  return { nodes, wires };
}

/** The node whose file is shown: the only one, or the first, that makes a file. Undefined if there is none. */
export function fileOutput(document: GraphDocument, catalogue: Catalogue): string | undefined {
  for (const node of document.nodes.values()) {
    const outputs = catalogue.nodes.get(node.type)?.outputs ?? [];
    if (outputs.some((output) => output.types.includes(FILE_TYPE))) return node.id;
  }
  return undefined;
}

function inputRows(
  node: GraphNode,
  card: NodeCard | undefined,
  labels: Map<string, string>,
  types: OutputTypes,
): InputRow[] {
  const names = [...(card?.inputs.map((input) => input.name) ?? [])];
  for (const name of node.inputs.keys()) if (!names.includes(name)) names.push(name);
  return names.map((name) => {
    const input = card?.inputs.find((candidate) => candidate.name === name);
    const sources = node.inputs.get(name) ?? [];
    return inputRow(name, input, sources, labels, types);
  });
}

function inputRow(
  name: string,
  input: InputCard | undefined,
  sources: Source[],
  labels: Map<string, string>,
  types: OutputTypes,
): InputRow {
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
    type: (link && types.of(link.node, link.output)) ?? input?.types[0] ?? "",
    types: input?.types ?? [],
    doc: input?.doc ?? "",
    linked: link !== undefined,
    value: isDefault ? fallback : literals.map((value) => withUnit(literalText(value))).join(", "),
    parameter: parameter && (labels.get(parameter.name) ?? parameter.name),
    isDefault,
    required: input?.required ?? false,
  };
}

function wiresInto(to: string, input: string, sources: Source[], types: OutputTypes): ViewWire[] {
  return sources.flatMap((source, index) => {
    if (source.kind !== "link") return [];
    const output = types.outputName(source.node, source.output);
    if (output === undefined) return [];
    const type = types.of(source.node, output) ?? "";
    return [{ id: `${to}.${input}.${index}`, from: source.node, output, to, input, type }];
  });
}

/** Types of outputs, following "same as input" through wires. Cycles end as unknown. */
class OutputTypes {
  private readonly found = new Map<string, string | undefined>();

  constructor(
    private readonly document: GraphDocument,
    private readonly catalogue: Catalogue,
  ) {}

  outputName(nodeId: string, output: string | undefined): string | undefined {
    const node = this.document.nodes.get(nodeId);
    const outputs = (node && this.catalogue.nodes.get(node.type)?.outputs) ?? [];
    return output === undefined ? outputs[0]?.name : outputs.find((item) => item.name === output)?.name;
  }

  of(nodeId: string, output?: string): string | undefined {
    // Walks up iteratively, because a document may chain thousands of nodes.
    const visited: string[] = [];
    let [node, name] = [nodeId, this.outputName(nodeId, output)];
    let answer: string | undefined;
    while (name !== undefined) {
      const key = `${node}.${name}`;
      if (this.found.has(key) || visited.includes(key)) {
        answer = this.found.get(key);
        break;
      }
      visited.push(key);
      const step = this.step(node, name);
      if (typeof step !== "object") {
        answer = step;
        break;
      }
      node = step.node;
      name = this.outputName(step.node, step.output);
    }
    for (const key of visited) this.found.set(key, answer);
    return answer;
  }

  /** The type itself where it is known at this node, or the link to follow. */
  private step(nodeId: string, name: string): string | undefined | { node: string; output?: string } {
    const node = this.document.nodes.get(nodeId);
    const card = node && this.catalogue.nodes.get(node.type);
    const output = card?.outputs.find((item) => item.name === name);
    if (!node || !card || !output) return undefined;
    const follow = output.sameAs ?? (output.types.length > 1 ? card.inputs[0]?.name : undefined);
    const link = follow === undefined ? undefined : node.inputs.get(follow)?.find((source) => source.kind === "link");
    return link ?? output.types[0];
  }
}
