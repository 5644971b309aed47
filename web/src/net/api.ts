// The calls to the server. Addresses are relative to the page, so that it also works below a prefix.

import { type Json, parseJsonBytes } from "../model/json";
import { send } from "./access";
import { failedChecks, withoutNodes } from "./checks";
import { boundaryOf, readMultipart } from "./multipart";
import { readProblem } from "./problem";
import { readReport } from "./report";
import type { Answer, Effort, EvaluateBody, GradientBody } from "./requests";

const MULTIPART = "multipart/form-data";
const MODEL = "model/gltf-binary";
/** A small answer that takes longer than this does not come. */
const LONGEST_MILLISECONDS = 8000;
const BUSY_STATUS = new Set([429, 502, 503]);

/** GET of a JSON answer. Rejects if the server cannot be reached or answers an error. */
export async function getJson(path: string): Promise<Json> {
  const response = await send(path, { headers: { accept: "application/json" } }, LONGEST_MILLISECONDS);
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  return (await response.json()) as Json;
}

/** True if the server answers at all. */
export async function isAlive(): Promise<boolean> {
  try {
    const signal = AbortSignal.timeout(LONGEST_MILLISECONDS);
    return (await fetch("healthz", { cache: "no-store", signal })).ok;
  } catch {
    return false;
  }
}

/** Evaluates a graph to report and model. Never rejects, except with AbortError after `signal`. */
export async function evaluate(
  body: EvaluateBody,
  { quality, triangles, format }: Effort,
  signal?: AbortSignal,
  supersedeKey?: string,
): Promise<Answer> {
  const headers: Record<string, string> = { "content-type": "application/json", accept: MULTIPART };
  if (supersedeKey) headers["supersede-key"] = supersedeKey;
  try {
    const response = await send(format ? `v1/evaluate?format=${encodeURIComponent(format)}` : "v1/evaluate", {
      method: "POST",
      headers,
      body: JSON.stringify({ ...body, quality, ...(quality === "draft" ? { triangle_budget: triangles } : {}) }),
      signal,
    });
    return await readAnswer(response);
  } catch (error) {
    if (signal?.aborted) throw error;
    return { kind: "away" };
  }
}

/** The control geometry alone; null if there is none, or the server cannot tell. Rejects only after `signal`. */
export async function fetchPreview(body: EvaluateBody, signal: AbortSignal): Promise<Uint8Array<ArrayBuffer> | null> {
  if (!body.preview) return null;
  try {
    const response = await send("v1/evaluate", {
      method: "POST",
      headers: { "content-type": "application/json", accept: MODEL },
      body: JSON.stringify({ ...body, output: undefined, quality: "draft" }),
      signal,
    });
    if (response.ok) return new Uint8Array(await response.arrayBuffer());
    const failed = failedChecks(readProblem(response.status, await jsonOf(response)));
    return failed.length > 0 ? await fetchPreview(withoutNodes(body, failed), signal) : null;
  } catch (error) {
    if (signal.aborted) throw error;
    return null;
  }
}

/** The model in the colors of its motion with a parameter; null if there is none. Rejects if nothing comes. */
export async function fetchSensitivity(
  body: GradientBody,
  signal: AbortSignal,
): Promise<Uint8Array<ArrayBuffer> | null> {
  const response = await send("v1/gradient", {
    method: "POST",
    headers: { "content-type": "application/json", accept: MODEL },
    body: JSON.stringify(body),
    signal,
  });
  return response.ok ? new Uint8Array(await response.arrayBuffer()) : null;
}

async function readAnswer(response: Response): Promise<Answer> {
  if (BUSY_STATUS.has(response.status)) {
    const seconds = Number(response.headers.get("retry-after"));
    return { kind: "away", retryAfter: seconds > 0 ? seconds * 1000 : undefined, isCrowded: true };
  }
  if (!response.ok) return { kind: "problem", problem: readProblem(response.status, await jsonOf(response)) };
  const boundary = boundaryOf(response.headers.get("content-type") ?? "");
  const body = new Uint8Array(await response.arrayBuffer());
  const parts = boundary === undefined ? undefined : readMultipart(body, boundary);
  const report = parts?.find((part) => part.name === "report");
  const model = parts?.find((part) => part.name === "model");
  if (!report || !model) {
    const problem = readProblem(0, { title: "Unreadable answer", detail: "The server's answer could not be read." });
    return { kind: "problem", problem };
  }
  const preview = parts?.find((part) => part.name === "preview")?.data.slice() ?? null;
  return { kind: "model", report: readReport(parseJsonBytes(report.data)), model: model.data.slice(), preview };
}

async function jsonOf(response: Response): Promise<Json> {
  try {
    return (await response.json()) as Json;
  } catch {
    return null;
  }
}
