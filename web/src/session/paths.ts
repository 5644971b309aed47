// Nodes as the server names them: within groups by the path of ids that leads to them.

import { readLink } from "../model/document";
import { asArray, asObject, asString, type JsonObject } from "../model/json";
import type { ParameterValues } from "../model/parameters";
import { groupNamed, prefixOf } from "../model/scope";
import type { Axis, NodeReport } from "../net/report";
import type { SessionState } from "./state";

/** The name of a node that is looked at. */
export function pathOf({ document }: Pick<SessionState, "document">, id: string): string {
  return prefixOf(document?.inside ?? []) + id;
}

const NONE = {};

/** The values of the parameters that are looked at: inputs of a group have none beside their defaults. */
export function valuesOf({ document, values }: Pick<SessionState, "document" | "values">): ParameterValues {
  return document && document.inside.length > 0 ? NONE : values;
}

/** The time of a node, of an instance that of everything in its group. */
export function timesOf(
  state: Pick<SessionState, "document" | "shown">,
  id: string,
): Pick<NodeReport, "cached" | "milliseconds"> | undefined {
  const nodes = state.shown?.report.nodes;
  const path = pathOf(state, id);
  const own = nodes?.get(path);
  if (own || !nodes) return own;
  const inner = [...nodes].filter(([name]) => name.startsWith(`${path}/`)).map(([, report]) => report);
  if (inner.length === 0) return undefined;
  return {
    cached: inner.every(({ cached }) => cached),
    milliseconds: inner.reduce((total, { milliseconds }) => total + milliseconds, 0),
  };
}

/** What the server says that an output carries: as checked, or as evaluated last. */
export function wireAt(
  state: Pick<SessionState, "document" | "catalogue" | "checked" | "shown">,
  node: string,
  output: string,
): { type: string; axes: Axis[] } | undefined {
  const place = placeBehind(state, node, output);
  if (!place) return undefined;
  return (
    state.checked?.wires.get(`${place.node}.${place.output}`) ??
    state.shown?.report.nodes.get(place.node)?.outputs.get(place.output)
  );
}

/** The node of the flat graph, and its output, whose value stands at an output that may be of a group. */
function placeBehind(
  { document, catalogue }: Pick<SessionState, "document" | "catalogue">,
  id: string,
  name: string,
): { node: string; output: string } | undefined {
  const groups = asObject(document?.json["groups"]);
  let [node, output] = [pathOf({ document }, id), name];
  let group = groupNamed(document?.nodes.get(id)?.type ?? "");
  while (group !== undefined) {
    const definition = asObject(groups[group]);
    const made = asArray(definition["outputs"])
      .map(asObject)
      .find((one) => one["name"] === output);
    if (!made) return undefined;
    const link = readLink(asString(made["from"]));
    const type = asString(asObject(asObject(definition["nodes"])[link.node])["type"]);
    group = groupNamed(type);
    const first = group === undefined ? catalogue?.nodes.get(type)?.outputs[0]?.name : firstOutput(groups, group);
    [node, output] = [`${node}/${link.node}`, link.output ?? first ?? ""];
  }
  return { node, output };
}

function firstOutput(groups: JsonObject, group: string): string {
  return asString(asObject(asArray(asObject(groups[group])["outputs"])[0])["name"]);
}
