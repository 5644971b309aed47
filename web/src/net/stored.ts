// What an address says of a graph that the server keeps, and the calls for it. Addresses are relative to a page that
// lies one folder deep, as /embed/{id} does, so that it also works below a prefix.

import type { JsonObject } from "../model/json";
import { asArray, asNumber, asObject, asString, type Json } from "../model/json";
import type { Parameter, ParameterValue, ParameterValues } from "../model/parameters";
import { localProblem, type Problem, readProblem } from "./problem";
import { readReport } from "./report";
import type { Answer, Quality } from "./requests";

/** A version of a graph, and what is known of it. */
export interface Stored {
  /** With its version: that one stays as it is while it is looked at. */
  name: string;
  outputs: string[];
  document: Json;
}

/** What the query of an embedding page asks for. */
export interface Asked {
  output: string;
  theme: string;
  /** Texts for parameters, by name. */
  texts: ReadonlyMap<string, string>;
}

export type Found<Value> = { value: Value } | { problem: Problem };

const GRAPHS = "../v1/graphs/";
const BUSY_STATUS = new Set([429, 502, 503]);
const PARAMETER_PREFIX = "parameter.";
/** Names that the address of an output has for itself. */
const TAKEN = new Set(["quality", "accept", "download", "draco", "format"]);
/** Names that the page for frames has for itself. */
const ASKED = new Set(["output", "theme"]);

/** The name of the graph in the address of the page: its last part. */
export function graphInPath(path: string): string {
  const last = path.slice(path.lastIndexOf("/") + 1);
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}

/** `?reach=2&output=out&theme=light`; `parameter.theme` is the parameter that is called like one of ours. */
export function readAsked(search: string): Asked {
  const asked = { output: "", theme: "", texts: new Map<string, string>() };
  for (const [name, text] of new URLSearchParams(search)) {
    if (name === "output" || name === "theme") asked[name] = text;
    else asked.texts.set(name.startsWith(PARAMETER_PREFIX) ? name.slice(PARAMETER_PREFIX.length) : name, text);
  }
  return asked;
}

/** The values that an address gives to the parameters. What it gives to none is a problem, not left out. */
export function valuesFrom(
  texts: ReadonlyMap<string, string>,
  parameters: readonly Parameter[],
): Found<Record<string, ParameterValue>> {
  const values: Record<string, ParameterValue> = {};
  for (const [name, text] of texts) {
    const parameter = parameters.find((one) => one.name === name);
    const known = parameters.map((one) => one.name).join(", ") || "none";
    if (!parameter) return wrong(`The graph has no parameter “${name}”; it has ${known}.`);
    const value = valueFrom(text, parameter);
    if (value === undefined) return wrong(`“${text}” is no ${parameter.type} for “${name}”.`);
    values[name] = value;
  }
  return { value: values };
}

/** Where the model of an output is. */
export function outputAddress(graph: string, output: string, values: ParameterValues, quality: Quality): string {
  const query = new URLSearchParams();
  for (const [name, value] of Object.entries(values)) {
    query.set(TAKEN.has(name) ? PARAMETER_PREFIX + name : name, String(value));
  }
  if (quality === "draft") query.set("quality", quality);
  const asked = query.toString();
  return `${addressOf(graph)}/outputs/${encodeURIComponent(output)}.glb${asked && `?${asked}`}`;
}

/** The address of the page for frames of other pages, with the values that its sliders begin with. */
export function embedAddress(graph: string, values: ParameterValues): string {
  const query = new URLSearchParams();
  for (const [name, value] of Object.entries(values)) {
    query.set(ASKED.has(name) ? PARAMETER_PREFIX + name : name, String(value));
  }
  const asked = query.toString();
  return `../embed/${encodeURIComponent(graph)}${asked && `?${asked}`}`;
}

/** What the server keeps under a name, with a version or without. Rejects if the server cannot be reached. */
export async function fetchStored(name: string): Promise<Found<Stored>> {
  const facts = await fetchJson(`${addressOf(name)}/interface`);
  if ("problem" in facts) return facts;
  const told: JsonObject = asObject(facts.value);
  const version = `${asString(told["id"])}@${asNumber(told["version"]) ?? 1}`;
  const document = await fetchJson(addressOf(version));
  if ("problem" in document) return document;
  return { value: { name: version, outputs: asArray(told["outputs"]).map(asString), document: document.value } };
}

/** The model of an output. Rejects only after `signal`. */
export async function fetchOutput(address: string, signal: AbortSignal): Promise<Answer> {
  try {
    const response = await fetch(address, { signal });
    if (BUSY_STATUS.has(response.status)) {
      const seconds = Number(response.headers.get("retry-after"));
      return { kind: "away", retryAfter: seconds > 0 ? seconds * 1000 : undefined, isCrowded: true };
    }
    if (!response.ok) return { kind: "problem", problem: await problemIn(response) };
    const model = new Uint8Array(await response.arrayBuffer());
    return { kind: "model", report: readReport({}), model, preview: null };
  } catch (error) {
    if (signal.aborted) throw error;
    return { kind: "away" };
  }
}

function addressOf(name: string): string {
  // The server takes a version with its @ as it is.
  return GRAPHS + encodeURIComponent(name).replace("%40", "@");
}

async function fetchJson(address: string): Promise<Found<Json>> {
  const response = await fetch(address, { headers: { accept: "application/json" } });
  return response.ok ? { value: (await response.json()) as Json } : { problem: await problemIn(response) };
}

async function problemIn(response: Response): Promise<Problem> {
  return readProblem(response.status, (await response.json().catch(() => null)) as Json);
}

function valueFrom(text: string, { type, choices }: Parameter): ParameterValue | undefined {
  switch (type) {
    case "number":
    case "integer":
      return numberFrom(text);
    case "boolean":
      return text === "true" ? true : text === "false" ? false : undefined;
    case "choice":
      return choices.includes(text) ? text : undefined;
    case "vector":
    case "color": {
      const parts = text.split(",").map(numberFrom);
      const isWhole = parts.length === 3 || (type === "color" && parts.length === 4);
      return isWhole && parts.every((part) => part !== undefined) ? (parts as number[]) : undefined;
    }
    default:
      return text;
  }
}

function numberFrom(text: string): number | undefined {
  const value = Number(text);
  return text.trim() !== "" && Number.isFinite(value) ? value : undefined;
}

function wrong(detail: string): { problem: Problem } {
  return { problem: localProblem("The address of this page cannot be read", detail) };
}
