// The parameters of a graph: what the Controls form shows and what is sent beside the graph.

import { asArray, asNumber, asString, isNumber, type Json, type JsonObject } from "./json";

export type ParameterType = "number" | "integer" | "boolean" | "choice" | "vector" | "color" | "text";

/** A parameter's value: number, boolean, text (choice, color) or three numbers (vector, color). */
export type ParameterValue = number | boolean | string | number[];

/** The values that differ from the document's defaults, by parameter name. */
export type ParameterValues = Readonly<Record<string, ParameterValue>>;

export interface Parameter {
  name: string;
  type: ParameterType;
  initial: ParameterValue;
  minimum?: number;
  maximum?: number;
  step?: number;
  unit: string;
  label: string;
  description: string;
  choices: string[];
  /** An input of a group that has no default: it is given by wires only. */
  isWireOnly: boolean;
}

const KNOWN_TYPES: readonly string[] = ["number", "integer", "boolean", "choice", "vector", "color", "text"];

/** Reads one entry of the document's `parameters`; an unknown type is edited as text. */
export function readParameter(name: string, item: JsonObject): Parameter {
  const type = asString(item["type"]);
  const known = (KNOWN_TYPES.includes(type) ? type : "text") as ParameterType;
  return {
    name,
    type: known,
    initial: readValue(known, item["default"]),
    minimum: asNumber(item["min"]) ?? asNumber(item["minimum"]),
    maximum: asNumber(item["max"]) ?? asNumber(item["maximum"]),
    step: asNumber(item["step"]),
    unit: asString(item["unit"]),
    label: asString(item["label"]) || sentenceCase(name),
    description: asString(item["description"]),
    choices: asArray(item["choices"]).map(asString),
    isWireOnly: type === "link",
  };
}

/** The value in use: the changed one, else the default. */
export function parameterValue(parameter: Parameter, values: ParameterValues): ParameterValue {
  return values[parameter.name] ?? parameter.initial;
}

/** `values` with one parameter set; a value equal to the default is taken out, so that equal graphs send equal bodies. */
export function withValue(values: ParameterValues, parameter: Parameter, value: ParameterValue): ParameterValues {
  const next: Record<string, ParameterValue> = { ...values };
  if (sameValue(value, parameter.initial)) delete next[parameter.name];
  else next[parameter.name] = value;
  return next;
}

export function sameValue(a: ParameterValue, b: ParameterValue): boolean {
  if (Array.isArray(a) && Array.isArray(b)) return a.length === b.length && a.every((x, i) => x === b[i]);
  return a === b;
}

/** The same parameters with the same values. */
export function sameValues(a: ParameterValues, b: ParameterValues): boolean {
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => isSameAt(name, a, b));
}

function isSameAt(name: string, a: ParameterValues, b: ParameterValues): boolean {
  const [one, other] = [a[name], b[name]];
  return one !== undefined && other !== undefined && sameValue(one, other);
}

/** The step of arrows and drags: the declared one, else a hundredth of the range, else one or a hundredth. */
export function stepOf(parameter: Parameter): number {
  if (parameter.type === "integer") return Math.max(1, Math.round(parameter.step ?? 1));
  if (parameter.step !== undefined && parameter.step > 0) return parameter.step;
  if (parameter.minimum !== undefined && parameter.maximum !== undefined) {
    const range = parameter.maximum - parameter.minimum;
    if (range > 0) return 10 ** Math.floor(Math.log10(range / 100));
  }
  return 0.01;
}

/** Rounds to the nearest multiple of `step` without the noise of binary fractions. */
export function snap(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toFixed(decimalsOf(step)));
}

/** Decimals needed to write multiples of `step`, 0 to 10. */
export function decimalsOf(step: number): number {
  for (let decimals = 0; decimals < 10; decimals++) {
    const scaled = step * 10 ** decimals;
    if (Math.abs(scaled - Math.round(scaled)) < 1e-9 * Math.max(1, scaled)) return decimals;
  }
  return 10;
}

/** Keeps a number inside the declared bounds; used by drags, not by typing. */
export function clamp(parameter: Parameter, value: number): number {
  return Math.min(parameter.maximum ?? Infinity, Math.max(parameter.minimum ?? -Infinity, value));
}

/** "#rrggbb" for a color given as text, or as linear red, green, blue (and alpha) from 0 to 1. */
export function colorText(value: ParameterValue): string {
  if (typeof value === "string" && /^#[0-9a-f]{6}$/i.test(value)) return value.toLowerCase();
  if (!Array.isArray(value)) return "#808080";
  const part = (x: number | undefined): string => {
    const linear = Math.min(1, Math.max(0, x ?? 0));
    const encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
    return Math.round(255 * encoded)
      .toString(16)
      .padStart(2, "0");
  };
  return `#${[0, 1, 2].map((i) => part(value[i])).join("")}`;
}

/** The color in the notation the document uses for this parameter. */
export function colorValue(text: string, like: ParameterValue): ParameterValue {
  if (!Array.isArray(like)) return text;
  const rgb = [1, 3, 5].map((at) => {
    const encoded = parseInt(text.slice(at, at + 2), 16) / 255;
    const linear = encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
    return Number(linear.toFixed(5));
  });
  return like.length === 4 ? [...rgb, like[3] ?? 1] : rgb;
}

function readValue(type: ParameterType, value: Json): ParameterValue {
  switch (type) {
    case "number":
    case "integer":
      return isNumber(value) ? value : 0;
    case "boolean":
      return value === true;
    case "vector":
      return [0, 1, 2].map((i) => asNumber(asArray(value)[i]) ?? 0);
    case "color":
      return Array.isArray(value) ? value.map((x) => asNumber(x) ?? 0) : asString(value) || "#808080";
    default:
      return isNumber(value) || typeof value === "boolean" ? value : asString(value);
  }
}

/** A name as a label: "clip_radius" -> "Clip radius". */
export function sentenceCase(name: string): string {
  const words = name.replace(/[_-]+/g, " ").trim();
  return words.charAt(0).toUpperCase() + words.slice(1);
}
