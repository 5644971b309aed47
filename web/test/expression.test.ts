import assert from "node:assert/strict";
import { test } from "node:test";
import { evaluateExpression } from "../src/model/expression";

const cases: [string, number][] = [
  ["1", 1],
  [" 2*pi/3 ", (2 * Math.PI) / 3],
  ["-2^2", -4],
  ["2^-1", 0.5],
  ["2^3^2", 512],
  ["(1+2)*3", 9],
  ["1e-3", 1e-3],
  [".5 + 1.", 1.5],
  ["1,5", 1.5],
  ["sqrt(2)", Math.SQRT2],
  ["--3", 3],
  ["7 % 4", 3],
  ["2**3", 8],
  ["π", Math.PI],
  ["3−1", 2],
  ["10 - 4 - 3", 3],
  ["tau/e", (2 * Math.PI) / Math.E],
];

test("a number field reads numbers and formulas", () => {
  for (const [text, expected] of cases) assert.equal(evaluateExpression(text), expected, text);
});

test("what is no formula or not finite is refused", () => {
  for (const text of [
    "",
    "abc",
    "1/0",
    "1 2",
    "2*",
    "(1",
    "1)",
    "sqrt",
    "sqrt 2",
    "alert(1)",
    "constructor",
    "0/0",
    "1;2",
    "toString()",
  ]) {
    assert.equal(evaluateExpression(text), undefined, text);
  }
});

test("deep nesting is refused instead of overflowing the stack", () => {
  assert.equal(evaluateExpression(`${"(".repeat(100_000)}1${")".repeat(100_000)}`), undefined);
  assert.equal(evaluateExpression(`2${"^2".repeat(100_000)}`), undefined);
});
