// What is usually connected to what, learned from graphs that people have made: the likeliest node for a loose wire.

import type { Catalogue } from "./catalogue";
import { readDocument } from "./document";
import { viewGraph } from "./graph";
import type { Json } from "./json";
import type { Likelihood, LooseEnd } from "./search";

export class Habits implements Likelihood {
  /** How many wires of a type run from, or into, a socket of a node type. */
  private readonly counts = new Map<string, number>();

  constructor(catalogue: Catalogue, graphs: readonly Json[]) {
    for (const graph of graphs) {
      const read = readDocument(graph);
      if ("error" in read) continue;
      const { wires, byId } = viewGraph(read.document, catalogue);
      for (const { from, output, to, input, type } of wires) {
        this.count(keyOf(byId.get(to)?.type ?? "", input, "output", type));
        this.count(keyOf(byId.get(from)?.type ?? "", output, "input", type));
      }
    }
  }

  /** Grows slowly with how often such a wire ends at this socket; 0 for one that never does. */
  likelihood(card: string, socket: string, { side, types }: LooseEnd): number {
    const seen = types.reduce((sum, type) => sum + (this.counts.get(keyOf(card, socket, side, type)) ?? 0), 0);
    return 0.5 * Math.log2(1 + seen);
  }

  private count(key: string): void {
    this.counts.set(key, (this.counts.get(key) ?? 0) + 1);
  }
}

function keyOf(card: string, socket: string, side: string, type: string): string {
  return `${card} ${socket} ${side} ${type}`;
}
