// Checks the reports of `dini test` with programs of others: SARIF by the schema of its standard, JUnit by its schema (xmllint)
// and by a reader of another project.
//   node check_reports.mjs PROGRAM
// PROGRAM is dini. The last line is "N passed, N failed".

import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const missing = () => {
  console.error("The node packages are missing. Install them with: npm ci --prefix tests/cli/tools");
  process.exit(1);
};
const { default: Ajv } = await import("ajv-draft-04").catch(missing);
const { default: addFormats } = await import("ajv-formats").catch(missing);
const { default: JunitReader } = await import("junitxml-to-javascript").catch(missing);

const here = dirname(fileURLToPath(import.meta.url));
const program = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "dini-reports-"));
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

const write = (name, value) =>
  writeFileSync(join(folder, name), typeof value === "string" ? value : JSON.stringify(value));
const ball = (radius) => ({
  format: 1,
  nodes: {
    ball: { type: "sphere_mesh", inputs: { radius, segments: 8, rings: 4 } },
    out: { type: "export", inputs: { model: { from: "ball" } } },
  },
});
write("good.json", ball(1));
write('bad <&"> ünï.json', ball(-1));
write("broken.json", '{"format": 1, "nodes": {');
write("cases.json", {
  ...ball({ parameter: "radius" }),
  parameters: { radius: { type: "number", default: 1, min: 0.1, max: 9 } },
});
write("cases.cases.json", {
  cases: {
    small: {},
    large: { parameters: { radius: 2 } },
    wrong: { parameters: { radius: 0 }, fails: "out-of-range" },
    odd: { fails: "degenerate" },
  },
});
write("warns.json", {
  format: 1,
  nodes: { ...ball(1).nodes, loose: { type: "circle", inputs: { radius: -1 } } },
});

const schema = JSON.parse(
  readFileSync(join(here, "node_modules/@microsoft/jest-sarif/lib/schemas/sarif-2.1.0-rtm.5.json"), "utf8"),
);
const ajv = new Ajv({ strict: false, allErrors: true, unicodeRegExp: false });
addFormats(ajv);
const isSarif = ajv.compile(schema);

async function run(name, words, expected) {
  const { status, stderr } = spawnSync(
    program,
    ["test", folder, "--junit", join(folder, "j.xml"), "--sarif", join(folder, "s.json"), ...words],
    { encoding: "utf8" },
  );
  check(`${name}: exit code`, status === expected.code, `${status}, ${stderr}`);

  const log = JSON.parse(readFileSync(join(folder, "s.json"), "utf8"));
  check(`${name}: SARIF`, isSarif(log), ajv.errorsText(isSarif.errors, { separator: "\n  " }));
  const results = log.runs[0].results;
  const errors = results.filter(({ level }) => level === "error");
  check(`${name}: errors in SARIF`, errors.length === expected.problems, errors.length);
  for (const { ruleId, ruleIndex } of results) {
    check(`${name}: rule ${ruleId}`, log.runs[0].tool.driver.rules[ruleIndex].id === ruleId, ruleIndex);
  }

  const lint = spawnSync("xmllint", ["--noout", "--schema", join(here, "junit.xsd"), join(folder, "j.xml")], {
    encoding: "utf8",
  });
  check(`${name}: JUnit`, lint.status === 0, lint.error ?? lint.stderr);
  const read = await new JunitReader().parseXMLFile(join(folder, "j.xml"));
  const cases = read.testsuites.flatMap(({ testCases }) => testCases);
  const count = (result) => cases.filter((each) => each.result === result).length;
  check(`${name}: cases in JUnit`, cases.length === expected.cases, cases.length);
  check(`${name}: passed in JUnit`, count("succeeded") === expected.passed, JSON.stringify(cases));
  for (const { name: suite, tests, testCases, timestamp, properties } of read.testsuites) {
    check(`${name}: number of cases in the suite ${suite}`, tests === testCases.length, tests);
    check(`${name}: the time of the suite ${suite}`, Math.abs(Date.now() - timestamp) < 86_400_000, timestamp);
    check(`${name}: the engine of the suite ${suite}`, properties[0].name === "engine", JSON.stringify(properties));
  }
  const xml = readFileSync(join(folder, "j.xml"), "utf8");
  const ids = [...xml.matchAll(/<testsuite [^>]* id="(\d+)"/g)].map(([, id]) => Number(id));
  check(`${name}: suites are numbered from 0`, ids.every((id, index) => id === index), ids);
  return { log, read };
}

try {
  const { log } = await run("a folder with faults", [], { code: 3, problems: 3, cases: 8, passed: 5 });
  const levels = log.runs[0].results.map(({ level }) => level);
  const xml = readFileSync(join(folder, "j.xml"), "utf8");
  check("warnings in JUnit", /<system-err>[^<]*warns.json:\d+:\d+: warning: /.test(xml), xml);
  check("warnings in SARIF", levels.includes("warning"), levels);
  const [location] = log.runs[0].results.find(({ ruleId }) => ruleId === "not-json").locations;
  check("the place in SARIF", location.physicalLocation.region.startColumn === 25, JSON.stringify(location));
  for (const name of ['bad <&"> ünï.json', "broken.json", "cases.cases.json"]) rmSync(join(folder, name));
  await run("a folder that is well", [], { code: 0, problems: 0, cases: 3, passed: 3 });
  mkdirSync(join(folder, "golden"));
  await run("golden results that are missing", [], { code: 1, problems: 3, cases: 3, passed: 0 });
  await run("after the first failure", ["--fail-fast", "--jobs", "1"], { code: 1, problems: 1, cases: 3, passed: 0 });
} finally {
  rmSync(folder, { recursive: true });
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
