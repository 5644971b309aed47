// Places nodes in layers from left to right: sources left, wires as short as a few sweeps make them.

import type { Position } from "./document";
import type { ViewGraph, ViewNode } from "./graph";

/** Measures of a drawn node in pixels; the style sheet uses the same (graph.css). */
export const NODE_WIDTH = 208;
export const PILL_WIDTH = 140;
export const PILL_HEIGHT = 28;
export const HEADER_HEIGHT = 34;
export const ROW_HEIGHT = 24;
const NODE_PADDING = 12;
const MESSAGE_HEIGHT = 80;

/** More sockets would have no room on a pill to be hit. */
const MOST_PILL_INPUTS = 2;

const COLUMN_GAP = 32;
const ROW_GAP = 22;
const SWEEPS = 8;

type Drawn = Pick<ViewGraph, "nodes" | "wires">;
type HeightOf = (node: ViewNode) => number;

/** A node on which nothing could be changed, for all that it is given comes by wires: it is drawn as its title alone. */
export function isPill({ known, collapsed, inputs, outputs }: ViewNode): boolean {
  const isWired = inputs.length > 0 && inputs.length <= MOST_PILL_INPUTS && inputs.every((row) => row.linked);
  return known && !collapsed && isWired && outputs.length === 1;
}

export function nodeWidth(node: ViewNode): number {
  return isPill(node) ? PILL_WIDTH : NODE_WIDTH;
}

/** Height of one of the sockets on a side of a pill, from its top. */
export function pillSocket(index: number, count: number): number {
  return (PILL_HEIGHT * (index + 0.5)) / count;
}

/** Height of a node with its inputs folded. */
export function nodeHeight(node: ViewNode): number {
  if (isPill(node)) return PILL_HEIGHT;
  if (node.collapsed) return HEADER_HEIGHT;
  const rows = node.inputs.length + node.outputs.length + (node.folded.length > 0 ? 1 : 0);
  return HEADER_HEIGHT + NODE_PADDING + rows * ROW_HEIGHT;
}

/** Height to keep free for a node: with the line that says what it needs, while it needs something. */
export function roomFor(node: ViewNode, height = nodeHeight(node)): number {
  return height + (node.inputs.some((row) => row.required && row.isDefault) ? MESSAGE_HEIGHT : 0);
}

/** Height of a node with all its inputs shown. */
export function fullHeight(node: ViewNode): number {
  return nodeHeight({ ...node, inputs: [...node.inputs, ...node.folded] });
}

/** These nodes of a graph and the wires among them. */
export function partOf({ nodes, wires }: Drawn, ids: ReadonlySet<string>): Drawn {
  return {
    nodes: nodes.filter(({ id }) => ids.has(id)),
    wires: wires.filter(({ from, to }) => ids.has(from) && ids.has(to)),
  };
}

/** A position for every node; no two nodes overlap. Cycles do no harm. */
export function layeredLayout(graph: Drawn, heightOf = nodeHeight): Map<string, Position> {
  const columns = columnsOf(graph);
  const neighbors = neighborsOf(graph, heightOf);
  const centers = new Map<string, number>();
  for (const column of columns)
    stack(
      column,
      column.map((_, index) => index * 1e-3),
      centers,
      heightOf,
    );
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    const forward = sweep % 2 === 0;
    for (const column of forward ? columns : [...columns].reverse()) {
      const wanted = column.map((node) => mean(neighbors.get(node.id) ?? [], centers) ?? centers.get(node.id) ?? 0);
      stack(column, wanted, centers, heightOf);
    }
  }
  return positions(columns, centers, heightOf);
}

/** Nodes by distance: each one stands left of everything it feeds, as far right as that allows. */
function columnsOf(graph: Drawn): ViewNode[][] {
  const order = topological(graph);
  const targets = new Map<string, string[]>();
  for (const wire of graph.wires) push(targets, wire.from, wire.to);
  const depth = new Map<string, number>();
  const rank = new Map(order.map((id, index) => [id, index]));
  for (const id of [...order].reverse()) {
    let deepest = 0;
    for (const target of targets.get(id) ?? []) {
      // A wire against the order closes a cycle; it does not move anything.
      if ((rank.get(target) ?? 0) > (rank.get(id) ?? 0)) deepest = Math.max(deepest, 1 + (depth.get(target) ?? 0));
    }
    depth.set(id, deepest);
  }
  const last = Math.max(0, ...depth.values());
  const columns: ViewNode[][] = Array.from({ length: last + 1 }, () => []);
  for (const node of graph.nodes) columns[last - (depth.get(node.id) ?? 0)]?.push(node);
  return columns.filter((column) => column.length > 0);
}

