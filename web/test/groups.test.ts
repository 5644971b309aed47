// Groups: what is put into one and taken apart again is the graph it was, and inside a group everything is edited as in a
// document.

import assert from "node:assert/strict";
import { test } from "node:test";
import { copyText, paste, readClip } from "../src/model/clip";
import { type GraphDocument, lookedAt, readDocument, rewritten } from "../src/model/document";
import { addNodes, removeNodes, renameNode, setInput } from "../src/model/edit";
import { changeParameter, expose } from "../src/model/edit_parameters";
import { replaceNode } from "../src/model/edit_replace";
import { removeAndHeal } from "../src/model/edit_wires";
import { viewGraph } from "../src/model/graph";
import { withGroups } from "../src/model/group_cards";
import { broughtGroups, groupFile, outerGroups, wouldHoldItself } from "../src/model/group_files";
import { toggleOutputs } from "../src/model/groups";
import { asArray, asObject, type Json, type JsonObject } from "../src/model/json";
import { makeGroup, ungroup } from "../src/model/make_group";
import { randomFrom } from "./random";
import { catalogue, examples } from "./real";

function open(json: Json): GraphDocument {
  const result = readDocument(json);
  if ("error" in result) throw new Error(result.error);
  return result.document;
}

/** What a graph means: its nodes with what is given to them, and its wires with the outputs that they begin at. */
function meaning(document: GraphDocument): unknown {
  const view = viewGraph(document, withGroups(catalogue, document));
  const literals = view.nodes.map(({ id, type, bypass, rows }) => ({
    ...{ id, type, bypass },
    rows: rows.map(({ name, value, parameterName }) => ({ name, value, parameterName })),
  }));
  return {
    nodes: literals.sort((a, b) => (a.id < b.id ? -1 : 1)),
    wires: view.wires
      .map(({ from, output, to, input, index, type }) => [from, output, to, input, index, type].join(" "))
      .sort(),
  };
}

const petal = {
  format: 2,
  parameters: { reach: { type: "number", default: 1 } },
  groups: {
    petal: {
      inputs: [{ name: "generator" }, { name: "reach", default: 2, label: "Reach" }],
      outputs: [{ name: "shape", from: "boosted" }],
      nodes: {
        ring: { type: "circle", inputs: { radius: { input: "reach" } } },
        boosted: { type: "boost", inputs: { shape: { from: "ring" }, generator: { input: "generator" } } },
      },
    },
  },
  nodes: {
    tau: { type: "point_pair" },
    low: { type: "group/petal", inputs: { generator: { from: "tau" }, reach: { parameter: "reach" } } },
    high: { type: "group/petal", inputs: { generator: { from: "tau" } } },
    skin: { type: "tube", inputs: { shape: { from: "low" } } },
  },
};

test("nodes that are grouped and taken apart again are the graph that they were", () => {
  const random = randomFrom(3);
  for (const { graph } of examples) {
    const document = open(graph as Json);
    for (let round = 0; round < 4; round++) {
      const chosen = new Set([...document.nodes.keys()].filter(() => random(3) === 0));
      if (chosen.size === 0) continue;
      const { edit, id } = makeGroup(document, catalogue, chosen);
      const grouped = edit(document);
      assert.equal(grouped.nodes.size, document.nodes.size - chosen.size + 1);
      const cards = withGroups(catalogue, grouped);
      const back = ungroup(grouped, cards, id).edit(grouped);
      assert.deepEqual(meaning(back), meaning(document));
      assert.deepEqual(Object.keys(asObject(back.json["groups"])), []);
    }
  }
});

test("an instance has the sockets, types and defaults of what its group is made of", () => {
  const document = open(petal as Json);
  const view = viewGraph(document, withGroups(catalogue, document));
  const high = view.byId.get("high");
  assert.equal(high?.known, true);
  assert.deepEqual(
    high?.rows
      .map(({ name, required, value }) => [name, required, value])
      .at(0)
      ?.slice(0, 2),
    ["generator", true],
  );
  assert.equal(high?.rows.find(({ name }) => name === "reach")?.literal, 2);
  assert.equal(high?.outputs[0]?.type, "circle");
  assert.equal(view.wires.find(({ to }) => to === "skin")?.type, "circle");
  assert.equal(view.wires.find(({ to }) => to === "high")?.type, "generator");
});

