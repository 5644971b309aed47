// Cards of a document's groups, so that their instances are drawn, searched, wired and typed as any other node.

import { type Catalogue, type InputCard, type NodeCard, readCard } from "./catalogue";
import { type GraphDocument, lookedAt, readLink } from "./document";
import { asArray, asObject, asString, type Json, type JsonObject } from "./json";
import { sentenceCase } from "./parameters";
import { GROUP_PREFIX, groupNamed } from "./scope";
import { OutputTypes } from "./types";

export const GROUP_FAMILY = "groups";

/**
 * The catalogue with the groups of a document; the catalogue itself where there are none. Groups that hold the one that is
 * looked at are left out: an instance of them in it would have no end.
 */
export function withGroups(catalogue: Catalogue, document: GraphDocument): Catalogue {
  const groups = asObject(document.json["groups"]);
  const names = Object.keys(groups);
  if (names.length === 0) return catalogue;
  const all: Catalogue = {
    ...catalogue,
    nodes: new Map(catalogue.nodes),
    families: new Map([...catalogue.families, [GROUP_FAMILY, "Groups of this graph"]]),
  };
  const around = new Set(document.inside.map(({ group }) => group));
  for (const name of inOrderOfNesting(groups)) {
    if (around.has(name) || groupsIn(groups, name).some((inner) => around.has(inner))) continue;
    all.nodes.set(GROUP_PREFIX + name, groupCard(name, asObject(groups[name]), document, all));
  }
  return all;
}

/**
 * The catalogue for the nodes of the whole document, made of the one for what is looked at: with the groups that may not
 * stand in there.
 */
export function wholeCatalogue(catalogue: Catalogue, document: GraphDocument): Catalogue {
  return document.inside.length === 0 ? catalogue : withGroups(catalogue, lookedAt(document, []));
}

/** The groups whose instances stand in a group, at any depth, each once. */
export function groupsIn(groups: JsonObject, name: string): string[] {
  const found = new Set<string>();
  const open = [name];
  for (const at of open) {
    for (const node of Object.values(asObject(asObject(groups[at])["nodes"]))) {
      const inner = groupNamed(asString(asObject(node)["type"]));
      if (inner === undefined || found.has(inner)) continue;
      found.add(inner);
      open.push(inner);
    }
  }
  return [...found];
}

function inOrderOfNesting(groups: JsonObject): string[] {
  const depth = new Map(Object.keys(groups).map((name) => [name, groupsIn(groups, name).length]));
  return [...depth.keys()].sort((a, b) => (depth.get(a) ?? 0) - (depth.get(b) ?? 0));
}

function groupCard(name: string, group: JsonObject, whole: GraphDocument, catalogue: Catalogue): NodeCard {
  const document = lookedAt(whole, [{ id: name, group: name }]);
  const types = new OutputTypes(document, catalogue);
  const inputs = asArray(group["inputs"]).map(asObject);
  const places = inputs.map((input) => placesOf(asString(input["name"]), document, catalogue));
  const skeleton = readCard({
    id: GROUP_PREFIX + name,
    title: asString(group["label"]) || sentenceCase(name),
    family: GROUP_FAMILY,
    description: asString(group["description"]),
    inputs: inputs.map((input, at) => inputItem(input, places[at] ?? [])),
    outputs: asArray(group["outputs"])
      .map(asObject)
      .map((output) => {
        const { node, output: port } = readLink(asString(output["from"]));
        const label = sentenceCase(asString(output["name"]));
        return {
          name: output["name"],
          title: label,
          types: [...types.possible(node, port)],
          description: `${label}, of ${node} in the group.`,
          same_as: inputBehind(document, catalogue, node, port),
        };
      }),
  });
  return {
    ...skeleton,
    inputs: skeleton.inputs.map((input, at) => {
      const first = places[at]?.[0];
      if (!first) return input;
      const { unit, minimum, maximum, softMinimum, softMaximum, step, choices, linksOnly, namesFile } = first;
      return { ...input, unit, minimum, maximum, softMinimum, softMaximum, step, choices, linksOnly, namesFile };
    }),
  };
}

function inputItem(input: JsonObject, places: readonly InputCard[]): JsonObject {
  const [first] = places;
  const types = (first?.types ?? ["number"]).filter((type) => places.every((place) => place.types.includes(type)));
  const usual = input["default"] ?? (places.length === 1 ? first?.fallback : undefined);
  return {
    name: input["name"],
    title: asString(input["label"]) || sentenceCase(asString(input["name"])),
    types: types.length > 0 || !first ? types : first.types,
    description: asString(input["description"]) || (first?.description ?? "Reaches nothing in the group yet."),
    required: input["default"] === undefined && places.some((place) => place.required),
    several: places.length > 0 && places.every((place) => place.several),
    default: usual as Json,
  };
}

/** The inputs of nodes that an input of the group reaches. */
function placesOf(name: string, document: GraphDocument, catalogue: Catalogue): InputCard[] {
  return [...document.nodes.values()].flatMap((node) =>
    [...node.inputs].flatMap(([port, sources]) => {
      const isReached = sources.some((source) => source.kind === "parameter" && source.name === name);
      const card = isReached ? catalogue.nodes.get(node.type)?.inputs.find((one) => one.name === port) : undefined;
      return card ? [card] : [];
    }),
  );
}

/** The input of the group whose type an output repeats. */
function inputBehind(
  document: GraphDocument,
  catalogue: Catalogue,
  start: string,
  port: string | undefined,
): string | undefined {
  const types = new OutputTypes(document, catalogue);
  const seen = new Set<string>();
  let [id, output] = [start, port];
  while (!seen.has(id)) {
    seen.add(id);
    const node = document.nodes.get(id);
    const card = node && catalogue.nodes.get(node.type);
    const name = types.outputName(id, output);
    const made = card?.outputs.find((one) => one.name === name);
    const sources = (made?.sameAs !== undefined && node?.inputs.get(made.sameAs)) || [];
    const parameter = sources.find((source) => source.kind === "parameter");
    if (parameter?.kind === "parameter") return parameter.name;
    const link = sources.find((source) => source.kind === "link");
    if (link?.kind !== "link") return undefined;
    [id, output] = [link.node, link.output];
  }
  return undefined;
}
