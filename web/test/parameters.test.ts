import assert from "node:assert/strict";
import { test } from "node:test";
import { byteText, fileName, grouped, literalText, numberText } from "../src/model/format";
import { colorText, colorValue, readParameter, snap, stepOf, withValue } from "../src/model/parameters";
import { parameterErrors, readProblem } from "../src/net/problem";

test("a parameter is read with its bounds, and named after itself without a label", () => {
  const parameter = readParameter("ring_size", { type: "number", default: 2, min: 0, max: 4, unit: "m" });
  assert.equal(parameter.label, "Ring size");
  assert.deepEqual([parameter.minimum, parameter.maximum, parameter.initial], [0, 4, 2]);
  assert.equal(stepOf(parameter), 0.01);
});

test("values equal to the default are not sent", () => {
  const parameter = readParameter("v", { type: "vector", default: [1, 2, 3] });
  const changed = withValue({}, parameter, [1, 2, 4]);
  assert.deepEqual(changed, { v: [1, 2, 4] });
  assert.deepEqual(withValue(changed, parameter, [1, 2, 3]), {});
});

test("steps leave no noise of binary fractions", () => {
  assert.equal(snap(0.1 + 0.2, 0.1), 0.3);
  assert.equal(snap(1.23456, 0.005), 1.235);
  assert.equal(snap(7.6, 5), 10);
  assert.equal(snap(-0.31, 0.25), -0.25);
});

test("colors keep the notation of the document", () => {
  assert.equal(colorText([1, 0.5, 0]), "#ffbc00");
  for (const text of ["#000000", "#0a141e", "#7f9df0", "#ffffff"]) {
    assert.equal(colorText(colorValue(text, [0, 0, 0])), text, "linear values give the same color back");
  }
  assert.deepEqual(colorValue("#ff0000", [0, 0, 0, 0.5]), [1, 0, 0, 0.5]);
  assert.equal(colorValue("#ff0000", "#000000"), "#ff0000");
});

test("the errors of a parameter are found by their pointer", () => {
  const errors = [
    { code: "out-of-range", pointer: "/parameters/reach", detail: "too far" },
    { code: "out-of-range", pointer: "/parameters/reach2", detail: "other" },
    { code: "type-mismatch", pointer: "/graph/parameters/reach", detail: "elsewhere" },
  ];
  const problem = readProblem(422, { title: "Wrong", errors });
  assert.deepEqual(
    parameterErrors(problem, "reach").map((entry) => entry.detail),
    ["too far"],
  );
});

test("a body that is no problem becomes one", () => {
  assert.equal(readProblem(500, "<html>").title, "The server answered 500");
  assert.equal(readProblem(422, { type: "/problems/degenerate" }).code, "degenerate");
});

test("numbers, literals, sizes and names are written for people", () => {
  assert.equal(grouped(199712), "199\u202f712");
  assert.equal(byteText(249_300), "249 kB");
  assert.equal(byteText(1_250_000), "1.25 MB");
  assert.equal(numberText(0.1 + 0.2), "0.3");
  assert.equal(numberText(1.5e9), "1.5e9");
  assert.equal(literalText([0, 0, 1.5]), "(0, 0, 1.5)");
  assert.equal(literalText([1, 2, 3, 4, 5]), "5 values");
  assert.equal(fileName("Boosted ring: É 2"), "boosted-ring-e-2");
  assert.equal(fileName("…"), "model");
});
