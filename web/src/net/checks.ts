// A check that cannot run fails the whole evaluation, which is right for whoever relies on it. Who is about to connect one
// still wants to see the model: the page then asks once more without it, and says what is wrong with it beside.

import { asObject, type JsonObject } from "../model/json";
import type { Problem, ProblemEntry } from "./problem";
import type { Answer, EvaluateBody } from "./requests";

const CODE = "check-failed";

/** The failed checks, if nothing else stands in the way; else none. */
export function failedChecks(problem: Problem): ProblemEntry[] {
  // What is about no place of the graph only counts further errors.
  const errors = problem.errors.filter(({ node, pointer }) => node !== "" || pointer !== "");
  return problem.status === 422 && errors.every(({ code, node }) => code === CODE && node !== "") ? errors : [];
}

/** The same request without some nodes. What depends on them is refused by the server as any broken graph is. */
export function withoutNodes(body: EvaluateBody, entries: readonly ProblemEntry[]): EvaluateBody {
  const gone = new Set(entries.map(({ node }) => node));
  const nodes = Object.entries(asObject(body.graph["nodes"])).filter(([id]) => !gone.has(id));
  const preview = body.preview?.filter((name) => !gone.has(name.split(".")[0] ?? name));
  return {
    ...body,
    graph: { ...body.graph, nodes: Object.fromEntries(nodes) as JsonObject },
    ...(preview && { preview: preview.length > 0 ? preview : undefined }),
  };
}

/** The answer of the second request, which tells of the checks that the first one failed for. */
export function withFailedChecks(answer: Extract<Answer, { kind: "model" }>, entries: readonly ProblemEntry[]): Answer {
  const { report } = answer;
  const failed = entries.map(({ node, detail }) => ({ node, passed: false, message: detail }));
  // Links to a node that was left out for the moment are no news.
  const warnings = report.warnings.filter(({ code }) => code !== "dangling-link");
  return { ...answer, report: { ...report, warnings, checks: [...report.checks, ...failed] } };
}
