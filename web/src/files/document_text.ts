import type { JsonObject } from "../model/json";

/** The text of a saved file: one member a line, so that versions can be compared. */
export function documentText(json: JsonObject): string {
  return `${JSON.stringify(json, null, 2)}\n`;
}
