// The graphs that the server keeps, by their names and versions.

import { asArray, asNumber, asObject, asString, type Json } from "../model/json";
import { send } from "./access";
import { localProblem, type Problem, readProblem } from "./problem";
import type { Found } from "./stored";

/** One version of a kept graph. */
export interface StoredVersion {
  id: string;
  version: number;
  title: string;
  /** Milliseconds since 1970. */
  created: number;
  /** What a request to replace this version has to name. */
  tag: string;
}

/** What came of writing. `conflict`: something else is kept under that name by now. */
export type Written = { value: StoredVersion } | { conflict: true } | { problem: Problem };

/** Current versions whose names or titles hold the text, by name. `isMore`: there are others that are not listed. */
export interface StoredList {
  graphs: StoredVersion[];
  isMore: boolean;
}

const GRAPHS = "v1/graphs";
const LONGEST_MILLISECONDS = 10_000;
const PRECONDITION_FAILED = 412;

export async function listGraphs(query: string): Promise<Found<StoredList>> {
  const found = await ask(`${GRAPHS}?limit=100${query && `&query=${encodeURIComponent(query)}`}`);
  if ("problem" in found) return found;
  const { graphs, next } = asObject(found.value.json);
  return { value: { graphs: asArray(graphs).map(readVersion), isMore: asString(next) !== "" } };
}

/** Every version of a graph, newest first. */
export async function listVersions(id: string): Promise<Found<StoredVersion[]>> {
  const found = await ask(`${addressOf(id)}/versions`);
  if ("problem" in found) return found;
  const versions = asArray(asObject(found.value.json)["versions"]).map(readVersion);
  return { value: versions.sort((a, b) => b.version - a.version) };
}

/** The document of a graph, with its version as `name@3` or the current one, and which version it is. */
export async function readGraph(name: string): Promise<Found<{ json: Json; version: StoredVersion }>> {
  const found = await ask(addressOf(name));
  if ("problem" in found) return found;
  const { json, tag } = found.value;
  const title = asString(asObject(asObject(json)["meta"])["title"]);
  const version = Number(/^"(\d+)-/.exec(tag)?.[1] ?? 0);
  return { value: { json, version: { id: name.replace(/@.*$/, ""), version, title, created: 0, tag } } };
}

/** Keeps a document in place of the version with this tag; without one, as a new graph. */
export async function writeGraph(id: string, text: string, replaces: string | undefined): Promise<Written> {
  const condition: Record<string, string> =
    replaces === undefined ? { "if-none-match": "*" } : { "if-match": replaces };
  const headers = { "content-type": "application/json", ...condition };
  const found = await ask(addressOf(id), { method: "PUT", headers, body: text });
  if ("value" in found) return { value: readVersion(found.value.json) };
  return found.problem.status === PRECONDITION_FAILED ? { conflict: true } : found;
}

/** Takes a graph out of the list, if it is that version still; its versions stay. */
export async function deleteGraph({ id, tag }: StoredVersion): Promise<{ problem: Problem } | undefined> {
  const found = await ask(addressOf(id), { method: "DELETE", headers: { "if-match": tag } });
  return "problem" in found ? found : undefined;
}

function readVersion(json: Json): StoredVersion {
  const item = asObject(json);
  return {
    id: asString(item["id"]),
    version: asNumber(item["version"]) ?? 0,
    title: asString(item["title"]),
    created: Date.parse(asString(item["created"])) || 0,
    tag: asString(item["etag"]),
  };
}

function addressOf(name: string): string {
  // The server takes a version with its @ as it is.
  return `${GRAPHS}/${encodeURIComponent(name).replace("%40", "@")}`;
}

async function ask(address: string, request: RequestInit = {}): Promise<Found<{ json: Json; tag: string }>> {
  try {
    const response = await send(address, { cache: "no-store", ...request }, LONGEST_MILLISECONDS);
    const json = (await response.json().catch(() => null)) as Json;
    if (!response.ok) return { problem: readProblem(response.status, json) };
    return { value: { json, tag: response.headers.get("etag") ?? "" } };
  } catch {
    return {
      problem: localProblem("The server does not answer", "The server does not answer. Try again in a moment."),
    };
  }
}
