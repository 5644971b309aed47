import assert from "node:assert/strict";
import { test } from "node:test";
import { type GraphDocument, readDocument, readLink } from "../src/model/document";
import { fileOutput, type ViewGraph, viewGraph } from "../src/model/graph";
import type { Json } from "../src/model/json";
import { layeredLayout, nodeHeight, nodeWidth } from "../src/model/layout";
import { randomFrom } from "./random";
import { catalogue, examples } from "./real";

function open(json: Json): GraphDocument {
  const result = readDocument(json);
  if ("error" in result) throw new Error(result.error);
  return result.document;
}

function assertNoOverlap(view: ViewGraph): void {
  const places = layeredLayout(view);
  assert.equal(places.size, view.nodes.length);
  const boxes = view.nodes.map((node) => ({
    ...(places.get(node.id) ?? { x: 0, y: 0 }),
    id: node.id,
    width: nodeWidth(node),
    height: nodeHeight(node),
  }));
  for (const a of boxes) {
    for (const b of boxes) {
      if (a === b || a.x + a.width <= b.x || b.x + b.width <= a.x) continue;
      assert.ok(a.y + a.height <= b.y || b.y + b.height <= a.y, `${a.id} and ${b.id} overlap`);
    }
  }
}

test("every example can be read, and every wire has a type of the catalogue", () => {
  for (const example of examples) {
    const document = open(example.graph as Json);
    const view = viewGraph(document, catalogue);
    assert.equal(view.nodes.length, document.nodes.size);
    assert.ok(view.wires.length > 0);
    for (const wire of view.wires) assert.ok(catalogue.types.has(wire.type), `${wire.id}: ${wire.type}`);
    assert.equal(fileOutput(document, catalogue), "out");
  }
});

test("a transform's wire has the type of what went in", () => {
  const graph = open({
    format: 1,
    nodes: {
      ball: { type: "sphere_mesh", inputs: {} },
      one: { type: "boost", inputs: { shape: { from: "ball" }, amount: { parameter: "reach" } } },
      two: { type: "boost", inputs: { shape: { from: "one.shape" } } },
      out: { type: "export", inputs: { model: [{ from: "two" }, { from: "ball" }] } },
    },
    parameters: { reach: { type: "number", default: 1, label: "How far" } },
  });
  const view = viewGraph(graph, catalogue);
  assert.deepEqual(
    view.wires.map((wire) => wire.type),
    ["mesh", "mesh", "mesh", "mesh"],
  );
  const row = view.nodes[1]?.inputs.find((input) => input.name === "amount");
  assert.equal(row?.parameter, "How far");
});

test("broken graphs are drawn as far as they go", () => {
  const view = viewGraph(
    open({
      format: 1,
      nodes: {
        a: { type: "no_such_node", inputs: { x: { from: "b" }, y: { from: "missing" } } },
        b: { type: "boost", inputs: { shape: { from: "c" }, bogus: 3 } },
        c: { type: "boost", inputs: { shape: { from: "b" } } },
      },
    }),
    catalogue,
  );
  assert.equal(view.nodes[0]?.known, false);
  assert.equal(view.nodes[1]?.inputs.find((row) => row.name === "bogus")?.value, "3");
  assert.equal(view.wires.length, 3);
  assertNoOverlap(view);
});

test("what is no graph is refused with a sentence", () => {
  for (const json of [null, 3, [], {}, { format: 3, nodes: {} }, { format: 1 }, { format: 1, nodes: [] }] as Json[]) {
    const result = readDocument(json);
    assert.ok("error" in result && /\.$/.test(result.error));
  }
});

test("links name a node, and an output where there are several", () => {
  assert.deepEqual(readLink("ring"), { node: "ring" });
  assert.deepEqual(readLink("patch.u"), { node: "patch", output: "u" });
});

test("positions are read from ui", () => {
  const document = open({
    format: 1,
    nodes: { a: { type: "x" } },
    ui: { nodes: { a: { x: 3, y: -4 }, ghost: { x: 1, y: 1 } } },
  });
  assert.deepEqual([...document.positions], [["a", { x: 3, y: -4 }]]);
});

test("the layout of examples and of random graphs has no overlaps and runs from left to right", () => {
  for (const example of examples) assertNoOverlap(viewGraph(open(example.graph as Json), catalogue));
  const random = randomFrom(7);
  for (let round = 0; round < 20; round++) {
    const nodes: Record<string, Json> = {};
    const count = 1 + random(60);
    for (let at = 0; at < count; at++) {
      const inputs: Record<string, Json> = {};
      if (at > 0) inputs["shape"] = { from: `n${random(at)}` };
      if (at > 1) inputs["generator"] = { from: `n${random(at)}` };
      nodes[`n${at}`] = { type: "boost", inputs };
    }
    const view = viewGraph(open({ format: 1, nodes }), catalogue);
    assertNoOverlap(view);
    const places = layeredLayout(view);
    for (const wire of view.wires) assert.ok((places.get(wire.from)?.x ?? 0) < (places.get(wire.to)?.x ?? 0));
  }
});

test("a chain of ten thousand nodes does not overflow the stack", () => {
  const nodes: Record<string, Json> = { n0: { type: "sphere_mesh" } };
  for (let at = 1; at < 10_000; at++) nodes[`n${at}`] = { type: "boost", inputs: { shape: { from: `n${at - 1}` } } };
  const reversed = Object.fromEntries(Object.entries(nodes).reverse());
  const view = viewGraph(open({ format: 1, nodes: reversed }), catalogue);
  assert.equal(view.wires.find((wire) => wire.from === "n9998")?.type, "mesh");
});
