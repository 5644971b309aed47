// Checks the JSON Schema of the graph document with ajv, not with code of this project: the schema itself is well, every
// example is valid by it, and of other documents the schema and the program think the same.
//   node check_schema.mjs PROGRAM EXAMPLES PAGE
// PROGRAM is dini, EXAMPLES the folder of the example graphs, PAGE docs/document.md, whose documents and tables of members
// are held against the schema. The last line is "N passed, N failed".

import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { right, wrong } from "./documents.mjs";

const { default: Ajv } = await import("ajv/dist/2020.js").catch(() => {
  console.error("The node packages are missing. Install them with: npm ci --prefix tests/cli/tools");
  process.exit(1);
});

const [program, examples, page] = process.argv.slice(2);
let passed = 0;
let failed = 0;

function check(name, holds, details) {
  if (holds) {
    passed += 1;
  } else {
    failed += 1;
    console.error(`${name}: ${details}`);
  }
}

function dini(words, input) {
  const { status, stdout, stderr } = spawnSync(program, words, { input, encoding: "utf8", maxBuffer: 1 << 26 });
  return { status, stdout, stderr };
}

const ajv = new Ajv({ strict: true, strictRequired: false, strictTypes: false, allErrors: true });
const schema = JSON.parse(dini(["nodes", "--schema"]).stdout);
const isValid = ajv.compile(schema);
const faults = () => ajv.errorsText(isValid.errors, { separator: "\n  " });

const catalogue = JSON.parse(dini(["nodes", "--json"]).stdout);
for (const { id, inputs } of catalogue.nodes) {
  const shown = schema.$defs[`node_${id}`];
  const names = Object.keys(shown?.properties.inputs.properties ?? {}).sort();
  check(`the node ${id}`, String(names) === String(inputs.map(({ name }) => name).sort()), `has the inputs ${names}`);
}

for (const folder of [examples, join(examples, "nodes")]) {
  for (const file of readdirSync(folder).filter((name) => name.endsWith(".json"))) {
    const graph = JSON.parse(readFileSync(join(folder, file), "utf8"));
    check(file, isValid({ $schema: "/schema/graph-1.json", ...graph }), faults());
  }
}

const text = readFileSync(page, "utf8");
for (const [, block] of text.matchAll(/```json\n([\s\S]*?)```/g)) right[`the document ${block}`] = JSON.parse(block);
check("the page", Object.keys(right).some((name) => name.startsWith("the document ")), "shows no document");

/** The rows of the table of members below a heading: the name, and whether it is required. */
function members(heading) {
  const section = text.split(`\n## ${heading}\n`)[1]?.split("\n## ")[0] ?? "";
  return [...section.matchAll(/^\| `([^`]+)` \| (yes|no) \|/gm)].map(([, name, required]) => `${name} ${required}`).sort();
}

function membersOf({ properties, required = [] }) {
  return Object.keys(properties).map((name) => `${name} ${required.includes(name) ? "yes" : "no"}`).sort();
}

check("the members of a document", String(members("The members")) === String(membersOf(schema)), membersOf(schema));
check("the members of a node", String(members("A node")) === String(membersOf(schema.$defs.node_circle)), "differ");
check("the members of a group", String(members("Groups")) === String(membersOf(schema.$defs.group)), "differ");
check("the members of a parameter", String(members("A parameter")) === String(membersOf(schema.$defs.parameter)), "differ");

for (const [name, graph] of Object.entries(right)) {
  const { status, stdout, stderr } = dini(["validate", "-"], JSON.stringify(graph));
  check(`${name}, by the schema`, isValid(graph), faults());
  check(`${name}, by the program`, status === 0, stdout + stderr);
}
for (const [name, graph] of Object.entries(wrong)) {
  const { status } = dini(["validate", "-"], JSON.stringify(graph));
  check(`${name}, by the schema`, !isValid(graph), "is taken");
  check(`${name}, by the program`, status === 3, `ends with ${status}`);
}

console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
