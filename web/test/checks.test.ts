import assert from "node:assert/strict";
import { test } from "node:test";
import { failedChecks, withFailedChecks, withoutNodes } from "../src/net/checks";
import { readProblem } from "../src/net/problem";
import { readReport } from "../src/net/report";

const entry = (code: string, node: string) => ({
  code,
  node,
  detail: `${node}: ${code}`,
  pointer: node && `/graph/nodes/${node}`,
});
const problem = (...errors: object[]) => readProblem(422, { type: "/problems/check-failed", errors: errors as never });

test("only where checks alone stand in the way is the model asked for without them", () => {
  const nodes = (...errors: object[]): string[] => failedChecks(problem(...errors)).map(({ node }) => node);
  assert.deepEqual(nodes(entry("check-failed", "a"), entry("check-failed", "b")), ["a", "b"]);
  assert.deepEqual(nodes(entry("check-failed", "a"), entry("out-of-range", "b")), []);
  assert.deepEqual(nodes(entry("check-failed", "a"), { code: "out-of-range", node: "", pointer: "/parameters/k" }), []);
  assert.deepEqual(nodes(), []);
  // A line that only counts what was left out names no place.
  assert.deepEqual(nodes(entry("check-failed", "a"), { code: "more", detail: "and 12 more" }), ["a"]);
  assert.deepEqual(failedChecks({ ...problem(entry("check-failed", "a")), status: 500 }), []);
});

test("a request without checks lacks them in the graph and among the previews, and nothing else", () => {
  const graph = { format: 1, nodes: { a: { type: "x" }, b: { type: "y" } } };
  const failed = failedChecks(problem(entry("check-failed", "a")));
  const body = withoutNodes({ graph, parameters: { k: 1 }, output: "b", preview: ["a.value", "b.shape"] }, failed);
  assert.deepEqual(body, {
    graph: { format: 1, nodes: { b: { type: "y" } } },
    parameters: { k: 1 },
    output: "b",
    preview: ["b.shape"],
  });
  assert.equal(withoutNodes({ graph, parameters: {}, preview: ["a"] }, failed).preview, undefined);
});

test("the report of the second request tells what the first one failed for", () => {
  const report = readReport({
    checks: [{ node: "c", passed: true }],
    warnings: [entry("dangling-link", "d"), entry("other", "e")],
  });
  const answer = withFailedChecks(
    { kind: "model", report, model: new Uint8Array(), preview: null },
    failedChecks(problem(entry("check-failed", "a"))),
  );
  assert.ok(answer.kind === "model");
  assert.deepEqual(answer.report.checks, [
    { node: "c", passed: true, message: "" },
    { node: "a", passed: false, message: "a: check-failed" },
  ]);
  assert.deepEqual(
    answer.report.warnings.map(({ code }) => code),
    ["other"],
  );
});
