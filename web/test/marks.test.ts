// Colors and labels of nodes, and frames that show their heads only.

import assert from "node:assert/strict";
import { test } from "node:test";
import { copyText, paste, readClip } from "../src/model/clip";
import { type GraphDocument, readDocument } from "../src/model/document";
import { changeFrame, collectMembers, nameNode, setMark } from "../src/model/edit_ui";
import { viewGraph } from "../src/model/graph";
import { asObject } from "../src/model/json";
import { hiddenIn } from "../src/model/ui";
import { catalogue } from "./real";

function graph(): GraphDocument {
  const read = readDocument({
    format: 1,
    nodes: { ring: { type: "circle" }, skin: { type: "tube", inputs: { shape: { from: "ring" } } } },
    ui: {
      nodes: { ring: { x: 0, y: 0 }, skin: { x: 300, y: 0 } },
      frames: [{ id: "frame1", title: "All", x: -50, y: -50, width: 900, height: 400, nodes: ["ring"] }],
    },
  });
  if ("error" in read) throw new Error(read.error);
  return read.document;
}

const nodeOf = (document: GraphDocument, id: string) => viewGraph(document, catalogue).byId.get(id);

test("a text that can be an id is the id, any other one a label beside it", () => {
  const named = nameNode("ring", "hoop")(graph());
  assert.deepEqual([...named.nodes.keys()], ["hoop", "skin"]);
  const long = "The ring that everything else of this graph is made of, three times as long as an id may be";
  const labeled = nameNode("ring", long)(graph());
  assert.equal(nodeOf(labeled, "ring")?.label, long);
  assert.equal(nodeOf(labeled, "skin")?.inputs[0]?.linked, true);
  assert.equal(nodeOf(nameNode("ring", "")(labeled), "ring")?.label, "");
  const renamed = nameNode("ring", "hoop")(labeled);
  assert.equal(nodeOf(renamed, "hoop")?.label, "", "the new name says it");
  assert.equal(nodeOf(nameNode("ring", "x".repeat(5000).concat(" "))(graph()), "ring")?.label.length, 200);
});

test("colors and labels change nothing that is computed, and come along when nodes are copied", () => {
  const document = setMark(["ring"], "label", "Big ring")(setMark(["ring", "none"], "color", "green")(graph()));
  assert.deepEqual(document.json["nodes"], graph().json["nodes"]);
  assert.deepEqual(asObject(asObject(document.json["ui"])["nodes"])["none"], undefined);
  const clip = readClip(copyText(document, new Set(["ring"])) ?? "");
  assert.ok(clip);
  const pasted = paste(document, clip, { x: 10, y: 10 }, false).edit(document);
  const copy = nodeOf(pasted, "ring_2");
  assert.deepEqual([copy?.color, copy?.label], ["green", "Big ring"]);
  assert.deepEqual(pasted.positions.get("ring_2"), { x: 10, y: 10 });
  assert.equal(nodeOf(setMark(["ring"], "color", "")(document), "ring")?.color, "");
});

test("a collapsed frame hides its nodes and takes none that is put over it", () => {
  const closed = changeFrame("frame1", { collapsed: true })(graph());
  assert.deepEqual([...hiddenIn(closed.frames)], [["ring", "frame1"]]);
  const boxOf = () => ({ x: 300, y: 0, width: 100, height: 50 });
  assert.deepEqual(collectMembers(["skin"], boxOf)(closed).frames[0]?.nodes, ["ring"]);
  const open = changeFrame("frame1", { collapsed: false })(closed);
  assert.equal(hiddenIn(open.frames).size, 0);
  assert.deepEqual(collectMembers(["skin"], boxOf)(open).frames[0]?.nodes, ["ring", "skin"]);
});
