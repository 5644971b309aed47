import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { allIn, decodeInWorker } from "./draco_in_node";
import { isGlb, joinGlb, splitGlb } from "../src/view3d/glb";
import { readGltf } from "../src/view3d/gltf";

// Made by: dini eval web/test/data/sample.json -o web/test/data/sample.glb
const sample = new Uint8Array(readFileSync("test/data/sample.glb"));

/** The sample with its description changed. */
function changed(change: (json: any) => void): Uint8Array<ArrayBuffer> {
  const { json, binary } = splitGlb(sample);
  const copy = structuredClone(json);
  change(copy);
  return joinGlb({ json: copy, binary });
}

test("a file of the real program is read: a surface, a line and points below the root that turns them up", () => {
  assert.ok(isGlb(sample));
  const file = readGltf(sample);
  const [root] = file.roots;
  assert.ok(root && Math.abs(root.rotation[0] + Math.SQRT1_2) < 1e-12);
  assert.equal(typeof file.extras["engine"], "string");
  const primitives = allIn(file.roots);
  assert.deepEqual(
    primitives.map((primitive) => primitive.mode),
    ["triangles", "line-strip", "points"],
  );
  const [surface, line, points] = primitives;
  assert.deepEqual(surface?.draco?.attributes.map(({ name }) => name).sort(), [
    "COLOR_0",
    "NORMAL",
    "POSITION",
    "TEXCOORD_0",
  ]);
  assert.equal(points?.attributes.get("POSITION")?.array.length, 3 * 7);
  const circle = line?.attributes.get("POSITION")?.array ?? [];
  assert.ok(circle.length > 30);
  for (let at = 0; at < circle.length; at += 3) {
    assert.ok(Math.abs(Math.hypot(circle[at] ?? 0, circle[at + 1] ?? 0) - 1) < 1e-6, "points of the unit circle");
  }
});

test("the worker decodes every attribute of the surface", async () => {
  const [surface] = allIn(readGltf(sample).roots);
  assert.ok(surface?.draco);
  const answer = await decodeInWorker([surface.draco]);
  assert.ok("parts" in answer, "error" in answer ? answer.error : "");
  const part = answer.parts[0];
  assert.ok(part);
  const lengths = Object.fromEntries(part.attributes.map(({ name, array, size }) => [name, array.length / size]));
  const vertices = lengths["POSITION"] ?? 0;
  assert.ok(vertices > 12 && Object.values(lengths).every((length) => length === vertices), JSON.stringify(lengths));
  assert.ok(part.indices.length > 100 && part.indices.every((at) => at < vertices));
  const colors = part.attributes.find(({ name }) => name === "COLOR_0");
  assert.ok(colors?.array instanceof Uint8Array && colors.size === 4);
  assert.ok(colors.array.every((value, at) => at % 4 < 3 || value === 255), "opaque");
});

test("broken compressed data is an error of the worker, which lives on", async () => {
  const [surface] = allIn(readGltf(sample).roots);
  assert.ok(surface?.draco);
  const { bytes, attributes } = surface.draco;
  const cut = { bytes: bytes.slice(0, bytes.length / 2), attributes };
  assert.ok("error" in (await decodeInWorker([cut])));
  assert.ok("error" in (await decodeInWorker([{ bytes: new Uint8Array(64), attributes }])));
  const unknown = { bytes, attributes: [{ name: "_GAUSS", id: 77, component: 5126 }] };
  assert.ok("error" in (await decodeInWorker([unknown])));
  assert.ok("parts" in (await decodeInWorker([surface.draco])));
});

test("every way to cut the file short is an error with a message", () => {
  for (let length = 0; length < sample.length; length += 7) {
    assert.throws(() => readGltf(sample.slice(0, length)), /GLB file/, `${length} bytes`);
  }
});

test("what is broken or unknown in the description is refused", () => {
  const wrong: [RegExp, (json: any) => void][] = [
    [/outside of its data/, (json) => (json.bufferViews[0].byteLength = 1e9)],
    [/outside of its data/, (json) => (json.bufferViews[0].byteOffset = -4)],
    [/outside of its data/, (json) => json.accessors.forEach((item: any) => (item.count = 1e8))],
    [/no entry 99 in its meshes/, (json) => (json.nodes[1].mesh = 99)],
    [/no entry 99 in its accessors/, (json) => (json.meshes[1].primitives[0].attributes.POSITION = 99)],
    [/not a tree/, (json) => (json.nodes[1].children = [0])],
    [/extension/, (json) => json.extensionsRequired.push("KHR_texture_basisu")],
    [/mode 6/, (json) => (json.meshes[0].primitives[0].mode = 6)],
    [/unknown kind/, (json) => json.accessors.forEach((item: any) => (item.type = "MAT9"))],
    [/no positions/, (json) => (json.meshes[1].primitives[0].attributes = {})],
    [/matrix/, (json) => (json.nodes[0].matrix = [1])],
    [/sparse/, (json) => json.accessors.forEach((item: any) => (item.sparse = {}))],
  ];
  for (const [message, change] of wrong) assert.throws(() => readGltf(changed(change)), message);
  assert.throws(() => readGltf(changed((json) => (json.scenes = 5)) && new Uint8Array(40)), /no GLB/);
  assert.doesNotThrow(() => readGltf(changed(() => undefined)));
});

test("random damage never does anything but throw a message", () => {
  let state = 7;
  const random = (below: number): number => (state = (state * 48271) % 2147483647) % below;
  for (let round = 0; round < 400; round++) {
    const bytes = sample.slice();
    for (let hit = 0; hit <= random(6); hit++) bytes[random(bytes.length)] = random(256);
    try {
      readGltf(bytes);
    } catch (error) {
      assert.ok(error instanceof Error && /[.]$/.test(error.message), String(error));
    }
  }
});
