// Random edits: a graph that was valid stays valid, and undo is the inverse of every edit.

import assert from "node:assert/strict";
import { test } from "node:test";
import { WireCheck } from "../src/model/check";
import { copyText, paste, readClip } from "../src/model/clip";
import { emptyDocument, type GraphDocument, readDocument } from "../src/model/document";
import {
  addNodes,
  type Edit,
  freeId,
  moveNodes,
  removeNodes,
  renameNode,
  setBypass,
  setInput,
} from "../src/model/edit";
import { conceal, expose, removeParameter } from "../src/model/edit_parameters";
import { replaceNode } from "../src/model/edit_replace";
import { addFrame, addNote, collectMembers, freeName, moveFrame, removeFrame, setFlag } from "../src/model/edit_ui";
import { connect, disconnect, insertOnWire, removeAndHeal } from "../src/model/edit_wires";
import { viewGraph } from "../src/model/graph";
import { History } from "../src/model/history";
import type { Json } from "../src/model/json";
import { type Random, randomFrom } from "./random";
import { catalogue, examples } from "./real";

function open(json: Json): GraphDocument {
  const result = readDocument(json);
  if ("error" in result) throw new Error(result.error);
  return result.document;
}

function pick<Item>(random: Random, items: readonly Item[]): Item | undefined {
  return items[random(Math.max(1, items.length))];
}

/** One random edit a person could make. */
function randomEdit(random: Random, document: GraphDocument): Edit {
  const ids = [...document.nodes.keys()];
  const view = viewGraph(document, catalogue);
  const id = pick(random, ids) ?? "";
  const some = ids.filter(() => random(4) === 0);
  const wire = pick(random, view.wires);
  const card = pick(random, [...catalogue.nodes.values()]);
  const position = { x: random(2000), y: random(1000) };
  switch (random(19)) {
    case 0:
    case 1:
    case 2:
    case 3:
      return addNodes([{ id: freeId(document, card?.id ?? "node"), type: card?.id ?? "", position }]);
    case 4:
    case 5:
    case 6:
    case 7:
    case 8: {
      const [from, to] = [pick(random, view.nodes), pick(random, view.nodes)];
      const [output, input] = [
        pick(random, from?.outputs ?? [])?.name ?? "",
        pick(random, [...(to?.inputs ?? []), ...(to?.folded ?? [])])?.name ?? "",
      ];
      const connection = { from: from?.id ?? "", output, to: to?.id ?? "", input };
      const refused = new WireCheck(document, catalogue).refusal(connection);
      return refused === undefined ? connect(catalogue, connection) : (same) => same;
    }
    case 9:
      return wire ? disconnect(wire) : (same) => same;
    case 10:
      return removeNodes(some);
    case 11:
      return removeAndHeal(catalogue, some);
    case 12:
      return wire ? insertOnWire(catalogue, id, wire) : (same) => same;
    case 13:
      return renameNode(id, freeId(document, pick(random, ["a", "ring", "Long-name"]) ?? "a"));
    case 14: {
      const clip = readClip(copyText(document, new Set(some)) ?? "");
      return clip ? paste(document, clip, { x: 30, y: 30 }, random(2) === 0).edit : (same) => same;
    }
    case 15:
      return replaceNode(catalogue, id, card?.id ?? "");
    case 16: {
      const input = pick(random, catalogue.nodes.get(document.nodes.get(id)?.type ?? "")?.inputs ?? []);
      if (!input || (document.nodes.get(id)?.inputs.get(input.name) ?? []).length > 0) return (same) => same;
      return random(2) === 0 ? expose(id, input, input.fallback) : setInput(id, input.name, input.fallback);
    }
    case 17: {
      const parameter = pick(random, document.parameters);
      if (!parameter) return (same) => same;
      const row = view.nodes.flatMap((node) =>
        node.inputs.filter((one) => one.parameterName === parameter.name).map((one) => ({ node: node.id, one })),
      )[0];
      if (row && random(2) === 0) return conceal(row.node, row.one.name, parameter.name, parameter.initial);
      return removeParameter(parameter.name, parameter.initial);
    }
    default:
      return pick(random, [
        setBypass(some, random(2) === 0),
        setFlag(some, "preview", random(2) === 0),
        setFlag(some, "collapsed", random(2) === 0),
        moveNodes(new Map(some.map((one) => [one, position]))),
        addFrame({
          id: freeName(document.frames, "frame"),
          title: "F",
          color: "blue",
          ...position,
          width: 300,
          height: 200,
          nodes: some,
        }),
        addNote({ id: freeName(document.notes, "note"), text: "N", ...position, width: 200, height: 90 }),
        moveFrame(document.frames[0]?.id ?? "", position),
        removeFrame(document.frames[0]?.id ?? ""),
        collectMembers(ids, (one) => ({ ...(document.positions.get(one) ?? position), width: 190, height: 80 })),
      ]) as Edit;
  }
}

