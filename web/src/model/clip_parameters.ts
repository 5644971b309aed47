// Parameters of copied nodes: which of another document's parameters drive them after they were pasted. No value changes
// without a word.

import type { GraphDocument } from "./document";
import { freeId } from "./edit";
import { isEqual } from "./equal";
import { asObject, isObject, type Json, type JsonObject } from "./json";
import { type ParameterValue, type ParameterValues, parameterValue, readParameter, sameValue } from "./parameters";

/** What becomes of a parameter that drives copied nodes; `name` is what it is called in the clip. */
export type Driver =
  /** One of the document takes its place; `value` is there where it is another than the copied one. */
  | { kind: "present"; name: string; label: string; value?: ParameterValue }
  /** It comes along, under the name `as`. */
  | { kind: "brought"; name: string; label: string; as: string }
  /** Neither the document nor the clip has it; the inputs fall back to their defaults. */
  | { kind: "missing"; name: string; inputs: string[] };

/** The names of the parameters that drive nodes. */
export function parametersOf(nodes: JsonObject): Set<string> {
  const names = new Set<string>();
  for (const node of Object.values(nodes)) {
    for (const value of Object.values(asObject(asObject(node)["inputs"])).flat()) {
      const name = parameterIn(value);
      if (name !== undefined) names.add(name);
    }
  }
  return names;
}

export function driversFor(
  document: GraphDocument,
  clip: { nodes: JsonObject; parameters: JsonObject; values: ParameterValues },
  values: ParameterValues,
): Driver[] {
  const taken = new Set(document.parameters.map((parameter) => parameter.name));
  return [...parametersOf(clip.nodes)].map((name): Driver => {
    const definition = Object.hasOwn(clip.parameters, name) ? clip.parameters[name] : undefined;
    const present = document.parameters.find((parameter) => parameter.name === name);
    if (!isObject(definition)) {
      if (present) return { kind: "present", name, label: present.label };
      return { kind: "missing", name, inputs: inputsDrivenBy(name, clip.nodes) };
    }
    const copied = readParameter(name, definition);
    if (present) {
      const [before, now] = [parameterValue(copied, clip.values), parameterValue(present, values)];
      const isSame = present.type === copied.type && sameValue(before, now);
      if (isSame) return { kind: "present", name, label: present.label };
      const isItself = isEqual(asObject(document.scope["parameters"])[name], definition);
      if (isItself) return { kind: "present", name, label: present.label, value: now };
    }
    const as = taken.has(name) ? freeId(document, name, new Set([...taken, ...Object.keys(clip.parameters)])) : name;
    taken.add(as);
    return { kind: "brought", name, label: copied.label, as };
  });
}

/** A copied node with the drivers of its inputs. */
export function driven(item: JsonObject, drivers: readonly Driver[]): JsonObject {
  const changed = (value: Json): Json => {
    const driver = drivers.find(({ name }) => name === parameterIn(value));
    if (!driver || driver.kind === "present") return value;
    return driver.kind === "brought" ? { parameter: driver.as } : undefined;
  };
  const inputs: JsonObject = {};
  for (const [name, value] of Object.entries(asObject(item["inputs"]))) {
    if (!Array.isArray(value)) inputs[name] = changed(value);
    else {
      const left = value.map(changed).filter((one) => one !== undefined);
      inputs[name] = left.length > 0 || value.length === 0 ? left : undefined;
    }
    if (inputs[name] === undefined) delete inputs[name];
  }
  return { ...item, inputs };
}

/** "radius of circle" for every input that the parameter drives. */
function inputsDrivenBy(name: string, nodes: JsonObject): string[] {
  return Object.entries(nodes).flatMap(([id, node]) =>
    Object.entries(asObject(asObject(node)["inputs"])).flatMap(([input, value]) =>
      [value].flat().some((one) => parameterIn(one) === name) ? [`${input} of ${id}`] : [],
    ),
  );
}

function parameterIn(value: Json): string | undefined {
  return isObject(value) && typeof value["parameter"] === "string" ? value["parameter"] : undefined;
}
