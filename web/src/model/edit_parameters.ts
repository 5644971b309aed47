// Changes of the graph's parameters: exposing an input, editing what the form shows, taking a parameter away.

import type { InputCard } from "./catalogue";
import { type GraphDocument, rewritten } from "./document";
import { changeNode, type Edit, freeId, inOrder, setInput, withInput } from "./edit";
import { asObject, isObject, type Json, type JsonObject } from "./json";
import { type ParameterType, sentenceCase } from "./parameters";

/** The type of parameter that can drive an input, or undefined if none can. */
export function parameterTypeFor(input: InputCard): ParameterType | undefined {
  for (const type of input.types) {
    if (type === "point") return "vector";
    if (["number", "integer", "boolean", "choice", "vector", "color"].includes(type)) return type as ParameterType;
  }
  return undefined;
}

/** Makes a parameter of an input; its default is the value that stands there. */
export function expose(node: string, input: InputCard, value: Json): Edit {
  return (document) => {
    const type = parameterTypeFor(input);
    if (type === undefined || value === undefined || value === null) return document;
    const name = freeParameter(document, input.name);
    const item: JsonObject = { type, default: value, label: name === input.name ? input.title : sentenceCase(name) };
    if (type === "number" || type === "integer") {
      const [minimum, maximum] = rangeAround(input, Number(value));
      if (minimum !== undefined) item["min"] = minimum;
      if (maximum !== undefined) item["max"] = maximum;
      if (input.unit) item["unit"] = input.unit;
    }
    if (type === "choice") item["choices"] = input.choices;
    if (input.description) item["description"] = input.description;
    return inOrder(addParameter(name, item), setInput(node, input.name, { parameter: name }))(document);
  };
}

export function addParameter(name: string, item: JsonObject): Edit {
  return (document) => rewritten(document, { parameters: { ...asObject(document.scope["parameters"]), [name]: item } });
}

/** Changes members of a parameter, as `label`, `min`, `max`, `default`; undefined takes a member away. */
export function changeParameter(name: string, change: JsonObject): Edit {
  return (document) => {
    const item = asObject(document.scope["parameters"])[name];
    if (!isObject(item)) return document;
    const next: JsonObject = { ...item, ...change };
    for (const [member, value] of Object.entries(next)) if (value === undefined) delete next[member];
    return addParameter(name, next)(document);
  };
}

/** Puts a parameter at a place among the others, counted without it. */
export function moveParameter(name: string, place: number): Edit {
  return (document) => {
    const entries = Object.entries(asObject(document.scope["parameters"]));
    const from = entries.findIndex(([other]) => other === name);
    const [moved] = entries.splice(Math.max(0, from), from < 0 ? 0 : 1);
    const to = Math.min(Math.max(0, place), entries.length);
    if (!moved || to === from) return document;
    entries.splice(to, 0, moved);
    return rewritten(document, { parameters: Object.fromEntries(entries) });
  };
}

/** Takes a parameter away; the inputs it drove are given `value`. */
export function removeParameter(name: string, value: Json): Edit {
  return (document) => {
    const { [name]: gone, ...parameters } = asObject(document.scope["parameters"]);
    if (gone === undefined) return document;
    let changed = rewritten(document, { parameters });
    for (const node of document.nodes.values()) {
      for (const [input, sources] of node.inputs) {
        if (!sources.some((source) => source.kind === "parameter" && source.name === name)) continue;
        changed = changeNode(changed, node.id, (item) => {
          const present = asObject(item["inputs"])[input];
          const put = (one: Json): Json => (isObject(one) && one["parameter"] === name ? value : one);
          return withInput(item, input, Array.isArray(present) ? present.map(put) : value);
        });
      }
    }
    return changed;
  };
}

/** Frees one input of its parameter, and takes the parameter away if it drives nothing else. */
export function conceal(node: string, input: string, name: string, value: Json): Edit {
  return (document) => {
    const freed = setInput(node, input, value)(document);
    return usesOf(freed, name) > 0 ? freed : removeParameter(name, value)(freed);
  };
}

/** How many inputs a parameter drives. */
export function usesOf(document: GraphDocument, name: string): number {
  let count = 0;
  for (const node of document.nodes.values()) {
    for (const sources of node.inputs.values()) {
      if (sources.some((source) => source.kind === "parameter" && source.name === name)) count++;
    }
  }
  return count;
}

function freeParameter(document: GraphDocument, wanted: string): string {
  const taken = new Set(document.parameters.map((parameter) => parameter.name));
  return taken.has(wanted) ? freeId(document, wanted, new Set([...taken, ...document.nodes.keys()])) : wanted;
}

/** The slider's range, widened where the value lies outside. */
function rangeAround(input: InputCard, value: number): [number | undefined, number | undefined] {
  const low = input.softMinimum ?? input.minimum;
  const high = input.softMaximum ?? input.maximum;
  return [low === undefined ? undefined : Math.min(low, value), high === undefined ? undefined : Math.max(high, value)];
}