function assertValid(document: GraphDocument, context: string): void {
  const again = open(JSON.parse(JSON.stringify(document.json)) as Json);
  assert.deepEqual(
    again,
    JSON.parse(JSON.stringify(document.json)) && { ...document, json: again.json },
    `${context}: read again`,
  );
  const [{ types }, parameters] = [
    new WireCheck(document, catalogue),
    new Set(document.parameters.map(({ name }) => name)),
  ];
  for (const node of document.nodes.values()) {
    const card = catalogue.nodes.get(node.type);
    assert.ok(card, `${context}: ${node.id} has a type`);
    assert.ok(document.positions.has(node.id), `${context}: ${node.id} has a place`);
    for (const [name, sources] of node.inputs) {
      const input = card.inputs.find((item) => item.name === name);
      assert.ok(input, `${context}: ${node.id}.${name} exists`);
      assert.ok(sources.length === 1 || input.several, `${context}: one wire at ${node.id}.${name}`);
      for (const source of sources) {
        if (source.kind === "parameter") assert.ok(parameters.has(source.name), `${context}: parameter ${source.name}`);
        if (source.kind !== "link") continue;
        assert.ok(document.nodes.has(source.node), `${context}: ${node.id}.${name} is not dangling`);
        const offered = types.possible(source.node, source.output);
        assert.ok(
          offered.some((type) => input.types.includes(type)),
          `${context}: ${source.node} fits ${node.id}.${name}`,
        );
      }
    }
  }
  assert.ok(isAcyclic(document), `${context}: no cycle`);
  for (const frame of document.frames) for (const id of frame.nodes) assert.ok(document.nodes.has(id));
}

function isAcyclic(document: GraphDocument): boolean {
  const left = new Map([...document.nodes.values()].map((node) => [node.id, [...node.inputs.values()].flat()]));
  for (let moved = true; moved; ) {
    moved = false;
    for (const [id, sources] of left) {
      if (sources.some((source) => source.kind === "link" && left.has(source.node))) continue;
      left.delete(id);
      moved = true;
    }
  }
  return left.size === 0;
}

test("every example is valid as it stands", () => {
  for (const { id, graph } of examples) {
    const document = open(graph as Json);
    assertValid(moveNodes(new Map([...document.nodes.keys()].map((node) => [node, { x: 0, y: 0 }])))(document), id);
  }
});

test("random edits keep the graph valid, and undo is the inverse of do", () => {
  for (let seed = 1; seed <= 24; seed++) {
    const random = randomFrom(seed);
    const start = seed % 2 === 0 ? (examples[seed % examples.length]?.graph as Json) : emptyDocument().json;
    let document = open(start);
    document = moveNodes(new Map([...document.nodes.keys()].map((id, at) => [id, { x: 200 * at, y: 0 }])))(document);
    const history = new History<GraphDocument>();
    const trail = [document];
    for (let step = 0; step < 60; step++) {
      const before = JSON.stringify(document.json);
      const next = randomEdit(random, document)(document);
      assert.equal(JSON.stringify(document.json), before, "an edit leaves the document it was given as it was");
      if (next === document) continue;
      history.record(document, `step ${step}`);
      document = next;
      trail.push(document);
      assertValid(document, `seed ${seed}, step ${step}`);
    }
    const end = document;
    for (let at = trail.length - 2; at >= 0; at--) {
      document = history.undo(document) ?? end;
      assert.equal(document, trail[at]);
    }
    assert.equal(history.undo(document), undefined);
    for (let at = 1; at < trail.length; at++) document = history.redo(document) ?? end;
    assert.equal(document, end);
  }
});

test("edits of one gesture are one step, and an undone future ends with the next edit", () => {
  const history = new History<number>();
  for (let at = 0; at < 5; at++) history.record(at, "drag", "a");
  history.record(5, "drag", "b");
  history.endGesture();
  history.record(6, "drag", "b");
  assert.equal(history.undo(7), 6);
  assert.equal(history.undo(6), 5);
  assert.equal(history.undo(5), 0);
  assert.equal(history.redoLabel, "drag");
  history.record(0, "other");
  assert.equal(history.redo(1), undefined);
});

test("unknown keys of a document and of its ui are kept", () => {
  const document = open({
    $schema: "/schema/graph-1.json",
    format: 1,
    meta: { author: "x" },
    nodes: { a: { type: "circle", inputs: {} } },
    ui: { zoom: 2, nodes: { a: { x: 1, y: 2, tint: "red" } } },
  });
  const changed = moveNodes(new Map([["a", { x: 5, y: 6 }]]))(setInput("a", "radius", 2)(document));
  assert.deepEqual(changed.json["ui"], { zoom: 2, nodes: { a: { x: 5, y: 6, tint: "red" } } });
  assert.deepEqual(changed.json["meta"], { author: "x" });
  assert.equal(changed.json["$schema"], "/schema/graph-1.json");
});

test("only what an edit touches is a new object", () => {
  const document = open(examples[0]?.graph as Json);
  const view = viewGraph(document, catalogue);
  const id = view.nodes[0]?.id ?? "";
  const changed = setInput(id, "radius", 0.123)(document);
  const after = viewGraph(changed, catalogue, view);
  assert.equal(after.wires, view.wires);
  assert.deepEqual(
    after.nodes.map((node, at) => node === view.nodes[at]),
    view.nodes.map((node) => node.id !== id),
  );
  assert.equal(changed.positions, document.positions);
});

test("a node that takes one wire only keeps the first of several", () => {
  const two = { model: [{ from: "a" }, { from: "b" }] };
  const nodes = { a: { type: "sphere_mesh" }, b: { type: "box_mesh" }, out: { type: "export", inputs: two } };
  const changed = replaceNode(catalogue, "out", "printability")(open({ format: 1, nodes }));
  assert.deepEqual(changed.nodes.get("out")?.inputs.get("model"), [{ kind: "link", node: "a" }]);
});
