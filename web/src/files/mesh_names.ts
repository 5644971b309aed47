// Which file an uploaded mesh was. Graphs name meshes by their hash alone; whoever takes a graph to the command line needs
// the file, so its name is remembered in this browser.

import { asObject, asString, type Json } from "../model/json";
import { recall, remember } from "../session/remembered";

const KEY = "dini.meshes";
const MOST_NAMES = 50;

export function rememberMesh(hash: string, name: string): void {
  const others = Object.entries(known()).filter(([key]) => key !== hash);
  remember(KEY, JSON.stringify(Object.fromEntries([...others, [hash, name]].slice(-MOST_NAMES))));
}

/** The name of the file with this hash, if it was uploaded from this browser. */
export function meshName(hash: string): string | undefined {
  return asString(known()[hash]) || undefined;
}

function known(): Record<string, Json> {
  try {
    return asObject(JSON.parse(recall(KEY) ?? "{}") as Json);
  } catch {
    return {};
  }
}