test("inside a group its nodes are the document and its inputs the parameters, and the rest stays as it is", () => {
  const whole = open(petal as Json);
  const inside = lookedAt(whole, [{ id: "low", group: "petal" }]);
  assert.deepEqual([...inside.nodes.keys()], ["ring", "boosted"]);
  assert.deepEqual(
    inside.parameters.map(({ name, isWireOnly }) => [name, isWireOnly]),
    [
      ["generator", true],
      ["reach", false],
    ],
  );
  assert.deepEqual(rewritten(inside, { nodes: asObject(inside.scope["nodes"]) }).json, whole.json);
  const moved = setInput("ring", "center", [1, 0, 0])(inside);
  assert.deepEqual(
    asObject(asObject(asObject(asObject(asObject(moved.json["groups"])["petal"])["nodes"])["ring"])["inputs"]),
    {
      radius: { input: "reach" },
      center: [1, 0, 0],
    },
  );
  assert.equal(moved.json["nodes"], whole.json["nodes"]);
  assert.equal(moved.nodes.get("boosted"), inside.nodes.get("boosted"));
  const renamed = renameNode("ring", "hoop")(changeParameter("reach", { default: 3, label: "Radius" })(moved));
  const group = asObject(asObject(renamed.json["groups"])["petal"]);
  assert.deepEqual(asArray(group["inputs"])[1], { name: "reach", default: 3, label: "Radius" });
  assert.deepEqual(asObject(asObject(group["nodes"])["boosted"])["inputs"], {
    shape: { from: "hoop" },
    generator: { input: "generator" },
  });
  const card = catalogue.nodes.get("boost")?.inputs.find(({ name }) => name === "amount");
  assert.ok(card);
  const exposed = expose("boosted", card, 0.5)(inside);
  const boosted = asObject(asObject(asObject(asObject(exposed.json["groups"])["petal"])["nodes"])["boosted"]);
  assert.deepEqual(asObject(boosted["inputs"])["amount"], { input: "amount" });
  assert.equal(exposed.json["parameters"], whole.json["parameters"]);
});

test("an instance of a group cannot be put into that group", () => {
  const inside = lookedAt(open(petal as Json), [{ id: "low", group: "petal" }]);
  assert.equal(withGroups(catalogue, inside).nodes.has("group/petal"), false);
  assert.equal(withGroups(catalogue, lookedAt(inside, [])).nodes.has("group/petal"), true);
});

test("copied instances bring their groups, under another name where theirs means something else", () => {
  const document = open(petal as Json);
  const clip = readClip(copyText(document, new Set(["low", "tau"])) ?? "");
  assert.ok(clip);
  const empty = open({ format: 1, nodes: {} });
  const pasted = paste(empty, clip, { x: 0, y: 0 }, false).edit(empty);
  assert.equal(pasted.json["format"], 2);
  assert.deepEqual(pasted.json["groups"], document.json["groups"]);
  const again = paste(document, clip, { x: 0, y: 0 }, false).edit(document);
  assert.deepEqual(Object.keys(asObject(again.json["groups"])), ["petal"]);
  const other = removeNodes(["ring"])(lookedAt(document, [{ id: "low", group: "petal" }]));
  const renamed = paste(lookedAt(other, []), clip, { x: 0, y: 0 }, false).edit(lookedAt(other, []));
  assert.deepEqual(Object.keys(asObject(renamed.json["groups"])), ["petal", "petal_2"]);
  assert.equal(renamed.nodes.get("low_2")?.type, "group/petal_2");
});

test("the file of a group has what it needs and nothing else", () => {
  const outer = makeGroup(open(petal as Json), withGroups(catalogue, open(petal as Json)), new Set(["low", "tau"]));
  const document = outer.edit(open(petal as Json));
  const file = groupFile(document, outer.name);
  assert.deepEqual(Object.keys(asObject(file["groups"])).sort(), ["group", "petal"]);
  assert.deepEqual(outerGroups(asObject(file["groups"])), ["group"]);
  const empty = open({ format: 1, nodes: {} });
  const { edit, typeOf } = broughtGroups(empty, asObject(file["groups"]));
  const taken = addNodes([{ id: "g", type: typeOf("group/group"), position: { x: 0, y: 0 } }])(edit(empty));
  assert.equal(viewGraph(taken, withGroups(catalogue, taken)).byId.get("g")?.known, true);
});

test("outputs of nodes become outputs of the group and go again", () => {
  const inside = lookedAt(open(petal as Json), [{ id: "low", group: "petal" }]);
  const names = (document: GraphDocument): Json[] =>
    asArray(asObject(asObject(document.json["groups"])["petal"])["outputs"]).map((output) => asObject(output)["name"]);
  const more = toggleOutputs(catalogue, new Set(["ring"]))(inside);
  assert.deepEqual(names(more), ["shape", "circle"]);
  assert.deepEqual(names(toggleOutputs(catalogue, new Set(["ring"]))(more)), ["shape"]);
});

const petalAround = [{ id: "low", group: "petal" }];

/** What the outputs of a group come from. */
function leaving(document: GraphDocument, group: string): Json[] {
  return asArray(asObject(asObject(document.json["groups"])[group])["outputs"]).map(
    (output) => asObject(output)["from"],
  );
}

