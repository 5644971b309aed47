import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { draftNeed } from "../src/files/autosave";
import { documentText } from "../src/files/document_text";
import { type Draft, surplus } from "../src/files/drafts";
import { graphInGlb, withGraph } from "../src/files/glb_graph";
import { KeptDrafts } from "../src/files/kept_drafts";
import { packGraph, unpackGraph } from "../src/files/share";
import { readDocument } from "../src/model/document";
import { joinGlb, splitGlb } from "../src/model/glb";
import type { JsonObject } from "../src/model/json";
import { documentWithValues } from "../src/model/saved_values";
import type { Origin } from "../src/session/state";
import { randomFrom } from "./random";
import "./deflate_raw";

const examples = readdirSync("../examples")
  .filter((name) => name.endsWith(".json"))
  .map((name) => JSON.parse(readFileSync(`../examples/${name}`, "utf8")) as JsonObject);

test("every example comes out of a link as it went in, in the letters of an address", async () => {
  assert.ok(examples.length > 10);
  for (const json of examples) {
    const text = await packGraph(json);
    assert.match(text, /^[\w-]+$/);
    assert.deepEqual(await unpackGraph(text), { json });
  }
});

test("titles in any script survive", async () => {
  const json = { format: 1, meta: { title: "Fläche «κ» 曲面 🌀 </script><img src=x onerror=alert(1)>" }, nodes: {} };
  assert.deepEqual(await unpackGraph(await packGraph(json)), { json });
});

const packed = (bytes: Uint8Array | string): string => deflateRawSync(bytes).toString("base64url");

test("hostile links are refused with a sentence and never thrown", async () => {
  const bomb = packed(new Uint8Array(40_000_000));
  const hostile = [
    "",
    "%%%",
    "a b",
    "AAAA",
    "x".repeat(100_000),
    bomb,
    packed("no json"),
    packed("[1,2,3]"),
    packed("null"),
    packed('"text"'),
    packed(new Uint8Array([0xff, 0xfe, 0x80])),
    packed(`{"format":1,"nodes":${"[".repeat(500_000)}`),
    packed(JSON.stringify(examples[0])).slice(0, 300),
  ];
  for (const text of hostile) {
    const result = await unpackGraph(text);
    assert.ok("error" in result && /[.]$/.test(result.error), text.slice(0, 40));
  }
  assert.ok(bomb.length < 64_000, "the bomb is short enough to be tried");
});

test("random damage to a link never throws and never pollutes", async () => {
  const text = await packGraph(examples[0] ?? {});
  const random = randomFrom(11);
  for (let round = 0; round < 150; round++) {
    const at = random(text.length);
    const letter = "ABCxyz019-_"[random(11)] ?? "A";
    const result = await unpackGraph(text.slice(0, at) + letter + text.slice(at + 1));
    if ("json" in result) readDocument(result.json);
  }
  const evil = packed(
    '{"format":1,"nodes":{"__proto__":{"type":"x"}},"__proto__":{"polluted":true},"ui":{"nodes":{"__proto__":{"x":1,"y":2}}}}',
  );
  const result = await unpackGraph(evil);
  assert.ok("json" in result);
  readDocument(result.json);
  assert.equal(({} as Record<string, unknown>)["polluted"], undefined);
});

test("a file holds the values beside the defaults, and opens with both", () => {
  const json: JsonObject = {
    format: 1,
    parameters: { reach: { type: "number", default: 1, max: 4 }, other: { type: "number", default: 2 } },
    nodes: {},
    ui: { nodes: {}, more: 1 },
  };
  const read = readDocument(json);
  assert.ok("document" in read);
  assert.equal(documentWithValues(read.document, {}), json);
  const saved = documentWithValues(read.document, { reach: 3 });
  assert.deepEqual(saved, { ...json, ui: { nodes: {}, more: 1, values: { reach: 3 } } });
  const again = readDocument(JSON.parse(documentText(saved)));
  assert.ok("document" in again);
  assert.deepEqual(again.values, { reach: 3 });
  assert.deepEqual(again.document.json, json, "the values are no part of the graph");
  assert.deepEqual(documentWithValues(again.document, {}), json);
});

test("values that fit no parameter are left out, and equal ones too", () => {
  const read = readDocument({
    format: 1,
    parameters: {
      reach: { type: "number", default: 1 },
      turns: { type: "integer", default: 3 },
      closed: { type: "boolean", default: false },
      rule: { type: "choice", default: "a", choices: ["a", "b"] },
      axis: { type: "vector", default: [0, 0, 1] },
      paint: { type: "color", default: [1, 1, 1] },
    },
    nodes: {},
    ui: {
      values: { reach: "2", turns: 4, closed: 1, rule: "c", axis: [0, 1], paint: [0, 0, 0], gone: 7, constructor: 1 },
    },
  });
  assert.ok("document" in read);
  assert.deepEqual(read.values, { turns: 4, paint: [0, 0, 0] });
  const equal = readDocument({
    format: 1,
    parameters: { axis: { type: "vector", default: [0, 0, 1] } },
    nodes: {},
    ui: { values: { axis: [0, 0, 1] } },
  });
  assert.ok("document" in equal);
  assert.deepEqual(equal.values, {});
});

