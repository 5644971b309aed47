// Which inputs of the selected node can be dragged in space, and how a drag is written back. From the catalogue's hints
// alone; knows neither three nor the page.

import type { Catalogue, InputCard } from "../model/catalogue";
import type { GraphDocument, GraphNode } from "../model/document";
import { isNumber, type Json } from "../model/json";
import { type Parameter, type ParameterValue, type ParameterValues, parameterValue } from "../model/parameters";

export type Vec = readonly [number, number, number];

interface Base {
  /** The same for the same handle of the same node, whatever its value. */
  key: string;
  /** What it moves, in words: "position of Point pair". */
  label: string;
  target: GizmoTarget;
}

export type Gizmo =
  | (Base & { kind: "position"; value: Vec })
  | (Base & { kind: "direction"; value: Vec; at: Vec })
  | (Base & { kind: "radius"; value: number; at: Vec; normal: Vec });

/** Where the dragged value is written: to the literal at an input, or to the parameter that drives it. */
export type GizmoTarget = { kind: "input"; node: string; port: string } | { kind: "parameter"; parameter: Parameter };

export interface GizmoSource {
  document: GraphDocument | null;
  catalogue: Catalogue | null;
  values: ParameterValues;
  selected: string | null;
  /** Places and directions that come over wires, by the input of the selected node, where they are known. */
  wired?: ReadonlyMap<string, Vec>;
}

/** An input that other handles hang on, and the wire that brings its value. */
export interface Anchor {
  port: string;
  node: string;
  output: string;
}

const ORIGIN: Vec = [0, 0, 0];
const UP: Vec = [0, 0, 1];

/** The wired inputs of the selected node that its handles hang on: only the server knows where those are. */
export function anchorsOf({ document, catalogue, selected }: GizmoSource): Anchor[] {
  const node = selected === null ? undefined : document?.nodes.get(selected);
  const card = node && catalogue?.nodes.get(node.type);
  const ports = new Set(card?.inputs.flatMap(({ handle }) => [handle?.at, handle?.normal]));
  return [...ports].flatMap((port): Anchor[] => {
    const [source, ...more] = (port !== undefined && node?.inputs.get(port)) || [];
    if (port === undefined || source?.kind !== "link" || more.length > 0) return [];
    const from = catalogue?.nodes.get(document?.nodes.get(source.node)?.type ?? "");
    const output = source.output ?? from?.outputs[0]?.name;
    return output === undefined ? [] : [{ port, node: source.node, output }];
  });
}

/** The draggable values of the selected node. Wired inputs, and values that are not finite, have none. */
export function gizmosOf({ document, catalogue, values, selected, wired }: GizmoSource): Gizmo[] {
  const node = selected === null ? undefined : document?.nodes.get(selected);
  const card = node && catalogue?.nodes.get(node.type);
  if (!document || !node || !card) return [];
  const read = (port: string | undefined): Held | undefined => {
    const input = card.inputs.find((one) => one.name === port);
    return input && held(document, values, node, input);
  };
  const anchor = (port: string | undefined, otherwise: Vec): Vec | undefined =>
    port === undefined ? otherwise : (wired?.get(port) ?? vectorOf(read(port)?.value));
  return card.inputs.flatMap((input): Gizmo[] => {
    const hint = input.handle;
    const own = hint && read(input.name);
    if (!hint || !own) return [];
    const base = { key: `${node.id}.${input.name}`, label: `${input.title} of ${card.title}`, target: own.target };
    const at = anchor(hint.at, ORIGIN);
    if (hint.kind === "position") {
      const value = vectorOf(own.value);
      return value ? [{ ...base, kind: "position", value }] : [];
    }
    // What hangs on a place that is not known cannot be drawn.
    if (!at) return [];
    if (hint.kind === "direction") {
      const value = vectorOf(own.value);
      return value && Math.hypot(...value) > 0 ? [{ ...base, kind: "direction", value, at }] : [];
    }
    const normal = anchor(hint.normal, UP);
    const value = own.value;
    if (!isNumber(value) || !normal || Math.hypot(...normal) === 0) return [];
    return [{ ...base, kind: "radius", value: Math.abs(value), at, normal }];
  });
}

interface Held {
  value: Json | ParameterValue;
  target: GizmoTarget;
}

function held(document: GraphDocument, values: ParameterValues, node: GraphNode, input: InputCard): Held | undefined {
  const [source, ...more] = node.inputs.get(input.name) ?? [];
  const target: GizmoTarget = { kind: "input", node: node.id, port: input.name };
  if (more.length > 0) return undefined;
  if (!source) return input.fallback === undefined ? undefined : { value: input.fallback, target };
  if (source.kind === "literal") return { value: source.value, target };
  if (source.kind === "link") return undefined;
  const parameter = document.parameters.find((one) => one.name === source.name);
  return parameter && { value: parameterValue(parameter, values), target: { kind: "parameter", parameter } };
}

/** Three finite numbers, or nothing. */
export function vectorOf(value: Json | ParameterValue | undefined): Vec | undefined {
  if (!Array.isArray(value) || value.length !== 3) return undefined;
  const [x, y, z] = value;
  return isNumber(x) && isNumber(y) && isNumber(z) ? [x, y, z] : undefined;
}
