// What a tab knows over a reload: its own name, and which document was open in it.

import { readCamera } from "../model/document";
import { asArray, asNumber, asObject, asString, isObject, type Json, type JsonObject, parseJson } from "../model/json";
import { documentWithValues } from "../model/saved_values";
import type { Session } from "../session/session";
import type { Origin, Sight } from "../session/state";
import { type Draft, originOf } from "./drafts";

const TAB_KEY = "dini.tab";
const OPEN_KEY = "dini.open";
const SIGHT_KEY = "dini.sight";

/** A document that was open. */
export interface OpenDocument {
  json: JsonObject;
  origin: Origin;
  /** Its draft, if it has changes that were not saved. */
  draft?: Draft;
}

/** A word that a tab keeps over reloads. */
export function tabName(): string {
  const fresh = newId();
  const known = read(TAB_KEY);
  if (known === null) write(TAB_KEY, fresh);
  return known ?? fresh;
}

/**
 * Remembers the open document while the page goes away. What the database is given then may come too late; this does not.
 * An unchanged example is in the address.
 */
export function rememberOpen(session: Session, draft: Draft | undefined): void {
  const { document, values, origin } = session.store.get();
  write(SIGHT_KEY, JSON.stringify({ ...session.lookedAt(), address: location.hash }));
  const isElsewhere = draft === undefined && origin.kind === "example";
  if (!document || isElsewhere) write(OPEN_KEY, null);
  else {
    const json = documentWithValues(document, values);
    write(OPEN_KEY, JSON.stringify({ json, origin, address: location.hash, draft: draft && { ...draft, json: null } }));
  }
}

/** The document that was open when the page was left, if the page's address is still that of then. */
export function recallOpen(): OpenDocument | undefined {
  const { json, origin, address, draft } = asObject(readJson(OPEN_KEY));
  if (!isObject(json) || address !== location.hash) return undefined;
  if (!isObject(draft)) return { json, origin: readOrigin(origin) };
  return {
    json,
    origin: originOf(draft as unknown as Draft),
    draft: { ...(draft as unknown as Draft), json },
  };
}

/** How what was open was looked at when the page was left, if the page's address is still that of then. */
export function recallSight(): Sight | undefined {
  const { camera, selection, address } = asObject(readJson(SIGHT_KEY));
  if (address !== location.hash) return undefined;
  return { camera: readCamera(asObject(camera)), selection: asArray(selection).map(asString) };
}

function readOrigin(json: Json): Origin {
  const { kind, name, id, version, tag } = asObject(json);
  if (kind === "file") return { kind, name: asString(name) };
  if (kind === "stored") return { kind, id: asString(id), version: asNumber(version) ?? 0, tag: asString(tag) };
  return { kind: kind === "shared" ? kind : "new" };
}

export function newId(): string {
  return [...crypto.getRandomValues(new Uint8Array(9))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

function readJson(key: string): Json {
  try {
    return parseJson(read(key) ?? "null");
  } catch {
    return null;
  }
}

/** Without storage every load of the page is a tab of its own. */
function read(key: string): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}

function write(key: string, text: string | null): void {
  try {
    if (text === null) sessionStorage.removeItem(key);
    else sessionStorage.setItem(key, text);
  } catch {
    // Nothing is lost: what would be remembered here is kept elsewhere.
  }
}
