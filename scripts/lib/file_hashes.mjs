// Holds the files that the program writes against tests/data/file_hashes/<engine version>.json, or writes that table.
//
//   node scripts/lib/file_hashes.mjs check PROGRAM     fails when a file has other bytes than its version promises, with as many
//                                                     threads as there are, with one and with three, with the best processor
//                                                     instructions and without any
//   node scripts/lib/file_hashes.mjs drafts PROGRAM    fails when a draft has, once; for programs with sanitizers, which are slow
//   node scripts/lib/file_hashes.mjs write PROGRAM     writes the table; never changes what it promises already
//
// An entity tag says which engine version made a file, so a client that has the tag is told that its bytes are current:
// one version must never give two. An entry holds the hash of the graph, without `ui` and `meta`, and those of its final
// file and its draft, all parameters at their defaults.

import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtemp, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { cpus, tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
const folders = ["examples", "examples/nodes"];
const bothQualities = ["final", "draft"];
/** What must not change a byte: options of the command line. */
const ways = [["--threads", "1"], ["--threads", "3"], ["--instruction-set", "SCALAR"]];
const run = promisify(execFile);

const sha256 = (bytes) => createHash("sha256").update(bytes).digest("hex");

function sorted(value) {
  if (Array.isArray(value)) return value.map(sorted);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.keys(value).sort().map((key) => [key, sorted(value[key])]));
}

async function graphHash(path) {
  const { ui, meta, ...graph } = JSON.parse(await readFile(path, "utf8"));
  return sha256(JSON.stringify(sorted(graph)));
}

async function examples() {
  const names = [];
  for (const folder of folders) {
    const files = await readdir(join(root, folder));
    names.push(...files.filter((name) => name.endsWith(".json")).map((name) => `${folder}/${name}`));
  }
  return names.sort();
}

/** The hashes of one example, written by the program with some more options. */
async function entryOf(program, name, scratch, qualities, options) {
  const entry = { graph: await graphHash(join(root, name)) };
  for (const quality of qualities) {
    const file = join(scratch, `${name.replaceAll("/", "-")}.${quality}.glb`);
    await run(program, ["eval", join(root, name), "--quality", quality, "--out", file, ...options]);
    entry[quality] = sha256(await readFile(file));
    await rm(file);
  }
  return entry;
}

/** The hashes of all examples, by name; as many at once as the machine has processors. */
async function computedTable(program, qualities, options = []) {
  const names = await examples();
  const table = Object.fromEntries(names.map((name) => [name, null]));
  const scratch = await mkdtemp(join(tmpdir(), "dini-hashes-"));
  const waiting = [...names];
  const work = async () => {
    for (let name = waiting.shift(); name !== undefined; name = waiting.shift()) {
      table[name] = await entryOf(program, name, scratch, qualities, options);
    }
  };
  try {
    await Promise.all(Array.from({ length: cpus().length }, work));
  } finally {
    await rm(scratch, { recursive: true, force: true });
  }
  return table;
}

async function promisedTable(path) {
  try {
    return JSON.parse(await readFile(path, "utf8"));
  } catch (error) {
    if (error.code === "ENOENT") return null;
    throw error;
  }
}

/** How the files differ from what was promised: `broken` breaks the promise, `unlisted` only has to be written down. */
function differences(promised, computed, qualities) {
  const broken = [];
  const unlisted = [];
  for (const [name, entry] of Object.entries(computed)) {
    const known = promised[name];
    if (known === undefined) unlisted.push(`${name} is new`);
    else if (known.graph !== entry.graph) unlisted.push(`${name} is another graph`);
    else broken.push(...qualities.filter((quality) => known[quality] !== entry[quality]).map((q) => `${name}, ${q}`));
  }
  for (const name of Object.keys(promised)) {
    if (!(name in computed)) unlisted.push(`${name} is gone`);
  }
  return { broken, unlisted };
}

function brokenPromise(version, broken) {
  return `Engine ${version} gives other bytes than it promised for
  ${broken.join("\n  ")}
Either the change was not meant to change bytes, or:
  1. raise the version in CMakeLists.txt, project(dini VERSION ...);
  2. say in CHANGELOG.md, under Changed, whose bytes change and why; raise the version of the nodes concerned;
  3. run scripts/generate, which writes the table of the new version. Those of older versions stay.`;
}

/** Examples whose final file is another one when computed in another way, with that way. */
async function dependentFiles(program, computed) {
  const found = [];
  for (const way of ways) {
    const table = await computedTable(program, ["final"], way);
    for (const [name, { final }] of Object.entries(table)) {
      if (final !== computed[name].final) found.push(`${name}, ${way.join(" ")}`);
    }
  }
  return found;
}

async function main(mode, program) {
  if (!["check", "drafts", "write"].includes(mode) || program === undefined) {
    console.error("usage: node scripts/lib/file_hashes.mjs check|drafts|write PROGRAM");
    return 2;
  }
  const qualities = mode === "drafts" ? ["draft"] : bothQualities;
  const version = (await run(program, ["--version"])).stdout.trim().split(" ").at(-1);
  const path = join(root, "tests/data/file_hashes", `${version}.json`);
  const promised = await promisedTable(path);
  if (promised === null && mode !== "write") {
    console.error(`There is no tests/data/file_hashes/${version}.json: scripts/generate writes it.`);
    return 1;
  }
  const computed = await computedTable(program, qualities);
  const { broken, unlisted } = differences(promised ?? {}, computed, qualities);
  if (broken.length > 0) {
    console.error(brokenPromise(version, broken));
    return 1;
  }
  if (mode === "write") {
    await writeFile(path, `${JSON.stringify(computed, null, 2)}\n`);
  } else if (unlisted.length > 0) {
    console.error(`Not as in ${path}: ${unlisted.join(", ")}. scripts/generate writes it again.`);
    return 1;
  }
  const dependent = mode === "check" ? await dependentFiles(program, computed) : [];
  if (dependent.length > 0) {
    console.error(`The bytes depend on how they are computed:\n  ${dependent.join("\n  ")}`);
    return 1;
  }
  console.log(`${Object.keys(computed).length} examples have the bytes of engine ${version}`);
  return 0;
}

process.exitCode = await main(...process.argv.slice(2));
