// Numbers that are typed with their unit: "3 mm" in a field of meters is 0.003, "1/4 turn" in one of degrees is 90.

import { evaluateExpression } from "./expression";

interface Unit {
  kind: "length" | "angle" | "share";
  /** In meters, degrees, or ones. */
  size: number;
}

const DEGREES = 180 / Math.PI;

const UNITS: Readonly<Record<string, Unit>> = {
  um: { kind: "length", size: 1e-6 },
  µm: { kind: "length", size: 1e-6 },
  mm: { kind: "length", size: 1e-3 },
  cm: { kind: "length", size: 1e-2 },
  dm: { kind: "length", size: 0.1 },
  m: { kind: "length", size: 1 },
  km: { kind: "length", size: 1000 },
  in: { kind: "length", size: 0.0254 },
  ft: { kind: "length", size: 0.3048 },
  "°": { kind: "angle", size: 1 },
  deg: { kind: "angle", size: 1 },
  degree: { kind: "angle", size: 1 },
  degrees: { kind: "angle", size: 1 },
  rad: { kind: "angle", size: DEGREES },
  turn: { kind: "angle", size: 360 },
  turns: { kind: "angle", size: 360 },
  "%": { kind: "share", size: 0.01 },
};

const NAMES = { length: "a length", angle: "an angle", share: "a share" } as const;
const EXAMPLES = { length: "3 mm", angle: "90 deg", share: "50 %" } as const;

/** A value in the unit of its field, or a sentence that says why the text is none. */
export type Quantity = { value: number } | { error: string };

/** Reads what was typed into a field whose numbers have `unit` behind them; empty for plain numbers. */
export function readQuantity(text: string, unit: string): Quantity {
  const plain = evaluateExpression(text);
  if (plain !== undefined) return { value: plain };
  const field = unit.trim();
  // A unit of a reciprocal, as 1/m, is only known as that of the field.
  if (field !== "" && text.trim().endsWith(field)) {
    const value = evaluateExpression(text.trim().slice(0, -field.length));
    if (value !== undefined) return { value };
  }
  const [, amount = "", name = ""] = /^(.*?[\d)\s.]|.*pi\s*|.*π\s*)\s*([A-Za-zµ°%]+)$/.exec(text.trim()) ?? [];
  const value = evaluateExpression(amount);
  if (value === undefined)
    return { error: `“${text}” is not a number${exampleFor(field)} or a formula such as 2*pi/3.` };
  const typed = UNITS[name];
  const own = field === "" ? UNITS["%"] : UNITS[field];
  if (!typed) return { error: `“${name}” is no unit that is known here${exampleFor(field)}.` };
  if (own?.kind !== typed.kind) return { error: `“${text}” is ${NAMES[typed.kind]}; ${fieldText(field)} is needed.` };
  // 1e-3 and its like are not exact; sixteen digits are not typed.
  return { value: Number(((value * typed.size) / (field === "" ? 1 : own.size)).toPrecision(14)) };
}

function exampleFor(field: string): string {
  const kind = field === "" ? undefined : UNITS[field]?.kind;
  return kind ? `, with a unit as in ${EXAMPLES[kind]},` : "";
}

function fieldText(field: string): string {
  if (field === "") return "a plain number";
  const own = UNITS[field];
  return own ? `${NAMES[own.kind]} in ${field === "°" ? "degrees" : field}` : `a number in ${field}`;
}
