// The description of the HTTP interface as others see it: an independent validator finds nothing wrong with it, and a
// client generated from it by an independent generator evaluates an example.
// DINI_PROGRAM: the program to start, else build/release/dini.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Validator } from "@seriousme/openapi-schema-validator";
import createClient from "openapi-fetch";
import openapiTypescript, { astToString } from "openapi-typescript";
import ts from "typescript";

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, "../../..");
const program = process.env.DINI_PROGRAM ?? path.join(root, "build/release/dini");
const example = JSON.parse(readFileSync(path.join(root, "examples/fig04_boosted_ring.json"), "utf8"));

let url;
let child;
let description;

before(async () => {
  const folder = mkdtempSync(path.join(tmpdir(), "dini-interface-"));
  const portFile = path.join(folder, "port");
  child = spawn(program, ["serve", "--data", "none", "--port", "0", "--port-file", portFile, "--log-level", "warning"], {
    stdio: ["ignore", "ignore", "inherit"],
  });
  while (!existsSync(portFile) || readFileSync(portFile, "utf8").trim() === "") {
    assert.equal(child.exitCode, null, `${program} ended`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  url = `http://127.0.0.1:${readFileSync(portFile, "utf8").trim()}`;
  rmSync(folder, { recursive: true });
  description = await (await fetch(`${url}/openapi.json`)).json();
});

after(async () => {
  const gone = once(child, "exit");
  child.kill("SIGTERM");
  await gone;
});

/** What the compiler says about a program that uses the types generated from the description. */
async function complaints(source) {
  const folder = mkdtempSync(path.join(here, "node_modules/.generated-"));
  try {
    // By itself the generator takes a member with a default for one that must be given; that is meant for answers.
    const types = await openapiTypescript(description, { defaultNonNullable: false });
    writeFileSync(path.join(folder, "interface.ts"), astToString(types));
    const file = path.join(folder, "client.ts");
    writeFileSync(file, source);
    const checked = ts.createProgram([file], {
      strict: true,
      noEmit: true,
      skipLibCheck: true,
      types: [],
      target: ts.ScriptTarget.ES2022,
      module: ts.ModuleKind.ESNext,
      moduleResolution: ts.ModuleResolutionKind.Bundler,
      lib: ["lib.es2022.d.ts", "lib.dom.d.ts", "lib.dom.iterable.d.ts"],
    });
    return ts.getPreEmitDiagnostics(checked).map((one) => ts.flattenDiagnosticMessageText(one.messageText, "\n"));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const clientOf = (body) => `
  import createClient from "openapi-fetch";
  import type { paths } from "./interface";
  export async function triangles(graph: paths["/v1/evaluate"]["post"]["requestBody"]["content"]["application/json"]["graph"]) {
    const client = createClient<paths>({ baseUrl: "" });
    const { data, error } = await client.POST("/v1/evaluate", {
      body: ${body},
      headers: { Accept: "application/json" },
    });
    if (error) throw new Error(error.errors.map(({ code }) => code).join());
    const report = data as paths["/v1/evaluate"]["post"]["responses"][200]["content"]["application/json"];
    return report.model?.triangles;
  }`;

test("the description is valid OpenAPI 3.1", async () => {
  const validator = new Validator();
  const { valid, errors } = await validator.validate(structuredClone(description));
  assert.deepEqual(errors ?? [], []);
  assert.equal(valid, true);
  assert.equal(validator.version, "3.1");
});

test("every operation has an id of its own, and every reference leads somewhere", () => {
  const ids = Object.values(description.paths).flatMap((methods) => Object.values(methods).map((one) => one.operationId));
  assert.equal(new Set(ids).size, ids.length);
  const references = [...JSON.stringify(description).matchAll(/"\$ref":"#\/([^"]+)"/g)].map((match) => match[1]);
  assert.ok(references.length > 100);
  for (const reference of new Set(references)) {
    const found = reference.split("/").reduce((place, name) => place?.[name], description);
    assert.ok(found, reference);
  }
});

test("a client generated from the description compiles, and not when a member is wrong or missing", async () => {
  assert.deepEqual(await complaints(clientOf('{ graph, quality: "draft", parameters: { reach: 0.5 } }')), []);
  assert.match((await complaints(clientOf('{ quality: "draft" }'))).join(), /'graph' is missing/);
  assert.match((await complaints(clientOf('{ graph, quality: "rough" }'))).join(), /rough/);
});

test("a client of the description evaluates an example and is told what is wrong", async () => {
  const client = createClient({ baseUrl: url });
  const report = await client.POST("/v1/evaluate", { body: { graph: example }, headers: { Accept: "application/json" } });
  assert.equal(report.error, undefined);
  assert.ok(report.data.model.triangles > 0);
  const model = await client.POST("/v1/evaluate", { body: { graph: example }, parseAs: "arrayBuffer" });
  assert.equal(new TextDecoder().decode(new Uint8Array(model.data, 0, 4)), "glTF");
  assert.equal(model.data.byteLength, report.data.model.bytes);
  const wrong = await client.POST("/v1/evaluate", { body: { graph: example, qualty: "draft" } });
  assert.equal(wrong.response.status, 422);
  assert.deepEqual(wrong.error.errors.map(({ code }) => code), ["unknown-member"]);
});

test("the examples of the description are answered as it says", async () => {
  for (const [address, { post }] of Object.entries(description.paths)) {
    const content = post?.requestBody?.content["application/json"];
    if (content === undefined) continue;
    const answer = await fetch(url + address, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(content.example),
    });
    const well = Object.keys(post.responses).filter((status) => status.startsWith("2"));
    assert.equal(answer.status, Math.min(...well.map(Number)), address);
  }
});
