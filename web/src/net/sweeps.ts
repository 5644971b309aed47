// Batches: one graph for many values of its parameters (POST /v1/sweeps), answered line by line as they are done.

import { asArray, asNumber, asObject, asString, isObject, type Json, type JsonObject } from "../model/json";
import { send } from "./access";
import { type Problem, readEntry, readProblem } from "./problem";

/** What is asked for: a model for each of the variants, which are told in this order. */
export interface SweepBody {
  graph: JsonObject;
  /** Values that all variants share. */
  parameters: object;
  /** Lists of values by parameter: all combined, the last of the alphabet varying fastest. */
  grid: Readonly<Record<string, readonly Json[]>>;
  output: string;
  quality: "draft" | "final";
}

/** What came of one variant: where its model is, or why there is none. */
export interface SweepLine {
  index: number;
  parameters: JsonObject;
  /** Empty where it failed. */
  sha256: string;
  error: string;
}

export type SweepAnswer = { kind: "end" } | { kind: "problem"; problem: Problem } | { kind: "away" };

const JSON_HEADERS = { "content-type": "application/json" };

/** Runs a batch; `take` is given each line as it comes. Rejects only after `signal`. */
export async function sweep(
  body: SweepBody,
  take: (line: SweepLine) => void,
  signal: AbortSignal,
): Promise<SweepAnswer> {
  try {
    const headers = { ...JSON_HEADERS, accept: "application/x-ndjson" };
    const response = await send("v1/sweeps", { method: "POST", headers, body: JSON.stringify(body), signal });
    if (!response.ok || !response.body) return await refused(response);
    let rest = "";
    let stopped: Problem | undefined;
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    for (;;) {
      const { value, done } = await reader.read();
      const lines = (rest + (value ?? "")).split("\n");
      rest = lines.pop() ?? "";
      for (const text of lines) {
        const line = asObject(JSON.parse(text) as Json);
        if (asString(line["status"]) === "stopped") stopped = stoppedBy(line);
        else take(readLine(line));
      }
      if (done) break;
    }
    return stopped ? { kind: "problem", problem: stopped } : { kind: "end" };
  } catch (error) {
    if (signal.aborted) throw error;
    return { kind: "away" };
  }
}

/** One GLB with a node for each variant. Rejects only after `signal`. */
export async function sweepToGlb(
  body: SweepBody,
  signal: AbortSignal,
): Promise<{ kind: "model"; model: Uint8Array<ArrayBuffer> } | Exclude<SweepAnswer, { kind: "end" }>> {
  try {
    const headers = { ...JSON_HEADERS, accept: "model/gltf-binary" };
    const response = await send("v1/sweeps", { method: "POST", headers, body: JSON.stringify(body), signal });
    if (!response.ok) return await refused(response);
    return { kind: "model", model: new Uint8Array(await response.arrayBuffer()) };
  } catch (error) {
    if (signal.aborted) throw error;
    return { kind: "away" };
  }
}

/** The bytes of a file that was made; nothing where the server does not keep it any more. Rejects only after `signal`. */
export async function fetchArtifact(sha256: string, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer> | undefined> {
  try {
    const response = await send(`v1/artifacts/${sha256}`, { signal });
    return response.ok ? new Uint8Array(await response.arrayBuffer()) : undefined;
  } catch (error) {
    if (signal.aborted) throw error;
    return undefined;
  }
}

async function refused(response: Response): Promise<Exclude<SweepAnswer, { kind: "end" }>> {
  if ([429, 502, 503].includes(response.status)) return { kind: "away" };
  return { kind: "problem", problem: readProblem(response.status, (await response.json().catch(() => null)) as Json) };
}

function readLine(line: JsonObject): SweepLine {
  const errors = asArray(line["errors"]).filter(isObject).map(readEntry);
  return {
    index: asNumber(line["index"]) ?? 0,
    parameters: asObject(line["parameters"]),
    sha256: asString(asObject(line["model"])["sha256"]),
    error: asString(line["status"]) === "failed" ? (errors[0]?.detail ?? "It could not be made.") : "",
  };
}

function stoppedBy(line: JsonObject): Problem {
  return readProblem(0, { title: "The batch was stopped", errors: line["errors"] });
}
