// What is asked of POST /v1/evaluate and /v1/gradient, and what comes back.

import type { JsonObject } from "../model/json";
import type { ParameterValues } from "../model/parameters";
import type { Problem } from "./problem";
import type { Report } from "./report";

export type Quality = "draft" | "final";

export interface EvaluateBody {
  graph: JsonObject;
  parameters: ParameterValues;
  output?: string;
  /** Nodes, or outputs of them, to draw beside the model. */
  preview?: string[];
  /** Whether the report tells of the parts of the model. */
  parts?: boolean;
}

/** What moves with which parameters. */
export interface GradientBody {
  graph: JsonObject;
  parameters: ParameterValues;
  by: string[];
}

/** How good an answer has to be. Drafts have about `triangles` triangles. */
export interface Effort {
  quality: Quality;
  triangles: number;
  /** The name of the format of the model; GLB without one. */
  format?: string;
}

export type Answer =
  | { kind: "model"; report: Report; model: Uint8Array<ArrayBuffer>; preview: Uint8Array<ArrayBuffer> | null }
  | { kind: "problem"; problem: Problem }
  /** Nothing usable came: no connection, or the server is crowded and asks to wait. */
  | { kind: "away"; retryAfter?: number; isCrowded?: boolean };
