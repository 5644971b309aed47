// Nodes as the server names them: within groups by the path of ids that leads to them.

import type { ParameterValues } from "../model/parameters";
import { prefixOf } from "../model/scope";
import type { NodeReport } from "../net/report";
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
