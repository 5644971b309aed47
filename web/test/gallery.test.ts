import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";

// The tests run bundled in the folder web/, where the gallery's own paths are not found.
const root = path.resolve("..");
const { galleryText, readExamples } = (await import(path.resolve("gallery/gallery.mjs"))) as Gallery;

interface Gallery {
  readExamples(): { id: string }[];
  galleryText(examples: { id: string }[]): string;
}

test("every example has a picture of the right size; scripts/render-examples makes it", () => {
  const examples = readExamples();
  assert.ok(examples.length > 0);
  for (const { id } of examples) {
    const png = readFileSync(path.join(root, "docs/images/examples", `${id}.png`));
    assert.equal(png.toString("latin1", 1, 4), "PNG", id);
    assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [960, 600], id);
    assert.ok(png.length <= 200_000, `${id}: ${png.length} bytes`);
  }
});

test("docs/gallery.md says of every example what the example says; scripts/render-examples writes it", () => {
  assert.equal(readFileSync(path.join(root, "docs/gallery.md"), "utf8"), galleryText(readExamples()));
});
