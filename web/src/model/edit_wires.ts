// Changes of wires: drawing, taking off, healing the gap a removed node leaves, inserting a node into a wire.

import type { Catalogue, NodeCard } from "./catalogue";
import { accepts, type Connection, upstreamOf, WireCheck } from "./check";
import type { GraphDocument } from "./document";
import { changeNode, type Edit, removeNodes, setInput, withInput } from "./edit";
import { linkText } from "./edit_links";
import { withGroupOutputs } from "./group_outputs";
import { asObject, type Json } from "./json";

/** The end of a wire at an input, one of several where the input takes several. */
export interface WireEnd {
  to: string;
  input: string;
  index: number;
}

/**
 * Draws a wire. At an input that takes one it replaces what stood there; at one that takes several it comes behind the
 * others, or in the place of `replaced`. The first wire of several stands in a list, as one item of it, unless
 * `isFamily`: then the input is given the whole family.
 */
export function connect(
  catalogue: Catalogue,
  { from, output, to, input }: Connection,
  { replaced, isFamily = mayHaveAxes }: { replaced?: number; isFamily?: IsFamily } = {},
): Edit {
  return (document) => {
    const card = catalogue.nodes.get(document.nodes.get(to)?.type ?? "")?.inputs.find((item) => item.name === input);
    const outputs = catalogue.nodes.get(document.nodes.get(from)?.type ?? "")?.outputs ?? [];
    const link: Json = { from: linkText({ node: from, output: outputs.length > 1 ? output : undefined }) };
    if (!card?.several) return setInput(to, input, link)(document);
    const sources = document.nodes.get(to)?.inputs.get(input) ?? [];
    const present = asObject(asObject(asObject(document.scope["nodes"])[to])["inputs"])[input];
    // A list that is one literal, as weights, is spread, so that the wire becomes one more item.
    const items = present === undefined ? [] : Array.isArray(present) ? present : [present];
    if (replaced !== undefined && replaced < items.length) {
      if (!Array.isArray(present)) return setInput(to, input, link)(document);
      return setInput(
        to,
        input,
        items.map((item, index) => (index === replaced ? link : item)),
      )(document);
    }
    const isFirst = sources.length === 0;
    if (isFirst && isFamily(document, catalogue, from, output)) return setInput(to, input, link)(document);
    return setInput(to, input, [...items, link])(document);
  };
}

export type IsFamily = (document: GraphDocument, catalogue: Catalogue, node: string, output: string) => boolean;

/** Takes one wire off. */
export function disconnect({ to, input, index }: WireEnd): Edit {
  return (document) =>
    changeNode(document, to, (item) => {
      const present = asObject(item["inputs"])[input];
      if (!Array.isArray(present)) return withInput(item, input, undefined);
      const left = present.filter((_, at) => at !== index);
      return withInput(item, input, left.length > 0 ? left : undefined);
    });
}

/** Removes nodes, and joins what was before them to what was behind them where the types allow it. */
export function removeAndHeal(catalogue: Catalogue, ids: Iterable<string>): Edit {
  const gone = new Set(ids);
  return (document) => {
    const healed: { end: WireEnd; from: string; output: string }[] = [];
    for (const node of document.nodes.values()) {
      if (gone.has(node.id)) continue;
      for (const [input, sources] of node.inputs) {
        sources.forEach((source, index) => {
          if (source.kind !== "link" || !gone.has(source.node)) return;
          const before = sourceBefore(document, catalogue, gone, source.node);
          if (before) healed.push({ end: { to: node.id, input, index }, ...before });
        });
      }
    }
    let changed = document;
    for (const { end, from, output } of healed) {
      const { to, input, index } = end;
      const wire = { from, output, to, input };
      if (new WireCheck(changed, catalogue).refusal(wire) === undefined) {
        changed = connect(catalogue, wire, { replaced: index })(changed);
      }
    }
    // What leaves a group here is a wire as well.
    changed = withGroupOutputs(changed, (link) => {
      const before = gone.has(link.node) ? sourceBefore(document, catalogue, gone, link.node) : undefined;
      return before ? { node: before.from, output: before.output } : link;
    });
    return removeNodes(gone)(changed);
  };
}

/** The first input that takes the wire's type, and the first output that fits where the wire ends. */
export function socketsFor(
  document: GraphDocument,
  catalogue: Catalogue,
  card: NodeCard,
  wire: Connection,
): { input: string; output: string } | undefined {
  const offered = new WireCheck(document, catalogue).types.possible(wire.from, wire.output);
  const end = catalogue.nodes
    .get(document.nodes.get(wire.to)?.type ?? "")
    ?.inputs.find((input) => input.name === wire.input);
  if (!end) return undefined;
  for (const input of card.inputs) {
    if (!accepts(input, offered)) continue;
    const output = card.outputs.find((item) => accepts(end, item.sameAs === input.name ? offered : item.types));
    if (output) return { input: input.name, output: output.name };
  }
  return undefined;
}

/** Puts a node that is there into a wire. The document stays as it is if the types or a loop forbid it. */
export function insertOnWire(catalogue: Catalogue, node: string, wire: Connection & { index: number }): Edit {
  return (document) => {
    const card = catalogue.nodes.get(document.nodes.get(node)?.type ?? "");
    const sockets = card && socketsFor(document, catalogue, card, wire);
    if (!sockets || node === wire.from || node === wire.to) return document;
    const before: Connection = { from: wire.from, output: wire.output, to: node, input: sockets.input };
    const behind: Connection = { from: node, output: sockets.output, to: wire.to, input: wire.input };
    if (new WireCheck(document, catalogue).refusal(before) !== undefined) return document;
    const middle = connect(catalogue, before)(document);
    if (new WireCheck(middle, catalogue).refusal(behind) !== undefined) return document;
    return connect(catalogue, behind, { replaced: wire.index })(middle);
  };
}

/** Wires of an input that takes several become a list only if each is one value; the server alone knows for certain. */
function mayHaveAxes(document: GraphDocument, catalogue: Catalogue, node: string): boolean {
  for (const id of upstreamOf(document, node)) {
    const item = document.nodes.get(id);
    const card = catalogue.nodes.get(item?.type ?? "");
    // What makes an axis lets it be named, or is given a list.
    if (card?.inputs.some((input) => input.makesAxis)) return true;
    const lists = card?.inputs.filter((input) => input.several) ?? [];
    if (lists.some((input) => Array.isArray(literalOf(document, id, input.name)))) return true;
  }
  return false;
}

function literalOf(document: GraphDocument, node: string, input: string): Json {
  return asObject(asObject(asObject(document.scope["nodes"])[node])["inputs"])[input];
}

/** What feeds the first wired input of a removed node, through further removed nodes. */
function sourceBefore(
  document: GraphDocument,
  catalogue: Catalogue,
  gone: ReadonlySet<string>,
  id: string,
): { from: string; output: string } | undefined {
  const seen = new Set<string>();
  let node = id;
  while (!seen.has(node)) {
    seen.add(node);
    const item = document.nodes.get(node);
    const order = catalogue.nodes.get(item?.type ?? "")?.inputs.map((input) => input.name) ?? [];
    const link = order.flatMap((name) => item?.inputs.get(name) ?? []).find((source) => source.kind === "link");
    if (link?.kind !== "link") return undefined;
    if (!gone.has(link.node)) {
      const outputs = catalogue.nodes.get(document.nodes.get(link.node)?.type ?? "")?.outputs ?? [];
      const output = link.output ?? outputs[0]?.name;
      return output === undefined ? undefined : { from: link.node, output };
    }
    node = link.node;
  }
  return undefined;
}
