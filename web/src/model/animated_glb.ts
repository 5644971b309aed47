// A GLB whose nodes are steps in time: an animation shows one after the other. What a step is comes from the server, as
// a file with a node for each variant; here only the animation is added.

import { joinGlb, splitGlb } from "./glb";
import { asArray, asNumber, asObject, isObject, type JsonObject } from "./json";

const FLOAT = 5126;
const SHOWN = [1, 1, 1];
/** Nothing is left of what is scaled to nothing; every viewer knows how to do it. */
const HIDDEN = [0, 0, 0];

/**
 * The same file with an animation that shows its variants in turn, `seconds` each. Variants are the nodes with an
 * `index` in their extras; `order` says which are shown when, by these indices. Throws if there are none.
 */
export function withAnimation(
  bytes: Uint8Array<ArrayBuffer>,
  order: readonly number[],
  seconds: number,
): Uint8Array<ArrayBuffer> {
  const { json, binary } = splitGlb(bytes);
  const nodes = asArray(json["nodes"]).map(asObject);
  const places = new Map<number, number>();
  nodes.forEach((node, place) => {
    const index = asNumber(asObject(node["extras"])["index"]);
    if (index !== undefined && !places.has(index)) places.set(index, place);
  });
  if (places.size === 0) throw new Error("The file has no steps to show one after the other.");
  // A step that could not be made would be a moment of nothing.
  const shownOrder = order.filter((index) => places.has(index));
  const data = new Data(json, binary);
  const samplers: JsonObject[] = [];
  const channels: JsonObject[] = [];
  for (const [index, place] of places) {
    const { times, shown } = timesOf(index, shownOrder, seconds);
    const input = data.scalars(times);
    const output = data.triples(shown.map((isShown) => (isShown ? SHOWN : HIDDEN)));
    channels.push({ sampler: samplers.length, target: { node: place, path: "scale" } });
    samplers.push({ input, output, interpolation: "STEP" });
    // Who plays no animations shows the first step.
    nodes[place] = { ...nodes[place], scale: index === shownOrder[0] ? SHOWN : HIDDEN };
  }
  const animations = [{ name: "Steps", samplers, channels }];
  return joinGlb(data.finish({ ...json, nodes, animations }));
}

/** When a step comes and goes: only the times at which something changes, from the beginning to the end. */
function timesOf(index: number, order: readonly number[], seconds: number): { times: number[]; shown: boolean[] } {
  const [times, shown]: [number[], boolean[]] = [[], []];
  order.forEach((now, at) => {
    const isShown = now === index;
    if (at > 0 && isShown === shown.at(-1)) return;
    times.push(at * seconds);
    shown.push(isShown);
  });
  // All channels end together, so that the last step is seen as long as the others.
  times.push(order.length * seconds);
  shown.push(shown.at(-1) ?? false);
  return { times, shown };
}

/** The binary chunk while accessors are put behind what is there. */
class Data {
  private readonly parts: Uint8Array[];
  private length: number;
  private readonly views: JsonObject[];
  private readonly accessors: JsonObject[];

  constructor(json: JsonObject, binary: Uint8Array) {
    this.views = asArray(json["bufferViews"]).filter(isObject);
    this.accessors = asArray(json["accessors"]).filter(isObject);
    const length = Math.ceil(binary.length / 4) * 4;
    this.parts = [binary, new Uint8Array(length - binary.length)];
    this.length = length;
  }

  scalars(values: readonly number[]): number {
    return this.add(values, { type: "SCALAR", count: values.length, min: [values[0]], max: [values.at(-1)] });
  }

  triples(values: readonly (readonly number[])[]): number {
    return this.add(values.flat(), { type: "VEC3", count: values.length });
  }

  finish(json: JsonObject): { json: JsonObject; binary: Uint8Array<ArrayBuffer> } {
    const binary = new Uint8Array(this.length);
    let at = 0;
    for (const part of this.parts) {
      binary.set(part, at);
      at += part.length;
    }
    const buffers = [{ byteLength: this.length }];
    return { json: { ...json, buffers, bufferViews: this.views, accessors: this.accessors }, binary };
  }

  private add(numbers: readonly number[], accessor: JsonObject): number {
    const floats = new Float32Array(numbers);
    const view = this.views.length;
    this.views.push({ buffer: 0, byteOffset: this.length, byteLength: floats.byteLength });
    this.parts.push(new Uint8Array(floats.buffer));
    this.length += floats.byteLength;
    this.accessors.push({ bufferView: view, componentType: FLOAT, ...accessor });
    return this.accessors.length - 1;
  }
}
