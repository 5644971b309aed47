// The form's values as a document keeps them: beside the defaults, below `ui.values`, where they influence nothing that
// is computed. Whoever evaluates the document elsewhere gives them as parameters, or has the defaults.

import { asObject, isNumber, type Json, type JsonObject } from "./json";
import { type Parameter, type ParameterValue, type ParameterValues, sameValue } from "./parameters";

/** The document's JSON with the values that differ from the defaults; what was kept there before goes. */
export function documentWithValues({ json }: { json: JsonObject }, values: ParameterValues): JsonObject {
  const ui = asObject(json["ui"]);
  if (Object.keys(values).length > 0) return { ...json, ui: { ...ui, values: { ...values } } };
  return withoutValues(json);
}

/** The same JSON without values; the same object if there are none. */
export function withoutValues(json: JsonObject): JsonObject {
  const ui = asObject(json["ui"]);
  if (!Object.hasOwn(ui, "values")) return json;
  const { values: _, ...others } = ui;
  return { ...json, ui: others };
}

/** The values that stand in a document's `ui`. What fits no parameter, or equals its default, is left out. */
export function valuesIn(ui: Json, parameters: readonly Parameter[]): ParameterValues {
  const kept = asObject(asObject(ui)["values"]);
  const found: Record<string, ParameterValue> = {};
  for (const parameter of parameters) {
    const value = Object.hasOwn(kept, parameter.name) ? fitting(parameter, kept[parameter.name]) : undefined;
    if (value !== undefined && !sameValue(value, parameter.initial)) found[parameter.name] = value;
  }
  return found;
}

function fitting({ type, initial, choices }: Parameter, value: Json): ParameterValue | undefined {
  switch (type) {
    case "number":
    case "integer":
      return isNumber(value) ? value : undefined;
    case "boolean":
      return typeof value === "boolean" ? value : undefined;
    case "choice":
      return typeof value === "string" && choices.includes(value) ? value : undefined;
    case "vector":
      return numbers(value, 3);
    case "color":
      return Array.isArray(initial) ? numbers(value, initial.length) : typeof value === "string" ? value : undefined;
    default:
      return typeof value === "string" ? value : undefined;
  }
}

function numbers(value: Json, count: number): number[] | undefined {
  return Array.isArray(value) && value.length === count && value.every(isNumber) ? value : undefined;
}
