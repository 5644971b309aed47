// JSON Patch (RFC 6902) as problems bring it: the operations add, remove and replace, within the graph.

import { type GraphDocument, rewrittenWhole } from "./document";
import { isObject, type Json } from "./json";

export interface PatchStep {
  op: string;
  path: string;
  value?: Json;
}

/** The document after the patch, whose paths begin with "/graph"; undefined if a step cannot be done. */
export function patchDocument(document: GraphDocument, steps: readonly PatchStep[]): GraphDocument | undefined {
  let json: Json = { graph: document.json };
  for (const step of steps) {
    if (!step.path.startsWith("/graph/")) return undefined;
    const keys = step.path
      .slice(1)
      .split("/")
      .map((key) => key.replaceAll("~1", "/").replaceAll("~0", "~"));
    json = stepped(json, keys, step);
    if (json === undefined) return undefined;
  }
  const graph = isObject(json) ? json["graph"] : undefined;
  return isObject(graph) ? rewrittenWhole(document, graph) : undefined;
}

/** A copy of `json` with the step done below it; what is not on the way stays the same object. */
function stepped(json: Json, [key = "", ...rest]: readonly string[], step: PatchStep): Json {
  if (Array.isArray(json)) {
    const index = key === "-" ? json.length : Number(key);
    if (!Number.isInteger(index) || index < 0 || index > json.length) return undefined;
    if (rest.length > 0) {
      const below = stepped(json[index], rest, step);
      return below === undefined ? undefined : json.map((item, at) => (at === index ? below : item));
    }
    if (step.op === "add") return [...json.slice(0, index), step.value, ...json.slice(index)];
    if (index >= json.length) return undefined;
    if (step.op === "replace") return json.map((item, at) => (at === index ? step.value : item));
    return step.op === "remove" ? json.filter((_, at) => at !== index) : undefined;
  }
  if (!isObject(json)) return undefined;
  if (rest.length > 0) {
    // A node may be without inputs, and the value is for one of them.
    const below = stepped(json[key] ?? (step.op === "add" ? {} : undefined), rest, step);
    return below === undefined ? undefined : { ...json, [key]: below };
  }
  if (step.op === "add") return { ...json, [key]: step.value };
  if (!(key in json)) return undefined;
  if (step.op === "replace") return { ...json, [key]: step.value };
  if (step.op !== "remove") return undefined;
  const { [key]: _, ...left } = json;
  return left;
}
