// The GLB container: a header, a chunk of JSON and a chunk of binary data. Knows neither three nor the browser.

import { isObject, type Json, type JsonObject, parseJsonBytes } from "./json";

export interface Glb {
  json: JsonObject;
  /** Shares the file's memory; empty without a binary chunk. */
  binary: Uint8Array<ArrayBuffer>;
}

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/** True if the bytes begin as a GLB does. */
export function isGlb(bytes: Uint8Array): boolean {
  return bytes.length >= 4 && new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true) === MAGIC;
}

/** Takes a GLB apart. Throws with a readable message if it is none, of another version, or cut short. */
export function splitGlb(bytes: Uint8Array<ArrayBuffer>): Glb {
  if (!isGlb(bytes)) throw new Error("This is no GLB file.");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const word = (at: number): number => {
    if (at + 4 > bytes.length) throw new Error("The GLB file is cut short.");
    return view.getUint32(at, true);
  };
  if (word(4) !== 2) throw new Error(`GLB version ${word(4)} is not read here.`);
  const length = word(8);
  if (length > bytes.length) throw new Error("The GLB file is cut short.");
  let json: JsonObject | undefined;
  let binary: Uint8Array<ArrayBuffer> = new Uint8Array();
  for (let at = HEADER_BYTES; at + CHUNK_HEADER_BYTES <= length; ) {
    const size = word(at);
    const type = word(at + 4);
    const start = at + CHUNK_HEADER_BYTES;
    if (start + size > length) throw new Error("The GLB file is cut short.");
    const chunk = bytes.subarray(start, start + size);
    if (type === JSON_CHUNK && !json) json = readJson(chunk);
    else if (type === BINARY_CHUNK && binary.length === 0) binary = chunk;
    at = start + size;
  }
  if (!json) throw new Error("The GLB file has no description.");
  return { json, binary };
}

/** A GLB of a description and its data. */
export function joinGlb({ json, binary }: Glb): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const chunks: [number, Uint8Array, number][] = [[JSON_CHUNK, text, 0x20]];
  if (binary.length > 0) chunks.push([BINARY_CHUNK, binary, 0]);
  const padded = (size: number): number => Math.ceil(size / 4) * 4;
  const length = chunks.reduce((sum, [, data]) => sum + CHUNK_HEADER_BYTES + padded(data.length), HEADER_BYTES);
  const bytes = new Uint8Array(length);
  const view = new DataView(bytes.buffer);
  for (const [at, word] of [MAGIC, 2, length].entries()) view.setUint32(4 * at, word, true);
  let at = HEADER_BYTES;
  for (const [type, data, filler] of chunks) {
    const size = padded(data.length);
    view.setUint32(at, size, true);
    view.setUint32(at + 4, type, true);
    bytes.fill(filler, at + CHUNK_HEADER_BYTES, at + CHUNK_HEADER_BYTES + size);
    bytes.set(data, at + CHUNK_HEADER_BYTES);
    at += CHUNK_HEADER_BYTES + size;
  }
  return bytes;
}

function readJson(chunk: Uint8Array<ArrayBuffer>): JsonObject {
  let json: Json;
  try {
    json = parseJsonBytes(chunk);
  } catch {
    throw new Error("The description in the GLB file cannot be read.");
  }
  if (!isObject(json)) throw new Error("The description in the GLB file cannot be read.");
  return json;
}
