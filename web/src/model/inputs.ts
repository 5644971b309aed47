// How the literal at an input is edited.

import type { InputCard } from "./catalogue";
import { evaluateExpression } from "./expression";
import { numberText } from "./format";
import { isNumber, type Json } from "./json";
import { splitNumbers } from "./numbers";
import { type Parameter, type ParameterType, type ParameterValue, readParameter } from "./parameters";

/** The control for an input: that of a parameter of this type, or a line of several values. */
export type ControlKind = ParameterType | "list";

const KINDS: Readonly<Record<string, ParameterType>> = {
  number: "number",
  integer: "integer",
  vector: "vector",
  point: "vector",
  boolean: "boolean",
  choice: "choice",
  text: "text",
  color: "color",
};

/** The control for an input, or undefined where nothing but a wire can stand. */
export function controlKind(card: InputCard, literal: Json): ControlKind | undefined {
  if (card.linksOnly) return undefined;
  const kind = card.types.map((type) => KINDS[type]).find((found) => found !== undefined);
  if (kind === undefined) return undefined;
  if (card.several && (kind === "number" || kind === "vector"))
    return isNumber(literal) && !card.required ? kind : "list";
  return kind;
}

/** A whole range of so few steps is one to slide through, without the catalogue saying so. */
const NARROW = 100;

/** The input as a parameter, so that one set of fields edits both. The range is that of the slider. */
export function asParameter(card: InputCard, kind: ParameterType): Parameter {
  const parameter = readParameter(card.name, { type: kind, default: card.fallback ?? undefined });
  const { minimum = -Infinity, maximum = Infinity } = card;
  const isNarrow = kind === "integer" && card.softMaximum === undefined && maximum - minimum <= NARROW;
  return {
    ...parameter,
    label: card.title,
    description: card.description,
    choices: card.choices,
    unit: card.unit,
    step: card.step,
    minimum: card.softMinimum ?? (card.softMaximum === undefined && !isNarrow ? undefined : card.minimum),
    maximum: isNarrow ? maximum : card.softMaximum,
  };
}

/** A value that was dragged stays within what the server accepts; the slider's range does not bind it. */
export function withinHard(card: InputCard, value: number): number {
  return Math.min(card.maximum ?? Infinity, Math.max(card.minimum ?? -Infinity, value));
}

/** The literal as the field's value. */
export function fieldValue(parameter: Parameter, literal: Json): ParameterValue {
  return readParameter(parameter.name, { type: parameter.type, default: literal }).initial;
}

/** "1, -1, 1" or "(0, 0, 1) (1, 0, 0)". */
export function listText(literal: Json): string {
  if (isNumber(literal)) return numberText(literal);
  if (!Array.isArray(literal)) return "";
  if (literal.some((item) => Array.isArray(item))) {
    return literal.map((item) => `(${listText(item)})`).join(" ");
  }
  return literal.map((item) => (isNumber(item) ? numberText(item) : "")).join(", ");
}

/** Reads numbers, or triples in parentheses; undefined if the text is neither. */
export function readList(text: string): Json {
  const groups = [...text.matchAll(/\(([^()]*)\)/g)].map(([, group = ""]) => group);
  if (!groups.some((group) => splitNumbers(group).length > 1)) return numbersIn(text);
  const rest = text.replace(/\([^()]*\)/g, "").replace(/[\s,;]/g, "");
  const triples = groups.map(numbersIn);
  return rest === "" && triples.every((triple) => triple?.length === 3) ? (triples as Json[]) : undefined;
}

function numbersIn(text: string): number[] | undefined {
  const values = splitNumbers(text).map((part) => evaluateExpression(part));
  return values.every((value) => value !== undefined) ? values : undefined;
}
