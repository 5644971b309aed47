// What the gallery says is watertight is, whatever its sliders say: as this test counts edges, and as manifold-3d, a
// library for solids of others, reads the file.
//
//   DINI_PROGRAM=build/release/dini node --test tests/cli/tools/solids.test.mjs
//
// The ends of the sliders and some settings are tried in full quality, the others as drafts; with DINI_SOLIDS=final all are
// in full quality, which takes minutes.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import ManifoldModule from "manifold-3d";

const root = new URL("../../../", import.meta.url).pathname;
const program = process.env.DINI_PROGRAM ?? join(root, "build/release/dini");
const run = promisify(execFile);
const SETTINGS = 30;
const FINAL_SETTINGS = process.env.DINI_SOLIDS === "final" ? SETTINGS : 4;

/** Examples that say they are watertight; with the Euler number where it is the same at every setting. */
const solids = [
  { name: "object_vase", euler: 2 },
  { name: "object_ring", euler: 0 },
  { name: "object_pavilion", euler: 2 },
  { name: "object_pendant" },
  { name: "lamp_shade" },
  { name: "invagination" },
  { name: "coral" },
];

let scratch;
let manifold;

before(async () => {
  scratch = await mkdtemp(join(tmpdir(), "dini-solids-"));
  manifold = await ManifoldModule();
  manifold.setup();
});

after(() => rm(scratch, { recursive: true, force: true }));

/** Numbers in [0, 1) that are the same in every run (mulberry32). */
function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** One value for each slider: all at one end first, then all at the other, then anywhere between. */
function setting(parameters, round, random) {
  const share = () => (round < 2 ? round : random());
  return Object.entries(parameters).map(([name, { type, min, max }]) => {
    const way = share();
    const value = (1 - way) * min + way * max;
    return `${name}=${type === "integer" ? Math.round(value) : value}`;
  });
}

/** The triangles of a binary STL, between places that are equal in all bits, without those that have no area left. */
function welded(bytes) {
  const places = new Map();
  const positions = [];
  const vertexAt = (offset) => {
    const place = [0, 4, 8].map((part) => bytes.readFloatLE(offset + part) + 0);
    const key = place.join();
    if (!places.has(key)) {
      places.set(key, places.size);
      positions.push(...place);
    }
    return places.get(key);
  };
  const corners = [];
  for (let offset = 84; offset < bytes.length; offset += 50) {
    const triangle = [12, 24, 36].map((corner) => vertexAt(offset + corner));
    if (new Set(triangle).size === 3) corners.push(...triangle);
  }
  return { positions, corners, vertices: places.size };
}

/** Edges that do not have one triangle on either side, and V - E + F. */
function soundness({ corners, vertices }) {
  const sides = new Set();
  let doubled = 0;
  for (let at = 0; at < corners.length; at += 3) {
    for (const side of [0, 1, 2]) {
      const key = corners[at + side] * vertices + corners[at + ((side + 1) % 3)];
      if (sides.has(key)) doubled++;
      sides.add(key);
    }
  }
  const open = [...sides].filter((key) => !sides.has((key % vertices) * vertices + Math.floor(key / vertices)));
  return { faulty: doubled + open.length, euler: vertices - corners.length / 2 + corners.length / 3 };
}

async function check({ name, euler }, values, quality) {
  const file = join(scratch, `${name}.stl`);
  const words = ["eval", join(root, "examples", `${name}.json`), "--quiet", "--quality", quality, "--out", file];
  const { stderr } = await run(program, [...words, ...values.flatMap((value) => ["--set", value])]);
  assert.equal(stderr, "", "no warnings");
  const mesh = welded(await readFile(file));
  const found = soundness(mesh);
  assert.equal(found.faulty, 0, "edges without two triangles");
  if (euler === undefined) assert.equal(Math.abs(found.euler % 2), 0);
  else assert.equal(found.euler, euler);
  const solid = new manifold.Manifold(
    new manifold.Mesh({
      numProp: 3,
      vertProperties: Float32Array.from(mesh.positions),
      triVerts: Uint32Array.from(mesh.corners),
    }),
  );
  try {
    assert.equal(solid.status(), "NoError");
    assert.ok(solid.volume() > 0, `volume ${solid.volume()}`);
  } finally {
    solid.delete();
  }
}

async function checkAll(solid) {
  const { parameters } = JSON.parse(await readFile(join(root, "examples", `${solid.name}.json`), "utf8"));
  const random = randomNumbers(15);
  for (let round = 0; round < SETTINGS; round++) {
    const values = setting(parameters, round, random);
    const quality = round < FINAL_SETTINGS ? "final" : "draft";
    await check(solid, values, quality).catch((error) => {
      throw new Error(`${quality} with ${values.join(", ")}: ${error.message}`, { cause: error });
    });
  }
}

test("the count of edges and another program find solids, whatever the sliders say", { concurrency: 2 }, (context) =>
  Promise.all(
    solids.map((solid) => context.test(`${solid.name} at ${SETTINGS} settings`, () => checkAll(solid))),
  ),
);

test("what is not closed is told from what is", async () => {
  const file = join(scratch, "open.stl");
  await run(program, ["eval", join(root, "examples/fig11_patch.json"), "--quiet", "--out", file]);
  assert.notEqual(soundness(welded(await readFile(file))).faulty, 0);
});
