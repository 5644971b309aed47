import assert from "node:assert/strict";
import { test } from "node:test";
import { readCatalogue } from "../src/model/catalogue";
import { catalogue } from "./real";

test("the catalogue lists the formats that models are written in, the usual one first", () => {
  assert.equal(catalogue.formats[0]?.name, "glb");
  assert.deepEqual(
    catalogue.formats.map(({ extension }) => extension),
    [".glb", ".gltf", ".obj", ".stl", ".ply", ".3mf", ".svg"],
  );
  for (const format of catalogue.formats) {
    assert.match(format.mediaType, /^(model|image)\//);
    assert.match(format.description, /\.$/);
  }
});

test("a server that tells no formats has none to choose from", () => {
  assert.deepEqual(readCatalogue({ nodes: [] }).formats, []);
});
