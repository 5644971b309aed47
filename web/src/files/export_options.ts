// What an exported file can be told: the literal inputs of the node that makes it, from the catalogue.

import type { Catalogue, InputCard } from "../model/catalogue";
import type { GraphDocument } from "../model/document";
import { fileOutput } from "../model/graph";
import { asObject, type Json, type JsonObject } from "../model/json";
import type { ParameterType } from "../model/parameters";
import { groupNamed } from "../model/scope";

export interface ExportOption {
  input: InputCard;
  kind: ParameterType;
  /** What stands in the document, or the default. */
  value: Json;
}

const LITERALS: ReadonlySet<string> = new Set(["integer", "boolean", "choice", "number"]);

/** The settings of the file: inputs that hold a literal and not what a wire or a parameter brings. */
export function exportOptions(document: GraphDocument, catalogue: Catalogue): ExportOption[] {
  const node = document.nodes.get(fileOutput(document, catalogue) ?? "");
  // The inputs of a group that makes the file are its own, and none of the file's.
  const card = node && groupNamed(node.type) === undefined ? catalogue.nodes.get(node.type) : undefined;
  return (card?.inputs ?? []).flatMap((input) => {
    const [source] = node?.inputs.get(input.name) ?? [];
    const [kind] = input.types;
    const isSetting = kind !== undefined && LITERALS.has(kind) && input.types.length === 1;
    if (!isSetting || (source && source.kind !== "literal")) return [];
    return [{ input, kind: kind as ParameterType, value: source ? source.value : input.fallback }];
  });
}

/** The document with other settings for its file; the open one is not changed. */
export function withOptions(
  document: GraphDocument,
  output: string,
  changes: Readonly<Record<string, Json>>,
): JsonObject {
  const nodes = asObject(document.json["nodes"]);
  const node = asObject(nodes[output]);
  const inputs = { ...asObject(node["inputs"]), ...changes };
  return { ...document.json, nodes: { ...nodes, [output]: { ...node, inputs } } };
}
