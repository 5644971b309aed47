// The open graph as commands for a shell.

import type { Catalogue } from "../model/catalogue";
import { type GraphDocument, type GraphNode, lookedAt } from "../model/document";
import { fileName } from "../model/format";
import { wholeCatalogue } from "../model/group_cards";
import { asObject, asString, type Json } from "../model/json";
import { GROUP_PREFIX } from "../model/scope";
import type { Session } from "../session/session";

/** A curl call that answers the model in final quality; undefined before a graph is open. */
export function curlText(session: Session): string | undefined {
  const body = session.body();
  const title = session.store.get().document?.title;
  if (!body || title === undefined) return undefined;
  const address = new URL("v1/evaluate", document.baseURI).href;
  const json = JSON.stringify({ ...body, quality: "final" });
  return `curl -sf ${quoted(address)} -H 'content-type: application/json' -o ${fileName(title)}.glb -d ${quoted(json)}`;
}

/**
 * The same on the command line: an unchanged example or file by its name, anything else through standard input, so that
 * the command works wherever it is pasted. Meshes that were uploaded are given as files; `fileOf` knows their names.
 */
export function commandLineText(session: Session, fileOf: (hash: string) => string | undefined): string | undefined {
  const { origin, isChanged, values, document: open, catalogue, examples } = session.store.get();
  if (!open || !catalogue) return undefined;
  const isUnchanged = !isChanged && origin.kind === "example";
  const given = isUnchanged ? [] : assetsOf(open, catalogue, JSON.stringify(examples?.map(({ graph }) => graph)) ?? "");
  const options = [
    ...assetWords(given, fileOf).map((word) => ` --asset ${quoted(word)}`),
    ...Object.entries(values).map(([name, value]) => {
      const text = typeof value === "object" ? JSON.stringify(value) : String(value);
      return ` --set ${quoted(`${name}=${text}`)}`;
    }),
  ];
  const command = (graph: string): string => `dini eval ${graph}${options.join("")} -o ${fileName(open.title)}.glb`;
  if (isUnchanged) return command(`examples/${origin.id}.json`);
  if (!isChanged && origin.kind === "file") return command(quoted(origin.name));
  // The JSON is one line, so no line of it can be the word that ends it.
  return `${command("-")} <<'GRAPH'\n${JSON.stringify(open.json)}\nGRAPH`;
}

/** A mesh file that a graph names, and the node that does. */
interface NamedFile {
  asset: string;
  node: string;
}

/** The files that the graph names, each once, without those of the examples: the program has them too. */
function assetsOf(open: GraphDocument, catalogue: Catalogue, examples: string): NamedFile[] {
  const found = new Map<string, NamedFile>();
  const { nodes } = wholeCatalogue(catalogue, open);
  const add = (value: Json, node: string): void => {
    const asset = asString(value);
    if (asset && !examples.includes(`"${asset}"`) && !found.has(asset)) found.set(asset, { asset, node });
  };
  for (const node of nodesOf(open)) {
    for (const { name, namesFile } of nodes.get(node.type)?.inputs ?? []) {
      const source = node.inputs.get(name)?.[0];
      if (namesFile && source?.kind === "literal") add(source.value, node.id);
    }
  }
  // What an input of a group is when an instance leaves it out.
  for (const group of Object.keys(asObject(open.json["groups"]))) {
    for (const { name, namesFile, fallback } of nodes.get(GROUP_PREFIX + group)?.inputs ?? []) {
      if (namesFile && fallback !== undefined) add(fallback, name);
    }
  }
  return [...found.values()];
}

/** Those of the document and of all its groups. */
function nodesOf(open: GraphDocument): GraphNode[] {
  const groups = Object.keys(asObject(open.json["groups"]));
  const scopes = [lookedAt(open, []), ...groups.map((group) => lookedAt(open, [{ id: group, group }]))];
  return scopes.flatMap((scope) => [...scope.nodes.values()]);
}

/** "chair=chair.obj" for each: a name of its own, which the graph itself uses only if it does not name the hash. */
export function assetWords(files: readonly NamedFile[], fileOf: (hash: string) => string | undefined): string[] {
  const names = new Set<string>();
  return files.map(({ asset, node }) => {
    const isHash = /^[0-9a-f]{64}$/.test(asset);
    // A file from elsewhere is called like its node: whoever has it knows what to write instead.
    const file = fileOf(asset) ?? `${fileName(isHash ? node : asset)}.obj`;
    const stem = fileName(file.replace(/\.\w+$/, ""));
    let name = isHash ? stem : asset;
    for (let next = 2; names.has(name); next++) name = `${stem}-${next}`;
    names.add(name);
    return `${name}=${file}`;
  });
}

function quoted(text: string): string {
  return /^[\w./:=-]+$/.test(text) && !text.startsWith("-") ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}
