// Reading unknown JSON without trusting its shape.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json } | undefined;
export type JsonObject = Record<string, Json>;

/** Parses a text, with or without a byte order mark. Throws a SyntaxError where it is no JSON. */
export function parseJson(text: string): Json {
  return JSON.parse(text.startsWith("\uFEFF") ? text.slice(1) : text) as Json;
}

/** Parses UTF-8 bytes, with or without a byte order mark. Throws a TypeError where they are no UTF-8, else as above. */
export function parseJsonBytes(bytes: BufferSource): Json {
  return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)) as Json;
}

export function isObject(value: Json): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

export function isNumber(value: Json): value is number {
  return typeof value === "number" && Number.isFinite(value);
}

export function asObject(value: Json): JsonObject {
  return isObject(value) ? value : {};
}

export function asArray(value: Json): Json[] {
  return Array.isArray(value) ? value : [];
}

export function asString(value: Json): string {
  return typeof value === "string" ? value : "";
}

export function asNumber(value: Json): number | undefined {
  return isNumber(value) ? value : undefined;
}
