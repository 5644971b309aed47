// Numbers and literals as the page writes them.

import type { Json } from "./json";

const THIN_SPACE = "\u202f";

/** 199712 -> "199 712". */
export function grouped(count: number): string {
  return String(Math.round(count)).replace(/\B(?=(\d{3})+$)/g, THIN_SPACE);
}

/** Bytes in B, kB or MB with three figures at most. */
export function byteText(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  if (bytes < 1e6) return `${(bytes / 1e3).toFixed(bytes < 1e4 ? 1 : 0)} kB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 2 : 1)} MB`;
}

/** Milliseconds with one decimal below 100. */
export function millisecondText(milliseconds: number): string {
  return `${milliseconds.toFixed(milliseconds < 100 ? 1 : 0)} ms`;
}

/** A number with at most `decimals` decimals and no trailing zeros; very large and small ones in powers of ten. */
export function numberText(value: number, decimals = 4): string {
  if (value !== 0 && (Math.abs(value) >= 1e7 || Math.abs(value) < 10 ** -decimals / 2)) {
    return value.toExponential(2).replace(/\.?0+e\+?/, "e");
  }
  return String(Number(value.toFixed(decimals)));
}

/** A literal of the document in one line: 1.5, (0, 0, 1), yes, a choice's name. Long lists are counted. */
export function literalText(value: Json): string {
  if (typeof value === "number") return numberText(value, 3);
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value === "string") return value;
  if (Array.isArray(value)) {
    if (value.length > 4 || value.some((item) => Array.isArray(item))) return `${value.length} values`;
    return `(${value.map(literalText).join(", ")})`;
  }
  return value === null || value === undefined ? "none" : "…";
}

/** A title as a file name: "Boosted ring" -> "boosted-ring". */
export function fileName(title: string): string {
  const plain = title
    .normalize("NFKD")
    .replace(/[\u0300-\u036f]/g, "")
    .toLowerCase();
  return (
    plain
      .replace(/[^a-z0-9]+/g, "-")
      .replace(/^-+|-+$/g, "")
      .slice(0, 60) || "model"
  );
}

export function plural(count: number, word: string): string {
  return `${grouped(count)} ${word}${count === 1 ? "" : "s"}`;
}

/** Meters in the unit that suits: "0.12 mm". */
export function lengthText(meters: number): string {
  const [factor, unit] = meters < 1e-3 ? [1e6, "µm"] : meters < 1 ? [1e3, "mm"] : [1, "m"];
  return `${Number((meters * Number(factor)).toPrecision(2))}\u202f${unit}`;
}
