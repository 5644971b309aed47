// Types of outputs as far as they can be told without the server: "same as input" is followed through wires.

import type { Catalogue } from "./catalogue";
import type { GraphDocument } from "./document";
import type { Json } from "./json";

const NUMBERS: readonly string[] = ["number"];
const TRIPLES: readonly string[] = ["point", "vector"];

export interface OutputName {
  node: string;
  output?: string;
}

/** Answers by document and catalogue; made anew for each of them. Cycles end as unknown. */
export class OutputTypes {
  private readonly found = new Map<string, readonly string[]>();

  constructor(
    private readonly document: GraphDocument,
    private readonly catalogue: Catalogue,
  ) {}

  /** The output meant by a link: the named one, or the first. Undefined if there is none. */
  outputName(nodeId: string, output: string | undefined): string | undefined {
    const node = this.document.nodes.get(nodeId);
    const outputs = (node && this.catalogue.nodes.get(node.type)?.outputs) ?? [];
    return output === undefined ? outputs[0]?.name : outputs.find((item) => item.name === output)?.name;
  }

  /** The type of an output, or the first it may have; undefined where nothing is known. */
  of(nodeId: string, output?: string): string | undefined {
    return this.possible(nodeId, output)[0];
  }

  /** Every type an output may have: one where it is settled, several while the input it follows is open. */
  possible(nodeId: string, output?: string): readonly string[] {
    // Walks up iteratively, because a document may chain thousands of nodes.
    const visited = new Set<string>();
    let [node, name] = [nodeId, this.outputName(nodeId, output)];
    let answer: readonly string[] = [];
    while (name !== undefined) {
      const key = `${node}.${name}`;
      if (this.found.has(key) || visited.has(key)) {
        answer = this.found.get(key) ?? [];
        break;
      }
      visited.add(key);
      const step = this.step(node, name);
      if ("types" in step) {
        answer = step.types;
        break;
      }
      node = step.node;
      name = this.outputName(step.node, step.output);
    }
    for (const key of visited) this.found.set(key, answer);
    return answer;
  }

  /** The types themselves where they are known at this node, or the link to follow. */
  private step(nodeId: string, name: string): { types: readonly string[] } | OutputName {
    const node = this.document.nodes.get(nodeId);
    const card = node && this.catalogue.nodes.get(node.type);
    const output = card?.outputs.find((item) => item.name === name);
    if (!node || !card || !output) return { types: [] };
    // Where no input is named, the type depends on the inputs in a way that the server alone knows.
    const sources = (output.sameAs !== undefined && node.inputs.get(output.sameAs)) || [];
    const link = sources.find((source) => source.kind === "link");
    const literal = sources.find((source) => source.kind === "literal");
    return link ?? { types: literal ? narrowed(output.types, literal.value) : output.types };
  }
}

/** Those of the types that the literal, or the first of a list of literals, may stand for. */
function narrowed(types: readonly string[], value: Json): readonly string[] {
  const wanted = Array.isArray(value) && Array.isArray(value[0]) ? TRIPLES : NUMBERS;
  const fitting = types.filter((type) => wanted.includes(type));
  return fitting.length > 0 ? fitting : types;
}
