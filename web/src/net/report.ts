// The report that comes with every evaluated model.

import { asArray, asNumber, asObject, asString, isNumber, isObject, type Json, type JsonObject } from "../model/json";
import { type ProblemEntry, readEntry } from "./problem";

export interface Axis {
  name: string;
  size: number;
  closed: boolean;
}

export interface NodeReport {
  milliseconds: number;
  cached: boolean;
  outputs: Map<string, { type: string; axes: Axis[] }>;
}

export interface Check {
  node: string;
  passed: boolean;
  message: string;
}

/** A part of a model, and of a mesh whether it is a solid; lengths in meters. */
export interface PartReport {
  name: string;
  isMesh: boolean;
  isWatertight: boolean;
  borders: number;
  pieces: number;
  contacts: number;
  leastThickness: number;
  volume: number;
}

export interface Report {
  quality: string;
  prepare: number;
  evaluate: number;
  encode: number;
  nodes: Map<string, NodeReport>;
  bytes: number;
  vertices: number;
  triangles: number;
  /** How far values of a kind ("position", "normal") may be from their originals. */
  errors: ReadonlyMap<string, number>;
  checks: Check[];
  warnings: ProblemEntry[];
  /** Empty unless they were asked for. */
  parts: PartReport[];
}

const ERROR_ENDING = "_error";

export function readReport(json: Json): Report {
  const root = asObject(json);
  const times = asObject(root["milliseconds"]);
  const model = asObject(root["model"]);
  const nodes = new Map<string, NodeReport>();
  for (const [id, item] of Object.entries(asObject(root["nodes"]))) nodes.set(id, readNode(item));
  return {
    quality: asString(root["quality"]),
    prepare: asNumber(times["prepare"]) ?? 0,
    evaluate: asNumber(times["evaluate"]) ?? 0,
    encode: asNumber(times["encode"]) ?? 0,
    nodes,
    bytes: asNumber(model["bytes"]) ?? 0,
    vertices: asNumber(model["vertices"]) ?? 0,
    triangles: asNumber(model["triangles"]) ?? 0,
    errors: new Map(
      Object.entries(model).flatMap(([name, error]) =>
        name.endsWith(ERROR_ENDING) && isNumber(error) ? [[name.slice(0, -ERROR_ENDING.length), error] as const] : [],
      ),
    ),
    checks: asArray(root["checks"])
      .filter(isObject)
      .map((item) => ({
        node: asString(item["node"]),
        passed: item["passed"] === true,
        message: asString(item["message"]),
      })),
    warnings: asArray(root["warnings"]).map(readEntry),
    parts: asArray(root["parts"]).map(asObject).map(readPart),
  };
}

/** "circle over k: 96, j: 12 closed" */
export function axesText(type: string, axes: readonly Axis[]): string {
  if (axes.length === 0) return type;
  return `${type} over ${axes.map((axis) => `${axis.name}: ${axis.size}${axis.closed ? " closed" : ""}`).join(", ")}`;
}

export function readAxes(json: Json): Axis[] {
  return asArray(json)
    .map(asObject)
    .map((axis) => ({
      name: asString(axis["name"]),
      size: asNumber(axis["size"]) ?? 0,
      closed: axis["closed"] === true,
    }));
}

function readPart(part: JsonObject): PartReport {
  return {
    name: asString(part["name"]),
    isMesh: part["type"] === "mesh",
    isWatertight: part["watertight"] === true,
    borders: asNumber(part["boundary_loops"]) ?? 0,
    pieces: asNumber(part["components"]) ?? 0,
    contacts: asNumber(part["self_intersections"]) ?? 0,
    leastThickness: asNumber(part["least_thickness"]) ?? 0,
    volume: asNumber(part["volume"]) ?? 0,
  };
}

function readNode(json: Json): NodeReport {
  const item = asObject(json);
  const outputs: NodeReport["outputs"] = new Map();
  for (const [name, value] of Object.entries(asObject(item["outputs"]))) {
    const output = asObject(value);
    outputs.set(name, { type: asString(output["type"]), axes: readAxes(output["axes"]) });
  }
  return { milliseconds: asNumber(item["milliseconds"]) ?? 0, cached: item["cached"] === true, outputs };
}
