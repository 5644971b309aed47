// Writes the PNG of a screenshot again in at most a given number of bytes.

import { deflateSync, inflateSync } from "node:zlib";

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const TRUE_COLOR = 2;
const TRUE_COLOR_ALPHA = 6;
const FILTER_SUB = 1;
/** Coarser steps of brightness than this are seen. */
const COARSEST_STEP = 16;

/**
 * The same picture without alpha and, only where it is needed to stay within `most` bytes, with coarser colors. Takes
 * what Chromium writes: 8 bits per channel, not interlaced, opaque. Throws if it stays larger.
 */
export function shrink(png, most) {
  const picture = read(png);
  for (let step = 1; step <= COARSEST_STEP; step *= 2) {
    const result = write(picture, step);
    if (result.length <= most) return result;
  }
  throw new Error(`The picture needs more than ${most} bytes.`);
}

function write({ width, height, pixels }, step) {
  const stride = 3 * width;
  const coarse = pixels.map((value) => Math.min(255, Math.round(value / step) * step));
  const rows = Buffer.alloc(height * (stride + 1));
  for (let y = 0; y < height; y++) {
    const at = y * (stride + 1);
    rows[at] = FILTER_SUB;
    for (let x = 0; x < stride; x++) {
      rows[at + 1 + x] = coarse[y * stride + x] - (x >= 3 ? coarse[y * stride + x - 3] : 0);
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, TRUE_COLOR, 0, 0, 0], 8);
  const data = deflateSync(rows, { level: 9, memLevel: 9 });
  return Buffer.concat([SIGNATURE, chunk("IHDR", head), chunk("IDAT", data), chunk("IEND", Buffer.alloc(0))]);
}

/** Size and RGB bytes of a PNG. */
export function read(png) {
  if (!png.subarray(0, 8).equals(SIGNATURE)) throw new Error("This is no PNG.");
  const parts = [];
  let head;
  for (let at = 8; at < png.length; ) {
    const size = png.readUInt32BE(at);
    const type = png.toString("latin1", at + 4, at + 8);
    const data = png.subarray(at + 8, at + 8 + size);
    if (type === "IHDR") head = data;
    if (type === "IDAT") parts.push(data);
    at += 12 + size;
  }
  const [width, height] = [head.readUInt32BE(0), head.readUInt32BE(4)];
  const [depth, color, , , interlace] = head.subarray(8);
  if (depth !== 8 || interlace !== 0 || ![TRUE_COLOR, TRUE_COLOR_ALPHA].includes(color))
    throw new Error("This kind of PNG is not read.");
  const channels = color === TRUE_COLOR ? 3 : 4;
  const bytes = unfiltered(inflateSync(Buffer.concat(parts)), width * channels, height, channels);
  const pixels = Buffer.alloc(3 * width * height);
  for (let at = 0; at < width * height; at++) bytes.copy(pixels, 3 * at, channels * at, channels * at + 3);
  return { width, height, pixels };
}

function unfiltered(data, stride, height, channels) {
  const result = Buffer.alloc(stride * height);
  for (let y = 0; y < height; y++) {
    const filter = data[y * (stride + 1)];
    for (let x = 0; x < stride; x++) {
      const at = y * stride + x;
      const up = y > 0 ? result[at - stride] : 0;
      const [left, corner] =
        x >= channels ? [result[at - channels], y > 0 ? result[at - channels - stride] : 0] : [0, 0];
      result[at] = data[y * (stride + 1) + 1 + x] + predicted(filter, left, up, corner);
    }
  }
  return result;
}

/** What a filter of PNG (none, sub, up, average, Paeth) expects a byte to be. */
function predicted(filter, left, up, corner) {
  if (filter === 0) return 0;
  if (filter === 1) return left;
  if (filter === 2) return up;
  if (filter === 3) return (left + up) >> 1;
  const estimate = left + up - corner;
  const [byLeft, byUp, byCorner] = [left, up, corner].map((value) => Math.abs(estimate - value));
  if (byLeft <= byUp && byLeft <= byCorner) return left;
  return byUp <= byCorner ? up : corner;
}

function chunk(type, data) {
  const named = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const result = Buffer.alloc(named.length + 8);
  result.writeUInt32BE(data.length, 0);
  named.copy(result, 4);
  result.writeUInt32BE(crc(named), named.length + 4);
  return result;
}

function crc(bytes) {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let bit = 0; bit < 8; bit++) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  }
  return ~value >>> 0;
}
