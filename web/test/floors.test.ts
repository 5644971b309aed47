// The folders of src are floors: a file imports from its own folder and from those below it, never up, and never in a
// circle. The same is held for the C++ layers by tests/layers.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";

/** What each folder may import, beside itself. What stands side by side on a floor does not know of each other. */
const FLOORS: Readonly<Record<string, readonly string[]>> = {
  model: [],
  net: ["model"],
  session: ["model", "net"],
  widgets: ["model", "net", "session"],
  graph: ["model", "net", "session", "widgets"],
  panels: ["model", "net", "session", "widgets"],
  view3d: ["model", "net", "session", "widgets"],
  files: ["model", "net", "session", "widgets"],
  embed: ["model", "net", "session", "widgets", "view3d"],
  app: ["model", "net", "session", "widgets", "graph", "panels", "view3d", "files"],
};

/** The folders that may import a package; any folder may import what is not listed. */
const PACKAGES: readonly { name: RegExp; folders: readonly string[] }[] = [
  { name: /^three(\/|$)/, folders: ["view3d"] },
  { name: /^@xyflow\//, folders: ["graph"] },
  { name: /^react(-dom)?(\/|$)/, folders: ["widgets", "graph", "panels", "view3d", "files", "embed", "app"] },
];

interface Import {
  file: string;
  name: string;
}

const IMPORT = /(?:\bfrom|\bimport|\bimport\()\s*"([^"]+)"|@import "([^"]+)"/g;

function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const full = path.join(folder, entry.name);
    if (entry.isDirectory()) return sources(full);
    return /\.(tsx?|css)$/.test(entry.name) ? [full] : [];
  });
}

const files = sources("src");
const imports: Import[] = files.flatMap((file) =>
  [...readFileSync(file, "utf8").matchAll(IMPORT)].map((match) => ({ file, name: match[1] ?? match[2] ?? "" })),
);
const floorOf = (file: string): string => path.relative("src", file).split(path.sep)[0] ?? "";

/** The file that a relative import names. */
function imported({ file, name }: Import): string {
  const full = path.join(path.dirname(file), name);
  const found = [full, `${full}.ts`, `${full}.tsx`].find((one) => files.includes(one));
  assert.ok(found !== undefined, `${file} imports ${name}, which is not there`);
  return found;
}

test("every folder of src is a floor", () => {
  const folders = readdirSync("src", { withFileTypes: true }).filter((entry) => entry.isDirectory());
  assert.deepEqual(folders.map(({ name }) => name).sort(), Object.keys(FLOORS).sort());
});

test("no file imports from a floor above it, or from beside it", () => {
  const wrong = imports.filter((one) => {
    const floor = floorOf(one.file);
    // The entry points stand in no folder and put everything together.
    if (!one.name.startsWith(".") || !(floor in FLOORS)) return false;
    const target = floorOf(imported(one));
    return target !== floor && !FLOORS[floor]?.includes(target);
  });
  assert.deepEqual(wrong, []);
});

test("packages are imported where their things are drawn: model, net and session know neither React nor three", () => {
  const wrong = imports.filter(({ file, name }) =>
    PACKAGES.some((rule) => rule.name.test(name) && floorOf(file) in FLOORS && !rule.folders.includes(floorOf(file))),
  );
  assert.deepEqual(wrong, []);
});

test("no file imports itself, by whatever way round", () => {
  const next = new Map<string, string[]>();
  for (const one of imports.filter(({ name }) => name.startsWith("."))) {
    next.set(one.file, [...(next.get(one.file) ?? []), imported(one)]);
  }
  // What leads nowhere, or comes from nowhere, is in no circle.
  let left = new Set(next.keys());
  for (let before = -1; before !== left.size; ) {
    before = left.size;
    const reached = new Set([...left].flatMap((file) => next.get(file) ?? []));
    left = new Set([...left].filter((file) => reached.has(file) && next.get(file)?.some((target) => left.has(target))));
  }
  assert.deepEqual([...left], []);
});

test("the test sees imports of every form", () => {
  const text =
    'import a from "./a";\nimport "./b";\nexport { c } from "./c";\nvoid import("./d");\n@import "./e";\nimport {\n f,\n} from "./f";';
  assert.deepEqual(
    [...text.matchAll(IMPORT)].map((match) => match[1] ?? match[2]),
    ["./a", "./b", "./c", "./d", "./e", "./f"],
  );
  assert.ok(imports.length > 300, "the sources are read");
});