test("what a group gives away follows its nodes when they are renamed, replaced, grouped, healed and removed", () => {
  const inside = lookedAt(open(petal as Json), petalAround);
  assert.deepEqual(leaving(renameNode("boosted", "bent")(inside), "petal"), ["bent"]);
  assert.deepEqual(leaving(removeNodes(["boosted"])(inside), "petal"), []);
  assert.deepEqual(leaving(removeAndHeal(catalogue, ["boosted"])(inside), "petal"), ["ring.circle"]);
  assert.deepEqual(leaving(replaceNode(catalogue, "boosted", "sphere")(inside), "petal"), ["boosted"]);
  const made = makeGroup(inside, withGroups(catalogue, inside), new Set(["boosted"]));
  const grouped = made.edit(inside);
  assert.deepEqual(leaving(grouped, "petal"), [`${made.id}.shape`]);
  assert.deepEqual(leaving(grouped, made.name), ["boosted"]);
  const back = ungroup(grouped, withGroups(catalogue, grouped), made.id).edit(grouped);
  assert.deepEqual(leaving(back, "petal"), ["boosted"]);
});

test("axes that are called after nodes in groups keep their meaning through grouping and taking apart", () => {
  const text = {
    format: 2,
    groups: {
      turns: {
        inputs: [{ name: "to", default: 1 }, { name: "over" }],
        outputs: [{ name: "value", from: "k" }],
        nodes: {
          k: { type: "range", inputs: { to: { input: "to" } } },
          skin: { type: "tube", inputs: { over: { input: "over" } } },
        },
      },
    },
    nodes: {
      k: { type: "range" },
      turns: { type: "group/turns", inputs: { over: "k" } },
      tube: { type: "tube", inputs: { over: "turns/k" } },
    },
  };
  const document = open(text as Json);
  const over = (changed: GraphDocument, id: string): Json =>
    asObject(asObject(asObject(changed.scope["nodes"])[id])["inputs"])["over"];
  const { edit, id } = makeGroup(document, withGroups(catalogue, document), new Set(["turns"]));
  const grouped = edit(document);
  assert.equal(over(grouped, "tube"), `${id}/turns/k`);
  const once = ungroup(grouped, withGroups(catalogue, grouped), id).edit(grouped);
  assert.equal(over(once, "tube"), "turns/k");
  const flat = ungroup(once, withGroups(catalogue, once), "turns").edit(once);
  assert.equal(flat.nodes.get("k_2")?.type, "range", "the group's node has another name here");
  assert.equal(over(flat, "tube"), "k_2");
  assert.equal(over(flat, "skin"), "k", "what the instance was given is called after a node around it");
});

test("one wire into a group is one input, however its output is named", () => {
  const document = open({
    format: 1,
    nodes: {
      ring: { type: "circle" },
      a: { type: "tube", inputs: { shape: { from: "ring" } } },
      b: { type: "tube", inputs: { shape: { from: "ring.circle" } } },
    },
  } as Json);
  assert.equal(makeGroup(document, catalogue, new Set(["a", "b"])).inputs, 1);
});

test("places, flags and frames of nodes go into a group with them and come out again", () => {
  const document = open({
    format: 1,
    nodes: { ring: { type: "circle" }, skin: { type: "tube", inputs: { shape: { from: "ring" } } } },
    ui: {
      nodes: { ring: { x: 10, y: 20, collapsed: true, tint: 3 }, skin: { x: 400, y: 20, preview: true } },
      frames: [{ id: "frame1", title: "Both", color: "green", x: 0, y: 0, width: 700, height: 300, nodes: ["ring"] }],
    },
  } as Json);
  const { edit, id } = makeGroup(document, catalogue, new Set(["ring", "skin"]));
  const grouped = edit(document);
  assert.equal(grouped.frames.length, 0, "no empty frame stays behind");
  assert.equal(lookedAt(grouped, [{ id, group: "group" }]).frames.length, 1);
  const back = ungroup(grouped, withGroups(catalogue, grouped), id).edit(grouped);
  assert.deepEqual(asObject(back.json["ui"])["nodes"], asObject(document.json["ui"])["nodes"]);
  assert.deepEqual(back.frames, document.frames);
});

test("a group that holds another one of the same name comes under a free name, although its own text is the same", () => {
  const outer = { inputs: [], outputs: [], nodes: { inner: { type: "group/inner" } } };
  const inner = (type: string): Json => ({ inputs: [], outputs: [], nodes: { a: { type } } });
  const here = open({ format: 2, groups: { outer, inner: inner("circle") }, nodes: {} } as Json);
  const { edit, typeOf } = broughtGroups(here, { outer, inner: inner("sphere") } as JsonObject);
  assert.equal(typeOf("group/outer"), "group/outer_2");
  const groups = asObject(edit(here).json["groups"]);
  const held = asObject(asObject(asObject(groups["outer_2"])["nodes"])["inner"])["type"];
  assert.equal(held, "group/inner_2");
  assert.deepEqual(asObject(groups["inner_2"]), inner("sphere"));
});

test("a group knows that it would hold itself, at once or through another one", () => {
  const document = open(petal as Json);
  const { edit, name } = makeGroup(document, withGroups(catalogue, document), new Set(["low"]));
  const inside = lookedAt(edit(document), petalAround);
  assert.equal(wouldHoldItself(inside, ["circle", "group/petal"]), true);
  assert.equal(wouldHoldItself(inside, [`group/${name}`]), true);
  assert.equal(wouldHoldItself(lookedAt(inside, []), [`group/${name}`]), false);
});
