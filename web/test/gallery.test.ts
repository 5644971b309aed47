import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";

// The tests run bundled in the folder web/, where the gallery's own paths are not found.
const root = path.resolve("..");
const { examples, galleryText, nodeExamples, readExamples } = (await import(
  path.resolve("gallery/gallery.mjs")
)) as Gallery;

/** A folder of graphs, that of their pictures, and what these are like. */
interface Album {
  graphs: string;
  pictures: string;
  width: number;
  height: number;
  most: number;
}

interface Gallery {
  examples: Album;
  nodeExamples: Album;
  readExamples(folder?: string): { id: string }[];
  galleryText(examples: { id: string }[]): string;
}

test("every example has a picture of the right size; scripts/render-examples makes it", () => {
  for (const { graphs, pictures, width, height, most } of [examples, nodeExamples]) {
    const ids = readExamples(graphs).map(({ id }) => id);
    assert.deepEqual(readdirSync(pictures).sort(), ids.map((id) => `${id}.png`).sort());
    for (const id of ids) {
      const png = readFileSync(path.join(pictures, `${id}.png`));
      assert.equal(png.toString("latin1", 1, 4), "PNG", id);
      assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [width, height], id);
      assert.ok(png.length <= most, `${id}: ${png.length} bytes`);
    }
  }
});

test("docs/gallery.md says of every example what the example says; scripts/render-examples writes it", () => {
  assert.equal(readFileSync(path.join(root, "docs/gallery.md"), "utf8"), galleryText(readExamples()));
});
