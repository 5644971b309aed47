// Writes the PNG of a screenshot again in at most a given number of bytes.

import { deflateSync, inflateSync } from "node:zlib";
import { paletteOf } from "./palette.mjs";

const SIGNATURE = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const TRUE_COLOR = 2;
const INDEXED = 3;
const TRUE_COLOR_ALPHA = 6;
const FILTERS = [0, 1, 2, 3, 4];
const MOST_COLORS = 256;

/**
 * The same picture without alpha and, only where it is needed to stay within `most` bytes, with at most 256 colors. Takes
 * what Chromium writes: 8 bits per channel, not interlaced, opaque. Throws if it stays larger.
 */
export function shrink(png, most) {
  const { width, height, pixels } = read(png);
  const exact = write({ width, height, color: TRUE_COLOR, bytes: pixels });
  if (exact.length <= most) return exact;
  const { palette, indexes } = paletteOf(pixels, width, MOST_COLORS);
  const fewer = write({ width, height, color: INDEXED, bytes: indexes, palette });
  if (fewer.length > most) throw new Error(`The picture needs more than ${most} bytes.`);
  return fewer;
}

function write({ width, height, color, bytes, palette }) {
  const channels = color === INDEXED ? 1 : 3;
  // Neighbors among indexes say nothing of each other.
  const filters = color === INDEXED ? [0] : FILTERS;
  const rows = [];
  for (let y = 0; y < height; y++) rows.push(filtered(bytes, width * channels, y, channels, filters));
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, color, 0, 0, 0], 8);
  const data = deflateSync(Buffer.concat(rows), { level: 9, memLevel: 9 });
  const parts = [chunk("IHDR", head), ...(palette ? [chunk("PLTE", palette)] : []), chunk("IDAT", data)];
  return Buffer.concat([SIGNATURE, ...parts, chunk("IEND", Buffer.alloc(0))]);
}

/** A row with the filter before it that leaves the smallest differences, which pack best. */
function filtered(bytes, stride, y, channels, filters) {
  let [best, least] = [undefined, Infinity];
  for (const filter of filters) {
    const row = Buffer.alloc(stride + 1);
    row[0] = filter;
    let sum = 0;
    for (let x = 0; x < stride; x++) {
      row[x + 1] = bytes[y * stride + x] - predicted(filter, ...neighbors(bytes, stride, y, x, channels));
      sum += Math.min(row[x + 1], 256 - row[x + 1]);
    }
    if (sum < least) [best, least] = [row, sum];
  }
  return best;
}

/** The bytes to the left, above, and above to the left; 0 outside. */
function neighbors(bytes, stride, y, x, channels) {
  const at = y * stride + x;
  const up = y > 0 ? bytes[at - stride] : 0;
  return x >= channels ? [bytes[at - channels], up, y > 0 ? bytes[at - channels - stride] : 0] : [0, up, 0];
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
      const expected = predicted(filter, ...neighbors(result, stride, y, x, channels));
      result[y * stride + x] = data[y * (stride + 1) + 1 + x] + expected;
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
