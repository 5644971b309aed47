// The graph inside of a model of ours: the page writes it there on request, beside what the server says of the file.

import { joinGlb, splitGlb } from "../model/glb";
import { asObject, asString, isObject, type JsonObject } from "../model/json";

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
  const document = extras["document"];
  if (isObject(document) && isObject(document["nodes"])) return { kind: "graph", json: document };
  // Files of before called the fingerprint "graph".
  const hash = asString(extras["fingerprint"]) || asString(extras["graph"]);
  return hash && asString(extras["engine"]) ? { kind: "hash", hash } : { kind: "foreign" };
}

/** The values of the parameters that a model of ours was made with; empty for any other. */
export function parametersInGlb(bytes: Uint8Array<ArrayBuffer>): JsonObject {
  return asObject(asObject(asObject(splitGlb(bytes).json["asset"])["extras"])["parameters"]);
}

/** The same model with the graph that made it in `asset.extras.document`. */
export function withGraph(bytes: Uint8Array<ArrayBuffer>, document: JsonObject): Uint8Array<ArrayBuffer> {
  const { json, binary } = splitGlb(bytes);
  const asset = asObject(json["asset"]);
  const extras = { ...asObject(asset["extras"]), document };
  return joinGlb({ json: { ...json, asset: { ...asset, extras } }, binary });
}
