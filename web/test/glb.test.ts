import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { isGlb, joinGlb, splitGlb } from "../src/model/glb";
import { randomFrom } from "./random";

// Made by: dini eval web/test/data/sample.json -o web/test/data/sample.glb
const sample = new Uint8Array(readFileSync("test/data/sample.glb"));

test("a file of the real program comes apart and together again byte for byte", () => {
  assert.ok(isGlb(sample));
  const { json, binary } = splitGlb(sample);
  assert.ok(binary.length > 1000);
  assert.ok(typeof json["asset"] === "object");
  assert.deepEqual(splitGlb(joinGlb({ json, binary })), { json, binary });
});

test("every way to cut the file short is an error with a message", () => {
  for (let length = 0; length < sample.length; length += 7) {
    assert.throws(() => splitGlb(sample.slice(0, length)), /GLB file/, `${length} bytes`);
  }
});

test("random damage never does anything but throw a message", () => {
  const random = randomFrom(7);
  for (let round = 0; round < 400; round++) {
    const bytes = sample.slice();
    for (let hit = 0; hit <= random(6); hit++) bytes[random(bytes.length)] = random(256);
    try {
      splitGlb(bytes);
    } catch (error) {
      assert.ok(error instanceof Error && /[.]$/.test(error.message), String(error));
    }
  }
});
