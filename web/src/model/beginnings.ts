// Nodes to begin with: those that make something of nothing.

import type { Catalogue, NodeCard } from "./catalogue";
import type { JsonObject } from "./json";

/** Types worth beginning with, the likeliest first. */
export const FIRST_TYPES: readonly string[] = ["circle", "generator", "mesh"];

/** Node types that make only this type, and need nothing to do it. */
export function beginningsOf(catalogue: Catalogue, type: string): NodeCard[] {
  return [...catalogue.nodes.values()].filter(
    (card) => card.outputs[0]?.types.join() === type && card.inputs.every((input) => !input.required),
  );
}

/** How much of a node is set by hand in the view, against what has to be typed: the former is what one begins with. */
function easeOf({ inputs }: NodeCard): number {
  const handles = Math.min(inputs.filter(({ handle }) => handle !== undefined).length, 2);
  // Two handles are set at a glance; of more each is work.
  return 2.1 * handles - inputs.length;
}

/** The likeliest node to feed an input that takes these types. */
export function likelySource(catalogue: Catalogue, types: readonly string[]): NodeCard | undefined {
  const wanted = [...FIRST_TYPES.filter((type) => types.includes(type)), ...types];
  for (const type of wanted) {
    const [card] = beginningsOf(catalogue, type).sort(
      (a, b) =>
        Number(b.title.toLowerCase() === type) - Number(a.title.toLowerCase() === type) ||
        easeOf(b) - easeOf(a) ||
        a.title.length - b.title.length,
    );
    if (card) return card;
  }
  return undefined;
}

/** What a new node is given at its inputs, where that is not the default. */
export function beginningValues({ inputs }: NodeCard): JsonObject {
  return Object.fromEntries(
    inputs.flatMap(({ name, beginning }) => (beginning === undefined ? [] : [[name, beginning]])),
  ) as JsonObject;
}