test("a model of ours tells what it knows of its graph", () => {
  const sample = new Uint8Array(readFileSync("test/data/sample.glb"));
  const content = graphInGlb(sample);
  assert.ok(content.kind === "graph" || (content.kind === "hash" && content.hash.length === 64));
  assert.throws(() => graphInGlb(sample.slice(0, 100)), /cut short/);
  for (const json of examples) {
    const stamped = withGraph(sample, json);
    assert.deepEqual(graphInGlb(stamped), { kind: "graph", json });
    assert.deepEqual(splitGlb(stamped).binary, splitGlb(sample).binary, "the model is as it was");
    assert.deepEqual(graphInGlb(withGraph(stamped, { format: 1, nodes: {} })), {
      kind: "graph",
      json: { format: 1, nodes: {} },
    });
  }
});

test("a model names its fingerprint, and called it its graph before", () => {
  const { binary } = splitGlb(new Uint8Array(readFileSync("test/data/sample.glb")));
  const model = (extras: JsonObject) => joinGlb({ json: { asset: { version: "2.0", extras } }, binary });
  const hash = "0".repeat(64);
  assert.deepEqual(graphInGlb(model({ engine: "1", fingerprint: hash })), { kind: "hash", hash });
  assert.deepEqual(graphInGlb(model({ engine: "1", graph: hash })), { kind: "hash", hash });
  assert.deepEqual(graphInGlb(model({ fingerprint: hash })), { kind: "foreign" });
});

test("only the ten newest drafts are kept", () => {
  const drafts = Array.from({ length: 13 }, (_, at): Draft => {
    return { id: String(at), tab: "", title: "", name: "", address: "", time: (at * 7) % 13, json: {} };
  });
  assert.deepEqual(
    surplus(drafts).map((draft) => draft.time),
    [2, 1, 0],
  );
});

test("drafts of sliders do not push out drafts of graphs", () => {
  const draft = (time: number, isAdjustment: boolean): Draft => {
    return { id: String(time), tab: "", title: "", name: "", address: "", time, isAdjustment, json: {} };
  };
  const graphs = Array.from({ length: 7 }, (_, at) => draft(at, false));
  const sliders = Array.from({ length: 12 }, (_, at) => draft(100 + at, true));
  const gone = surplus([...graphs, ...sliders]);
  assert.equal(gone.length, 9);
  assert.ok(gone.every((one) => one.isAdjustment && one.time < 109));
});

test("a draft is written for every difference, and goes with the last one", () => {
  const example: Origin = { kind: "example", id: "a" };
  const same = { isChanged: false, isAdjusted: false, origin: example };
  assert.equal(draftNeed(same, false), "nothing");
  assert.equal(draftNeed({ ...same, isAdjusted: true }, false), "write", "a slider is enough");
  assert.equal(draftNeed({ ...same, isChanged: true }, true), "write");
  assert.equal(draftNeed(same, true), "remove", "undone");
  assert.equal(draftNeed({ ...same, origin: { kind: "file", name: "a.json" } }, true), "remove");
  assert.equal(draftNeed({ ...same, origin: { kind: "draft", id: "d" } }, true), "write", "kept nowhere else");
});

/** A place for drafts that can be full. */
function place(): { drafts: Map<string, Draft>; error: Error | undefined; store: KeptDrafts } {
  const drafts = new Map<string, Draft>();
  const kept = { drafts, error: undefined as Error | undefined };
  const act = async (run: () => void): Promise<void> => {
    if (kept.error) throw kept.error;
    run();
  };
  const store = new KeptDrafts({
    put: (draft) => act(() => drafts.set(draft.id, draft)),
    remove: (id) => act(() => drafts.delete(id)),
    list: async () => {
      await act(() => undefined);
      return [...drafts.values()];
    },
  });
  return Object.assign(kept, { store });
}

const draftOf = (id: string, time: number): Draft => {
  return { id, tab: "", title: id, name: "", address: "", time, json: { time } };
};

test("drafts that the browser refuses are held, said, and stored as soon as it takes one", async () => {
  const full = place();
  full.error = new DOMException("", "QuotaExceededError");
  assert.equal(await full.store.put(draftOf("a", 1)), false);
  await full.store.put(draftOf("a", 2));
  await full.store.put(draftOf("b", 3));
  assert.equal(full.store.held.get().reason, "its storage is full");
  assert.equal(full.store.isTrusted, false);
  assert.deepEqual(
    (await full.store.list()).map(({ id, time }) => [id, time]),
    [
      ["b", 3],
      ["a", 2],
    ],
  );
  full.error = undefined;
  assert.equal(await full.store.put(draftOf("c", 4)), true);
  assert.deepEqual(full.store.held.get().drafts, []);
  assert.deepEqual([...full.drafts.keys()].sort(), ["a", "b", "c"]);
  assert.equal(full.store.isTrusted, true);
});

test("a draft that was removed is not held, however late the browser refuses it", async () => {
  const full = place();
  full.error = new DOMException("", "SecurityError");
  const late = full.store.put(draftOf("a", 1));
  await full.store.remove("a");
  await late;
  assert.deepEqual(full.store.held.get().drafts, []);
  await full.store.put(draftOf("b", 2));
  assert.equal(full.store.held.get().reason, "it does not allow storage");
  await full.store.remove("b");
  assert.deepEqual(full.store.held.get().drafts, []);
});

test("documents of every old version still open", () => {
  for (const name of readdirSync("test/data").filter((file) => file.startsWith("format_"))) {
    const result = readDocument(JSON.parse(readFileSync(`test/data/${name}`, "utf8")));
    assert.ok("document" in result && result.document.nodes.size > 0, name);
  }
});