/** Kahn's order; what a cycle leaves over follows in document order. */
function topological(graph: Drawn): string[] {
  const waiting = new Map(graph.nodes.map((node) => [node.id, 0]));
  const targets = new Map<string, string[]>();
  for (const wire of graph.wires) {
    if (!waiting.has(wire.from) || !waiting.has(wire.to)) continue;
    waiting.set(wire.to, (waiting.get(wire.to) ?? 0) + 1);
    push(targets, wire.from, wire.to);
  }
  const order = graph.nodes.filter((node) => waiting.get(node.id) === 0).map((node) => node.id);
  for (let at = 0; at < order.length; at++) {
    for (const target of targets.get(order[at] ?? "") ?? []) {
      const left = (waiting.get(target) ?? 0) - 1;
      waiting.set(target, left);
      if (left === 0) order.push(target);
    }
  }
  const done = new Set(order);
  for (const node of graph.nodes) if (!done.has(node.id)) order.push(node.id);
  return order;
}

/** A wire as one of its nodes sees it: the node at the other end, and how far below it the wire runs straight. */
interface Neighbor {
  id: string;
  shift: number;
}

function neighborsOf(graph: Drawn, heightOf: HeightOf): Map<string, Neighbor[]> {
  const nodes = new Map(graph.nodes.map((node) => [node.id, node]));
  const neighbors = new Map<string, Neighbor[]>();
  for (const wire of graph.wires) {
    const [from, to] = [nodes.get(wire.from), nodes.get(wire.to)];
    if (!from || !to) continue;
    const shift = inputHeight(to, wire.input, heightOf) - outputHeight(from, wire.output, heightOf);
    push(neighbors, wire.from, { id: wire.to, shift });
    push(neighbors, wire.to, { id: wire.from, shift: -shift });
  }
  return neighbors;
}

/** Height of an input's socket below the node's center. */
function inputHeight(node: ViewNode, name: string, heightOf: HeightOf): number {
  const row = node.inputs.findIndex((input) => input.name === name);
  if (isPill(node)) return pillSocket(row, node.inputs.length) - PILL_HEIGHT / 2;
  return HEADER_HEIGHT + NODE_PADDING / 2 + (row + 0.5) * ROW_HEIGHT - heightOf(node) / 2;
}

/** Height of an output's socket below the node's center; outputs are the last rows. */
function outputHeight(node: ViewNode, name: string, heightOf: HeightOf): number {
  const row = node.outputs.findIndex((output) => output.name === name);
  if (isPill(node)) return 0;
  return heightOf(node) / 2 - NODE_PADDING / 2 - (node.outputs.length - row - 0.5) * ROW_HEIGHT;
}

/** Sorts a column by the wanted centers and moves its nodes apart as little as keeps them from overlapping. */
function stack(column: ViewNode[], wanted: number[], centers: Map<string, number>, heightOf: HeightOf): void {
  const items = column.map((node, index) => ({ node, wanted: wanted[index] ?? 0, half: heightOf(node) / 2 }));
  items.sort((a, b) => a.wanted - b.wanted);
  // Blocks of touching nodes sit at the mean of what their members want (as in isotonic regression).
  const blocks: { start: number; size: number; sum: number; height: number; members: typeof items }[] = [];
  for (const item of items) {
    const height = 2 * item.half + ROW_GAP;
    let block = { start: item.wanted - height / 2, size: 1, sum: item.wanted - height / 2, height, members: [item] };
    for (let above = blocks.at(-1); above && above.start + above.height > block.start; above = blocks.at(-1)) {
      blocks.pop();
      const offset = above.height;
      block = {
        size: above.size + block.size,
        sum: above.sum + block.sum - offset * block.size,
        height: above.height + block.height,
        members: [...above.members, ...block.members],
        start: 0,
      };
      block.start = block.sum / block.size;
    }
    blocks.push(block);
  }
  column.length = 0;
  for (const block of blocks) {
    let top = block.start;
    for (const { node, half } of block.members) {
      centers.set(node.id, top + half + ROW_GAP / 2);
      top += 2 * half + ROW_GAP;
      column.push(node);
    }
  }
}

function positions(columns: ViewNode[][], centers: Map<string, number>, heightOf: HeightOf): Map<string, Position> {
  const places = new Map<string, Position>();
  let x = 0;
  for (const column of columns) {
    for (const node of column) {
      const y = (centers.get(node.id) ?? 0) - heightOf(node) / 2;
      places.set(node.id, { x, y: Math.round(y) });
    }
    x += Math.max(...column.map(nodeWidth)) + COLUMN_GAP;
  }
  return places;
}

/** Where a node's wires would run straight, on average. */
function mean(neighbors: Neighbor[], centers: Map<string, number>): number | undefined {
  if (neighbors.length === 0) return undefined;
  return neighbors.reduce((sum, { id, shift }) => sum + (centers.get(id) ?? 0) + shift, 0) / neighbors.length;
}

function push<Value>(map: Map<string, Value[]>, key: string, value: Value): void {
  const list = map.get(key);
  if (list) list.push(value);
  else map.set(key, [value]);
}
