// The document as it is taken away: what is seen is what is saved, so the values of the form become the defaults.

import type { GraphDocument } from "../model/document";
import { asObject, type JsonObject } from "../model/json";
import type { ParameterValues } from "../model/parameters";

/** The document's JSON with the present values as the defaults of its parameters. */
export function documentWithValues({ json }: GraphDocument, values: ParameterValues): JsonObject {
  const names = Object.keys(values);
  if (names.length === 0) return json;
  const parameters = { ...asObject(json["parameters"]) };
  for (const name of names) {
    if (Object.hasOwn(parameters, name)) parameters[name] = { ...asObject(parameters[name]), default: values[name] };
  }
  return { ...json, parameters };
}

/** The text of a saved file: one member a line, so that versions can be compared. */
export function documentText(json: JsonObject): string {
  return `${JSON.stringify(json, null, 2)}\n`;
}
