// The graph inside of a model of ours, where the server wrote it there.

import { asObject, asString, isObject, type JsonObject } from "../model/json";
import { splitGlb } from "../view3d/glb";

export type GlbContent =
  | { kind: "graph"; json: JsonObject }
  /** A model of ours that only names its graph by hash. */
  | { kind: "hash"; hash: string }
  /** Someone else's model: a mesh to import. */
  | { kind: "foreign" };

/** What a GLB tells of its graph. Throws with a readable message if it is broken. */
export function graphInGlb(bytes: Uint8Array<ArrayBuffer>): GlbContent {
  const asset = asObject(splitGlb(bytes).json["asset"]);
  const extras = asObject(asset["extras"]);
  for (const name of ["document", "graph"]) {
    const document = extras[name];
    if (isObject(document) && isObject(document["nodes"])) return { kind: "graph", json: document };
  }
  const hash = asString(extras["graph"]);
  return hash && asString(extras["engine"]) ? { kind: "hash", hash } : { kind: "foreign" };
}
