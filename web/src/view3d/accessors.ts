// Numbers out of a GLB's binary chunk. Everything is checked against the chunk's size before it is read.

import { asNumber, asString, type Json } from "../model/json";
import type { Glb } from "./glb";
import { entry } from "./gltf";

/** Values of an attribute, `size` numbers each; normalized integers stand for shares of 1. */
export interface Values {
  array: ValueArray;
  size: number;
  normalized: boolean;
}

export type ValueArray =
  | Int8Array<ArrayBuffer>
  | Uint8Array<ArrayBuffer>
  | Int16Array<ArrayBuffer>
  | Uint16Array<ArrayBuffer>
  | Uint32Array<ArrayBuffer>
  | Float32Array<ArrayBuffer>;

/** Kinds of numbers by their glTF code. */
export const COMPONENTS = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
} as const;

const SIZES: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** The bytes of a buffer view; they share the file's memory. */
export function readView(glb: Glb, index: Json): Uint8Array<ArrayBuffer> {
  const view = entry(glb, "bufferViews", index);
  const start = asNumber(view["byteOffset"]) ?? 0;
  const length = asNumber(view["byteLength"]) ?? -1;
  if (!isCount(start) || !isCount(length) || start + length > glb.binary.length || (view["buffer"] ?? 0) !== 0) {
    throw new Error("The model points outside of its data.");
  }
  return glb.binary.subarray(start, start + length);
}

/** The values of an accessor as memory of their own. Throws for sparse ones and those without data. */
export function readAccessor(glb: Glb, index: Json): Values {
  const accessor = entry(glb, "accessors", index);
  const size = SIZES[asString(accessor["type"])];
  const Numbers = COMPONENTS[accessor["componentType"] as keyof typeof COMPONENTS];
  const count = asNumber(accessor["count"]) ?? -1;
  if (!size || !Numbers || !isCount(count)) throw new Error("The model has values of an unknown kind.");
  if (accessor["sparse"] !== undefined) throw new Error("The model has sparse values, which are not read here.");
  const bytes = readView(glb, accessor["bufferView"]);
  const offset = asNumber(accessor["byteOffset"]) ?? 0;
  const row = size * Numbers.BYTES_PER_ELEMENT;
  const stride = asNumber(entry(glb, "bufferViews", accessor["bufferView"])["byteStride"]) ?? row;
  const isInside = isCount(offset) && stride >= row && (count === 0 || offset + stride * (count - 1) + row <= bytes.length);
  if (!isInside) throw new Error("The model points outside of its data.");
  const packed = new Uint8Array(count * row);
  if (stride === row) packed.set(bytes.subarray(offset, offset + count * row));
  else
    for (let at = 0; at < count; at++) {
      packed.set(bytes.subarray(offset + at * stride, offset + at * stride + row), at * row);
    }
  return { array: new Numbers(packed.buffer), size, normalized: accessor["normalized"] === true };
}

function isCount(value: number): boolean {
  return Number.isInteger(value) && value >= 0;
}
