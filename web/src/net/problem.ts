// RFC 9457 problems as the server sends them.

import { asArray, asObject, asString, isObject, type Json } from "../model/json";
import type { PatchStep } from "../model/patch";

export interface ProblemEntry {
  code: string;
  node: string;
  port: string;
  pointer: string;
  detail: string;
  /** What would mend it. */
  fix: PatchStep[];
}

export interface Problem {
  title: string;
  status: number;
  detail: string;
  code: string;
  instance: string;
  errors: ProblemEntry[];
  blocked: string[];
}

const PARAMETER_POINTER = /^\/parameters\/([^/]+)/;

/** Reads a problem; a body that is none becomes one with the HTTP status as its title. */
export function readProblem(status: number, body: Json): Problem {
  const root = asObject(body);
  const type = asString(root["type"]);
  const detail = asString(root["detail"]);
  return {
    title: asString(root["title"]) || `The server answered ${status}`,
    status,
    detail,
    code: type.slice(type.lastIndexOf("/") + 1),
    instance: asString(root["instance"]),
    errors: asArray(root["errors"]).filter(isObject).map(readEntry),
    blocked: asArray(root["blocked"]).map(asString).filter(Boolean),
  };
}

/** A problem of our own making, in the same form. */
export function localProblem(title: string, detail: string): Problem {
  return { title, status: 0, detail, code: "", instance: "", errors: [], blocked: [] };
}

/** The errors about one graph parameter. */
export function parameterErrors(problem: Problem | null, name: string): ProblemEntry[] {
  return (problem?.errors ?? []).filter((entry) => parameterOf(entry) === name);
}

/** The errors and warnings that name one node. */
export function nodeErrors(entries: readonly ProblemEntry[], node: string): ProblemEntry[] {
  return entries.filter((entry) => entry.node === node);
}

export function parameterOf(entry: ProblemEntry): string | undefined {
  const name = PARAMETER_POINTER.exec(entry.pointer)?.[1];
  return name?.replaceAll("~1", "/").replaceAll("~0", "~");
}

/** One line that says what is wrong. */
export function problemText(problem: Problem): string {
  return problem.errors[0]?.detail || problem.detail || problem.title;
}

export function readEntry(item: Json): ProblemEntry {
  const entry = asObject(item);
  return {
    code: asString(entry["code"]),
    node: asString(entry["node"]),
    port: asString(entry["port"]),
    pointer: asString(entry["pointer"]),
    detail: asString(entry["detail"]) || asString(entry["message"]),
    fix: asArray(entry["fix"])
      .filter(isObject)
      .map((step) => ({ op: asString(step["op"]), path: asString(step["path"]), value: step["value"] })),
  };
}
