// Questions about a graph that evaluate nothing that is not asked for: what is wrong with it, what a wire carries.

import { asArray, asNumber, asObject, asString, isObject, type Json } from "../model/json";
import { send } from "./access";
import { type Problem, type ProblemEntry, readEntry, readProblem } from "./problem";
import { type Axis, readAxes } from "./report";
import type { EvaluateBody } from "./requests";

export interface WireValue {
  type: string;
  axes: Axis[];
}

/** The answer of POST /v1/validate. */
export interface Validation {
  errors: ProblemEntry[];
  blocked: string[];
  /** By "node.output". */
  wires: ReadonlyMap<string, WireValue>;
}

export interface Inspection extends WireValue {
  values: Json[];
}

/** Every problem of a graph and what its wires carry; undefined if the server does not answer. */
export async function validate(
  body: Omit<EvaluateBody, "output">,
  signal?: AbortSignal,
): Promise<Validation | undefined> {
  const answer = await post("v1/validate", { graph: body.graph, parameters: body.parameters }, signal);
  if (!answer) return undefined;
  const root = asObject(answer.json);
  const wires = new Map<string, WireValue>();
  for (const [name, item] of Object.entries(asObject(root["wires"]))) wires.set(name, readWire(item));
  const errors = asArray(root["errors"]).filter(isObject).map(readEntry);
  return { errors, blocked: asArray(root["blocked"]).map(asString).filter(Boolean), wires };
}

/** The value on a wire; a problem where there is none, undefined if the server does not answer. */
export async function inspect(
  body: Omit<EvaluateBody, "output">,
  node: string,
  output: string,
  signal?: AbortSignal,
): Promise<Inspection | Problem | undefined> {
  const { graph, parameters } = body;
  const answer = await post("v1/inspect", { graph, parameters, node, output }, signal);
  if (!answer) return undefined;
  if (answer.status !== 200) return readProblem(answer.status, answer.json);
  return { ...readWire(answer.json), values: asArray(asObject(answer.json)["values"]) };
}

function readWire(json: Json): WireValue {
  const item = asObject(json);
  return { type: asString(item["type"]), axes: readAxes(item["axes"]) };
}

async function post(
  path: string,
  body: object,
  signal?: AbortSignal,
): Promise<{ status: number; json: Json } | undefined> {
  try {
    const response = await send(path, {
      method: "POST",
      headers: { "content-type": "application/json", accept: "application/json" },
      body: JSON.stringify(body),
      signal,
    });
    return { status: response.status, json: (await response.json()) as Json };
  } catch {
    return undefined;
  }
}

/** Sizes of the values: a count, and the corners of the box around points that are not at infinity. */
export function boundsOf(values: readonly Json[]): [number[], number[]] | undefined {
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (const value of values) {
    if (!Array.isArray(value) || value.length !== 3) continue;
    value.forEach((part, axis) => {
      const number = asNumber(part) ?? NaN;
      low[axis] = Math.min(low[axis] ?? 0, number);
      high[axis] = Math.max(high[axis] ?? 0, number);
    });
  }
  return low.every(Number.isFinite) && high.every(Number.isFinite) ? [low, high] : undefined;
}
