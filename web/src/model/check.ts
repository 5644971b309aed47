// Whether a wire may be drawn, told before the server is asked. It is stricter in nothing and milder in axes, which only
// the server knows.

import { type Catalogue, type InputCard, takesWires } from "./catalogue";
import type { GraphDocument } from "./document";
import { OutputTypes } from "./types";

/** A wire that is there or may be. */
export interface Connection {
  from: string;
  output: string;
  to: string;
  input: string;
}

interface Place {
  node: string;
  input: string;
}

/** Judges wires of one document; what it has found out it keeps for the next wire. */
export class WireCheck {
  readonly types: OutputTypes;
  private readonly upstream = new Map<string, ReadonlySet<string>>();
  private ends: Map<string, Place[]> | undefined;

  constructor(
    private readonly document: GraphDocument,
    private readonly catalogue: Catalogue,
  ) {
    this.types = new OutputTypes(document, catalogue);
  }

  /** Why a wire cannot be drawn, as a sentence, or undefined if it can. */
  refusal({ from, output, to, input }: Connection): string | undefined {
    const card = inputCard(this.document, this.catalogue, to, input);
    if (!card || this.types.outputName(from, output) === undefined) return "There is no such socket.";
    if (!takesWires(this.catalogue, card)) return `${input} takes a typed value only.`;
    const offered = this.types.possible(from, output);
    if (!accepts(card, offered)) return `${input} needs ${listed(card.types)}, got ${listed(offered)}.`;
    if (this.upstreamOf(from).has(to)) return "The wire would close a loop.";
    return this.refusedBehind({ node: to, input }, offered);
  }

  private upstreamOf(id: string): ReadonlySet<string> {
    const known = this.upstream.get(id) ?? upstreamOf(this.document, id);
    this.upstream.set(id, known);
    return known;
  }

  /** Outputs that repeat the type of this input may feed inputs that do not take it. */
  private refusedBehind(start: Place, offered: readonly string[]): string | undefined {
    const seen = new Set<string>();
    const open = [start];
    for (const place of open) {
      const key = `${place.node}.${place.input}`;
      if (seen.has(key)) continue;
      seen.add(key);
      const card = this.catalogue.nodes.get(this.document.nodes.get(place.node)?.type ?? "");
      for (const output of card?.outputs ?? []) {
        if (output.sameAs !== place.input) continue;
        for (const next of this.endsOf(place.node, output.name)) {
          const taken = inputCard(this.document, this.catalogue, next.node, next.input);
          if (taken && !accepts(taken, offered)) {
            return `${next.input} of ${next.node}, further on, needs ${listed(taken.types)}, got ${listed(offered)}.`;
          }
          open.push(next);
        }
      }
    }
    return undefined;
  }

  private endsOf(node: string, output: string): readonly Place[] {
    if (!this.ends) {
      this.ends = new Map();
      for (const { id, inputs } of this.document.nodes.values()) {
        for (const [input, sources] of inputs) {
          for (const source of sources) {
            if (source.kind !== "link") continue;
            const key = `${source.node}.${this.types.outputName(source.node, source.output)}`;
            const list = this.ends.get(key);
            if (list) list.push({ node: id, input });
            else this.ends.set(key, [{ node: id, input }]);
          }
        }
      }
    }
    return this.ends.get(`${node}.${output}`) ?? [];
  }
}

/** True if a value of one of the offered types may stand at the input. */
export function accepts(input: InputCard, offered: readonly string[]): boolean {
  return offered.some((type) => input.types.includes(type));
}

/** The node itself and every node its value depends on. */
export function upstreamOf(document: GraphDocument, id: string): ReadonlySet<string> {
  const seen = new Set([id]);
  for (const node of seen) {
    for (const sources of document.nodes.get(node)?.inputs.values() ?? []) {
      for (const source of sources) if (source.kind === "link") seen.add(source.node);
    }
  }
  return seen;
}

export function inputCard(
  document: GraphDocument,
  catalogue: Catalogue,
  node: string,
  input: string,
): InputCard | undefined {
  const type = document.nodes.get(node)?.type ?? "";
  return catalogue.nodes.get(type)?.inputs.find((card) => card.name === input);
}

/** "circle", "circle or mesh", "point, circle or mesh". */
export function listed(types: readonly string[]): string {
  if (types.length < 2) return types[0] ?? "something else";
  return `${types.slice(0, -1).join(", ")} or ${types[types.length - 1]}`;
}
