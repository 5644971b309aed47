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

/** True if both say the same of the same place. */
export function isSameEntry(a: ProblemEntry, b: ProblemEntry): boolean {
  return (
    a.code === b.code && a.node === b.node && a.port === b.port && (!a.pointer || !b.pointer || a.pointer === b.pointer)
  );
}

/** What is wrong with one node: the first error, else a warning, else that it waits for others. */
export function problemsOf(
  state: {
    problem: Problem | null;
    checked: { errors: ProblemEntry[]; blocked: string[] } | null;
    shown: {
      report: { warnings: ProblemEntry[]; checks: { node: string; passed: boolean; message: string }[] };
    } | null;
  },
  node: string,
): { tone: "error" | "warning" | "blocked"; text?: string } | undefined {
  // What is wrong within a group is shown at its instance.
  const isHere = (path: string): boolean => path === node || path.startsWith(`${node}/`);
  const names = (entry: ProblemEntry): boolean => isHere(entry.node);
  const error = state.problem?.errors.find(names) ?? state.checked?.errors.find(names);
  // An input that waits for its wire is no mistake; it is only not finished.
  if (error) return { tone: error.code === "required-input-missing" ? "warning" : "error", text: error.detail };
  const check = state.shown?.report.checks.find((one) => isHere(one.node) && !one.passed);
  if (check) return { tone: "error", text: check.message || "The check failed." };
  const warning = state.shown?.report.warnings.find(names);
  if (warning) return { tone: "warning", text: warning.detail };
  const isBlocked = state.problem?.blocked.some(isHere) || state.checked?.blocked.some(isHere);
  return isBlocked ? { tone: "blocked" } : undefined;
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
