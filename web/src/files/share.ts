// A graph inside of a link: its JSON, deflated, in the letters that an address may hold. What comes out of a link was
// written by anyone, so its size is bounded before it is read.

import { isObject, type Json, type JsonObject, parseJsonBytes } from "../model/json";

/** Longer links are cut off by mail programs and chats; a file is better then. */
export const LONGEST_LINK = 8000;
const LONGEST_INPUT = 64_000;
const LARGEST_GRAPH = 4_000_000;

/** The text behind "#g=". */
export async function packGraph(json: JsonObject): Promise<string> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(json)), new CompressionStream("deflate-raw"));
  let letters = "";
  for (let at = 0; at < packed.length; at += 4096) letters += String.fromCharCode(...packed.subarray(at, at + 4096));
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The graph behind "#g=", or a sentence that says why there is none. */
export async function unpackGraph(text: string): Promise<{ json: JsonObject } | { error: string }> {
  if (text.length > LONGEST_INPUT) return { error: "The link is too long to hold a graph." };
  if (!/^[\w-]+$/.test(text)) return { error: "The link is damaged: it holds letters that no link of ours has." };
  let json: Json;
  try {
    const letters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    const packed = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const bytes = await through(packed, new DecompressionStream("deflate-raw"));
    json = parseJsonBytes(bytes);
  } catch (error) {
    if (error instanceof RangeError) return { error: "The graph in the link is too large." };
    return { error: "The link is damaged or was cut short." };
  }
  return isObject(json) ? { json } : { error: "The link holds no graph." };
}

/** Runs bytes through a stream; throws a RangeError when more comes out than any graph has. */
async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const writer = (stream.writable as WritableStream<Uint8Array>).getWriter();
  // What goes wrong here also ends the reading below, which reports it.
  writer
    .write(bytes)
    .then(() => writer.close())
    .catch(() => undefined);
  const reader = (stream.readable as ReadableStream<Uint8Array>).getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > LARGEST_GRAPH) {
      void reader.cancel();
      throw new RangeError("too large");
    }
    parts.push(value);
  }
  const whole = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
