// The page knows nodes from the catalogue alone: renaming every node changes nothing but names, and no source names one.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { readCatalogue } from "../src/model/catalogue";
import { readDocument } from "../src/model/document";
import { fileOutput, viewGraph } from "../src/model/graph";
import type { Json } from "../src/model/json";
import { cards, examples } from "./real";

const IDS =
  "number range list random expression vector point point_pair point_pair_through circle circle_through line sphere flat_point " +
  "direction rotation axis_of poles_of center_of radius_of add interpolate curvature boost twist twist_between translate rotate " +
  "scale transform loxodrome product hopf warp orbit contour sample grid surface tube patch curvature_patch sphere_mesh " +
  "torus_mesh box_mesh import subdivide merge color curvature_color measure check export";

// Ids that are also parameter types, words of CSS, SVG or the DOM, names of the page's own things (icons, settings), or
// kinds of handles in the catalogue's hints.
const ORDINARY = new Set(
  "number vector point circle line color grid range list scale rotate translate check add patch direction angle distance plane blend flow project reflect".split(
    " ",
  ),
);

function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const full = path.join(folder, entry.name);
    return entry.isDirectory() ? sources(full) : [full];
  });
}

test("no source file names a node of the catalogue", () => {
  const ids = new Set([...IDS.split(" "), ...cards.nodes.map((card) => card.id)]);
  for (const file of sources("src").filter((name) => /\.tsx?$/.test(name))) {
    const text = readFileSync(file, "utf8")
      .replace(/^\s*(\/\/|\*|\/\*).*$/gm, "")
      .replace(/^(import|export)\b.*$/gm, "");
    for (const [, , literal = ""] of text.matchAll(/(["'`])([a-z_]+)\1/g)) {
      assert.ok(!ids.has(literal) || ORDINARY.has(literal), `${file} names the node "${literal}"`);
    }
    for (const id of ids) {
      if (id.includes("_")) assert.ok(!new RegExp(`\\b${id}\\b`).test(text), `${file} names the node "${id}"`);
    }
  }
});

test("renaming every node type changes nothing but the names", () => {
  const rename = (id: string): string => `renamed-${id}`;
  const renamed = { ...cards, nodes: cards.nodes.map((card) => ({ ...card, id: rename(card.id) })) };
  for (const example of examples) {
    const nodes = Object.fromEntries(
      Object.entries(example.graph.nodes as Record<string, { type: string }>).map(([id, node]) => [
        id,
        { ...node, type: rename(node.type) },
      ]),
    );
    const [before, after] = [
      { graph: example.graph as Json, catalogue: readCatalogue(cards as Json) },
      { graph: { ...example.graph, nodes } as Json, catalogue: readCatalogue(renamed as Json) },
    ].map(({ graph, catalogue }) => {
      const result = readDocument(graph);
      if ("error" in result) throw new Error(result.error);
      const view = viewGraph(result.document, catalogue);
      return {
        wires: view.wires,
        nodes: view.nodes.map((node) => ({ ...node, type: "" })),
        output: fileOutput(result.document, catalogue),
      };
    });
    assert.deepEqual(after, before);
  }
});
