import assert from "node:assert/strict";
import { test } from "node:test";
import { readParameter } from "../src/model/parameters";
import { graphInPath, outputAddress, readAsked, valuesFrom } from "../src/net/stored";

const PARAMETERS = [
  readParameter("reach", { type: "number", default: 1 }),
  readParameter("closed", { type: "boolean", default: false }),
  readParameter("rule", { type: "choice", default: "exact", choices: ["exact", "paper"] }),
  readParameter("axis", { type: "vector", default: [0, 0, 1] }),
  readParameter("tint", { type: "color", default: [1, 0, 0] }),
  readParameter("quality", { type: "number", default: 1 }),
  readParameter("theme", { type: "number", default: 1 }),
];

const valuesOf = (search: string) => valuesFrom(readAsked(search).texts, PARAMETERS);

test("the graph is the last part of the address, with its version", () => {
  assert.equal(graphInPath("/embed/ring"), "ring");
  assert.equal(graphInPath("/below/a/prefix/embed/ring@3"), "ring@3");
  assert.equal(graphInPath("/embed/%22a%20b"), '"a b');
  assert.equal(graphInPath("/embed/%"), "%");
});

test("values of every type are read from an address, and written into that of the model", () => {
  const read = valuesOf("?reach=-2.5&closed=true&rule=paper&axis=1,0,0&tint=0,0.5,1,1");
  const values = { reach: -2.5, closed: true, rule: "paper", axis: [1, 0, 0], tint: [0, 0.5, 1, 1] };
  assert.deepEqual(read, { value: values });
  const address = outputAddress("ring@3", "out", values, "draft");
  assert.ok(address.startsWith("../v1/graphs/ring@3/outputs/out.glb?"));
  assert.deepEqual(Object.fromEntries(new URLSearchParams(address.slice(address.indexOf("?")))), {
    ...{ reach: "-2.5", closed: "true", rule: "paper", axis: "1,0,0", tint: "0,0.5,1,1", quality: "draft" },
  });
});

test("a model in full without values has a bare address, and names from outside stay names", () => {
  assert.equal(outputAddress("ring@1", "out", {}, "final"), "../v1/graphs/ring@1/outputs/out.glb");
  assert.equal(outputAddress("../x", "a/b", {}, "final"), "../v1/graphs/..%2Fx/outputs/a%2Fb.glb");
});

test("what the page and the server have for themselves is told apart from parameters that are called alike", () => {
  const asked = readAsked("?theme=light&output=side&parameter.theme=2&parameter.quality=3");
  assert.equal(asked.theme, "light");
  assert.equal(asked.output, "side");
  assert.deepEqual(valuesFrom(asked.texts, PARAMETERS), { value: { theme: 2, quality: 3 } });
  assert.match(outputAddress("ring@1", "out", { quality: 3 }, "draft"), /\?parameter\.quality=3&quality=draft$/);
});

test("what is no parameter, or no value of one, is a problem", () => {
  for (const [search, words] of [
    ["?raech=1", /no parameter “raech”; it has reach, closed/],
    ["?__proto__=1", /no parameter “__proto__”/],
    ["?reach=", /“” is no number for “reach”/],
    ["?reach=1e999", /is no number/],
    ["?reach=one", /is no number/],
    ["?closed=1", /is no boolean/],
    ["?rule=other", /“other” is no choice for “rule”/],
    ["?axis=1,2", /is no vector/],
    ["?axis=1,2,3,4", /is no vector/],
    ["?tint=red", /is no color/],
  ] as const) {
    const read = valuesOf(search);
    assert.ok("problem" in read, search);
    assert.match(read.problem.detail, words);
  }
});
