// Node 18 has the streams of the browser, but not their format "deflate-raw"; its own zlib has. Imported for its effect.

import { type Duplex, Readable, Writable } from "node:stream";
import { createDeflateRaw, createInflateRaw } from "node:zlib";

function isKnown(): boolean {
  try {
    return Boolean(new CompressionStream("deflate-raw"));
  } catch {
    return false;
  }
}

/** A class like the browser's, made of a stream of Node. */
function streamOf(make: () => Duplex): typeof CompressionStream & typeof DecompressionStream {
  return class {
    constructor() {
      const stream = make();
      Object.assign(this, { readable: Readable.toWeb(stream), writable: Writable.toWeb(stream) });
    }
  } as unknown as typeof CompressionStream & typeof DecompressionStream;
}

if (!isKnown()) {
  globalThis.CompressionStream = streamOf(createDeflateRaw);
  globalThis.DecompressionStream = streamOf(createInflateRaw);
}
