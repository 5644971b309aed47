// The catalogue of node types as GET /v1/nodes answers it. Everything the page knows about nodes comes from here.

import { asArray, asNumber, asObject, asString, isNumber, type Json, type JsonObject } from "./json";
import { sentenceCase } from "./parameters";

/** A wire type: what its sockets and wires look like. */
export interface WireType {
  name: string;
  family: string;
  color: string;
  shape: string;
  description: string;
  /** Given as literals only: there are no wires of this type. */
  literalOnly: boolean;
}

/** An input of a node type: what it accepts and the literal it falls back to. */
export interface InputCard {
  name: string;
  /** As people read it: "Clip radius". */
  title: string;
  types: string[];
  description: string;
  required: boolean;
  several: boolean;
  fallback?: Json;
  /** What a new node is given here, where the default stays for the sake of older documents. */
  beginning?: Json;
  unit: string;
  /** Outside of these the server refuses a value. */
  minimum?: number;
  maximum?: number;
  /** The range of a slider. */
  softMinimum?: number;
  softMaximum?: number;
  step?: number;
  choices: string[];
  /** Nothing can be written here, whatever the types are. */
  linksOnly: boolean;
  /** The text names a file kept by the server. */
  namesFile: boolean;
  /** The text names an axis that the node makes. */
  makesAxis: boolean;
  /** What stands for an empty text, in a few words; empty where it stands for itself. */
  emptyMeans: string;
  /** How the value is dragged in space, where it can be. */
  handle?: HandleHint;
}

/** A value in space; `at` and `normal` name the inputs of the same node that say where it is. */
export interface HandleHint {
  kind: "position" | "direction" | "radius";
  at?: string;
  normal?: string;
}

/** An output of a node type; `sameAs` names the input whose type it repeats. */
export interface OutputCard {
  name: string;
  title: string;
  types: string[];
  description: string;
  sameAs?: string;
}

export interface NodeCard {
  id: string;
  title: string;
  family: string;
  /** Other words, in lower case, by which people look for it. */
  synonyms: string[];
  description: string;
  /** More than the one sentence of `description`; may be empty. */
  details: string;
  source: string;
  inputs: InputCard[];
  outputs: OutputCard[];
  legend?: LegendHint;
}

/** Where the scale of the colors stands that a node gives to meshes: names of its inputs and outputs. */
export interface LegendHint {
  /** The input that names the palette. */
  palette: string;
  /** Inputs with the numbers at both ends of the palette. */
  ends?: [string, string];
  /** Or: the input with the number at one end, with the other one opposite; 0 is the largest found. */
  range?: string;
  /** Outputs with the least and the greatest number found. */
  found?: [string, string];
  /** The input that says what is shown, and the units of its choices. */
  kind?: string;
  units?: Readonly<Record<string, string>>;
  /** Linear red, green and blue at even places, by palette. */
  colors: Readonly<Record<string, readonly (readonly number[])[]>>;
}

/** A format that models are written in. */
export interface FileFormat {
  /** What requests call it: "glb". */
  name: string;
  mediaType: string;
  /** With its period. */
  extension: string;
  description: string;
}

export interface Catalogue {
  engine: string;
  /** The usual one first. */
  formats: FileFormat[];
  types: Map<string, WireType>;
  families: Map<string, string>;
  nodes: Map<string, NodeCard>;
}

/** Type of the values that leave the graph as bytes: a node that makes one is something to evaluate and download. */
export const FILE_TYPE = "asset";

const UNKNOWN_TYPE: WireType = {
  name: "unknown",
  family: "",
  color: "#8B94A3",
  shape: "circle",
  description: "",
  literalOnly: false,
};

/** Reads the answer of GET /v1/nodes; missing texts become empty, cards without an id are left out. */
export function readCatalogue(json: Json): Catalogue {
  const root = asObject(json);
  const catalogue: Catalogue = {
    engine: asString(root["engine"]),
    formats: asArray(root["formats"]).map(asObject).map(readFormat),
    types: new Map(),
    families: new Map(),
    nodes: new Map(),
  };
  for (const item of asArray(root["types"]).map(asObject)) {
    const name = asString(item["name"]);
    const color = asString(item["color"]) || UNKNOWN_TYPE.color;
    const shape = asString(item["shape"]) || UNKNOWN_TYPE.shape;
    const literalOnly = item["literal_only"] === true;
    const [family, description] = [asString(item["family"]), asString(item["description"])];
    catalogue.types.set(name, { name, family, color, shape, description, literalOnly });
  }
  for (const item of asArray(root["families"]).map(asObject)) {
    catalogue.families.set(asString(item["name"]), asString(item["title"]));
  }
  for (const item of asArray(root["nodes"]).map(asObject)) {
    const card = readCard(item);
    if (card.id) catalogue.nodes.set(card.id, card);
  }
  return catalogue;
}

