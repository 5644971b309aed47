import assert from "node:assert/strict";
import { test } from "node:test";
import { withAnimation } from "../src/model/animated_glb";
import { joinGlb, splitGlb } from "../src/model/glb";
import { asArray, asObject, type JsonObject } from "../src/model/json";
import { readParameter } from "../src/model/parameters";
import { isPlayable, roundOf, stepValues } from "../src/model/steps";
import { checksum, zipOf } from "../src/model/zip";

test("steps go evenly from one end of a range to the other; those of an integer are whole and never repeated", () => {
  const reach = readParameter("reach", { type: "number", default: 1, min: -1, max: 3 });
  assert.deepEqual(stepValues(reach, 5), [-1, 0, 1, 2, 3]);
  assert.equal(stepValues(reach, 1000).length, 240);
  const count = readParameter("count", { type: "integer", default: 2, min: 2, max: 5 });
  assert.deepEqual(stepValues(count, 48), [2, 3, 4, 5]);
  assert.ok(isPlayable(reach) && isPlayable(count));
  assert.ok(!isPlayable(readParameter("free", { type: "number", default: 1 })));
  assert.ok(!isPlayable(readParameter("on", { type: "boolean", default: true })));
});

test("no step leaves the range, and an integer is not played where its range holds one whole number", () => {
  const narrow = readParameter("narrow", { type: "number", default: 0.5, min: 0.1234567, max: 0.9999999 });
  for (const value of stepValues(narrow, 7)) assert.ok(value >= 0.1234567 && value <= 0.9999999, String(value));
  const odd = readParameter("odd", { type: "integer", default: 1, min: 0.5, max: 2.6 });
  assert.deepEqual(stepValues(odd, 9), [1, 2]);
  assert.ok(isPlayable(odd));
  assert.ok(!isPlayable(readParameter("one", { type: "integer", default: 1, min: 0.5, max: 1.4 })));
});

test("a round shows the ends once, there and back", () => {
  assert.deepEqual(roundOf(4, "loop"), [0, 1, 2, 3]);
  assert.deepEqual(roundOf(4, "swing"), [0, 1, 2, 3, 2, 1]);
  assert.deepEqual(roundOf(2, "swing"), [0, 1]);
});

/** A file of three variants below a root, as the server makes it. */
function variants(): Uint8Array<ArrayBuffer> {
  const nodes = [0, 1, 2].map((index) => ({ name: `reach=${index}`, extras: { index } }));
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [3] }],
    nodes: [...nodes, { name: "root", children: [0, 1, 2] }],
    accessors: [],
    bufferViews: [{ buffer: 0, byteOffset: 0, byteLength: 5 }],
    buffers: [{ byteLength: 5 }],
  };
  return joinGlb({ json: json as JsonObject, binary: new Uint8Array([1, 2, 3, 4, 5]) });
}

/** Which variants are shown at a time, as a player of the animation sees it. */
function shownAt(glb: Uint8Array<ArrayBuffer>, time: number): number[] {
  const { json, binary } = splitGlb(glb);
  const animation = asObject(asArray(json["animations"])[0]);
  const floats = (accessor: unknown): number[] => {
    const { bufferView, count, type } = asObject(asArray(json["accessors"])[Number(accessor)]);
    const { byteOffset } = asObject(asArray(json["bufferViews"])[Number(bufferView)]);
    const data = binary.slice(Number(byteOffset), Number(byteOffset) + 4 * Number(count) * (type === "VEC3" ? 3 : 1));
    return [...new Float32Array(data.buffer)];
  };
  return asArray(animation["channels"]).flatMap((channel) => {
    const { sampler, target } = asObject(channel);
    const { input, output, interpolation } = asObject(asArray(animation["samplers"])[Number(sampler)]);
    assert.equal(interpolation, "STEP");
    const times = floats(input);
    assert.deepEqual(
      times,
      [...new Set(times)].sort((a, b) => a - b),
    );
    const key = times.filter((one) => one <= time).length - 1;
    return floats(output)[3 * key] === 1 ? [Number(asObject(target)["node"])] : [];
  });
}

test("the animation of a file shows exactly one step at any time, in the order asked for", () => {
  const glb = withAnimation(variants(), [0, 1, 2, 1], 0.5);
  for (const [time, step] of [
    [0, 0],
    [0.49, 0],
    [0.5, 1],
    [1.2, 2],
    [1.75, 1],
  ] as const) {
    assert.deepEqual(shownAt(glb, time), [step], `at ${time}`);
  }
  const { json, binary } = splitGlb(glb);
  assert.deepEqual([...binary.subarray(0, 5)], [1, 2, 3, 4, 5], "what was there before stays");
  assert.equal(asObject(asArray(json["buffers"])[0])["byteLength"], binary.length);
  assert.deepEqual(
    asArray(json["nodes"]).map((node) => asObject(node)["scale"]),
    [[1, 1, 1], [0, 0, 0], [0, 0, 0], undefined],
  );
  const plain = joinGlb({ json: { asset: { version: "2.0" }, nodes: [{}] }, binary: new Uint8Array() });
  assert.throws(() => withAnimation(plain, [0], 1), /no steps/);
});

test("an archive has its files as they are, with the checksums of the format", () => {
  assert.equal(checksum(new TextEncoder().encode("123456789")), 0xcbf43926);
  const archive = zipOf([
    { name: "a.txt", bytes: new TextEncoder().encode("one") },
    { name: "b.txt", bytes: new Uint8Array() },
  ]);
  const view = new DataView(archive.buffer);
  const end = archive.length - 22;
  assert.equal(view.getUint32(end, true), 0x06054b50);
  assert.equal(view.getUint16(end + 10, true), 2);
  assert.equal(
    view.getUint32(end + 16, true) + view.getUint32(end + 12, true),
    end,
    "the directory ends where it says",
  );
  assert.equal(new TextDecoder().decode(archive.subarray(30, 38)), "a.txtone");
});
