// What a GLB of our server holds, checked and as plain data: nodes with their primitives, compressed or not. Knows
// neither three nor the browser. Files of others may hold more; what is unknown here is an error and never a wrong picture.

import { asArray, asNumber, asObject, asString, isNumber, isObject, type Json, type JsonObject } from "../model/json";
import { readAccessor, readView, type Values } from "./accessors";
import { splitGlb, type Glb } from "./glb";

export type PrimitiveMode = "points" | "lines" | "line-strip" | "triangles";

/** Linear red, green, blue and alpha. */
export type Rgba = readonly [number, number, number, number];

export interface GltfPrimitive {
  mode: PrimitiveMode;
  color: Rgba;
  translucent: boolean;
  /** Attributes by their glTF name. Of a compressed primitive they stand in `draco`, and this is empty. */
  attributes: Map<string, Values>;
  indices: Uint32Array<ArrayBuffer> | undefined;
  draco: DracoPart | undefined;
}

/** Compressed data, and which of its attributes is which: by glTF name, its unique id and how it is to be stored. */
export interface DracoPart {
  bytes: Uint8Array<ArrayBuffer>;
  attributes: { name: string; id: number; component: number }[];
}

export interface GltfNode {
  name: string;
  extras: JsonObject;
  /** Quaternion x, y, z, w. */
  rotation: [number, number, number, number];
  translation: [number, number, number];
  scale: [number, number, number];
  primitives: GltfPrimitive[];
  children: GltfNode[];
}

export interface GltfFile {
  roots: GltfNode[];
  /** `asset.extras`: what made the file. */
  extras: JsonObject;
}

const DRACO = "KHR_draco_mesh_compression";
const MODES: Readonly<Record<number, PrimitiveMode>> = { 0: "points", 1: "lines", 3: "line-strip", 4: "triangles" };
const DEEPEST = 64;
const WHITE: Rgba = [1, 1, 1, 1];

/** Reads a GLB. Throws with a readable message if anything in it is broken or unknown. */
export function readGltf(bytes: Uint8Array<ArrayBuffer>): GltfFile {
  const glb = splitGlb(bytes);
  for (const name of asArray(glb.json["extensionsRequired"])) {
    if (name !== DRACO) throw new Error(`The model needs the extension ${String(name)}, which is not read here.`);
  }
  const scenes = asArray(glb.json["scenes"]);
  const scene = asObject(scenes[asNumber(glb.json["scene"]) ?? 0]);
  // A node may stand in one place only, which also rules out circles.
  const seen = new Set<number>();
  const roots = asArray(scene["nodes"]).map((index) => readNode(glb, index, seen, 0));
  return { roots, extras: asObject(asObject(glb.json["asset"])["extras"]) };
}

function readNode(glb: Glb, index: Json, seen: Set<number>, depth: number): GltfNode {
  const item = entry(glb, "nodes", index);
  if (depth > DEEPEST || seen.has(index as number)) throw new Error("The nodes of the model are not a tree.");
  seen.add(index as number);
  if (item["matrix"] !== undefined) throw new Error("A node of the model has a matrix, which is not read here.");
  const { rotation, translation, scale } = item;
  const mesh = item["mesh"] === undefined ? {} : entry(glb, "meshes", item["mesh"]);
  return {
    name: asString(item["name"]),
    extras: asObject(item["extras"]),
    rotation: tuple(rotation, [0, 0, 0, 1]),
    translation: tuple(translation, [0, 0, 0]),
    scale: tuple(scale, [1, 1, 1]),
    primitives: asArray(mesh["primitives"]).map((primitive) => readPrimitive(glb, asObject(primitive))),
    children: asArray(item["children"]).map((child) => readNode(glb, child, seen, depth + 1)),
  };
}

function readPrimitive(glb: Glb, item: JsonObject): GltfPrimitive {
  const mode = MODES[asNumber(item["mode"]) ?? 4];
  if (!mode) throw new Error(`The model has primitives of mode ${String(item["mode"])}, which is not read here.`);
  const material = item["material"] === undefined ? {} : entry(glb, "materials", item["material"]);
  const surface = asObject(material["pbrMetallicRoughness"]);
  const primitive: GltfPrimitive = {
    mode,
    color: tuple(surface["baseColorFactor"], WHITE),
    translucent: material["alphaMode"] === "BLEND",
    attributes: new Map(),
    indices: undefined,
    draco: undefined,
  };
  const names = Object.entries(asObject(item["attributes"]));
  const extension = asObject(item["extensions"])[DRACO];
  if (isObject(extension)) {
    const ids = asObject(extension["attributes"]);
    primitive.draco = {
      bytes: readView(glb, extension["bufferView"]),
      attributes: names.flatMap(([name, accessor]) => {
        const [id, component] = [ids[name], entry(glb, "accessors", accessor)["componentType"]];
        return isNumber(id) && isNumber(component) ? [{ name, id, component }] : [];
      }),
    };
    return primitive;
  }
  for (const [name, accessor] of names) primitive.attributes.set(name, readAccessor(glb, accessor));
  const positions = primitive.attributes.get("POSITION");
  if (!positions || positions.size !== 3) throw new Error("A part of the model has no positions.");
  const count = positions.array.length / 3;
  if (item["indices"] !== undefined) {
    primitive.indices = Uint32Array.from(readAccessor(glb, item["indices"]).array);
    if (primitive.indices.some((at) => at >= count)) throw new Error("The model names a vertex that it does not have.");
  }
  return primitive;
}

/** An entry of one of the lists at the top of the file. */
export function entry(glb: Glb, list: string, index: Json): JsonObject {
  const item = isNumber(index) ? asArray(glb.json[list])[index] : undefined;
  if (!isObject(item)) throw new Error(`The model has no entry ${String(index)} in its ${list}.`);
  return item;
}

function tuple<T extends readonly number[]>(json: Json, fallback: T): T {
  const list = asArray(json);
  const isFit = list.length === fallback.length && list.every(isNumber);
  return (isFit ? list : [...fallback]) as unknown as T;
}