function readFormat(item: JsonObject): FileFormat {
  return {
    name: asString(item["name"]),
    mediaType: asString(asArray(item["media_types"])[0]),
    extension: asString(item["extension"]),
    description: asString(item["description"]),
  };
}

/** The look of a wire type; a neutral one for a type the catalogue does not list. */
export function wireType(catalogue: Catalogue, name: string | undefined): WireType {
  return (name !== undefined && catalogue.types.get(name)) || UNKNOWN_TYPE;
}

/** True if wires may end at the input; others take literals and parameters only. */
export function takesWires(catalogue: Catalogue, input: InputCard): boolean {
  return input.types.some((type) => !catalogue.types.get(type)?.literalOnly);
}

/** The unit as written behind a number. */
export function unitText(unit: string): string {
  if (unit === "deg") return "°";
  return unit ? `\u202f${unit}` : "";
}

/** Reads one card; what is missing is empty. */
export function readCard(item: Record<string, Json>): NodeCard {
  const id = asString(item["id"]);
  return {
    id,
    title: asString(item["title"]) || id,
    family: asString(item["family"]),
    synonyms: asArray(item["synonyms"]).map(asString),
    description: asString(item["description"]),
    details: asString(item["details"]),
    source: asString(item["source"]),
    inputs: asArray(item["inputs"]).map(asObject).map(readInput),
    outputs: asArray(item["outputs"]).map(asObject).map(readOutput),
    legend: readLegend(asObject(item["legend"])),
  };
}

function readLegend(item: JsonObject): LegendHint | undefined {
  const palette = asString(item["palette"]);
  if (!palette) return undefined;
  const pair = (value: Json): [string, string] | undefined => {
    const [first, second] = asArray(value).map(asString);
    return first && second ? [first, second] : undefined;
  };
  return {
    palette,
    ends: pair(item["ends"]),
    range: asString(item["range"]) || undefined,
    found: pair(item["found"]),
    kind: asString(item["kind"]) || undefined,
    colors: Object.fromEntries(
      Object.entries(asObject(item["colors"])).map(([name, list]) => [
        name,
        asArray(list).map((color) => asArray(color).filter(isNumber)),
      ]),
    ),
    units: Object.fromEntries(Object.entries(asObject(item["units"])).map(([name, unit]) => [name, asString(unit)])),
  };
}

function readInput(item: Record<string, Json>): InputCard {
  return {
    name: asString(item["name"]),
    title: titleOf(item),
    types: asArray(item["types"]).map(asString),
    description: asString(item["description"]),
    required: item["required"] === true,
    several: item["several"] === true || isNumber(item["several"]),
    fallback: item["default"],
    beginning: item["begin"],
    unit: asString(item["unit"]),
    minimum: asNumber(item["min"]),
    maximum: asNumber(item["max"]),
    softMinimum: asNumber(item["soft_min"]),
    softMaximum: asNumber(item["soft_max"]),
    step: asNumber(item["step"]),
    choices: asArray(item["choices"]).map(asString),
    linksOnly: item["links_only"] === true,
    namesFile: item["names_file"] === true,
    makesAxis: item["makes_axis"] === true,
    emptyMeans: asString(item["empty_means"]),
    handle: readHandle(asObject(item["handle"])),
  };
}

/** The title, or the words of the name where a server tells none. */
function titleOf(item: JsonObject): string {
  return asString(item["title"]) || sentenceCase(asString(item["name"]));
}

function readHandle({ kind, at, normal }: Record<string, Json>): HandleHint | undefined {
  if (kind !== "position" && kind !== "direction" && kind !== "radius") return undefined;
  return { kind, at: asString(at) || undefined, normal: asString(normal) || undefined };
}

function readOutput(item: Record<string, Json>): OutputCard {
  return {
    name: asString(item["name"]),
    title: titleOf(item),
    types: asArray(item["types"]).map(asString),
    description: asString(item["description"]),
    sameAs: asString(item["same_as"]) || undefined,
  };
}
