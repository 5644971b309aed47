// Reading unknown JSON without trusting its shape.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json } | undefined;
export type JsonObject = Record<string, Json>;

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
