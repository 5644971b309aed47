import assert from "node:assert/strict";
import { test } from "node:test";
import { readQuantity } from "../src/model/units";

const READ: readonly [string, string, number][] = [
  ["3", "m", 3],
  ["3 mm", "m", 0.003],
  ["3mm", "\u202fm", 0.003],
  ["2*3 cm", "m", 0.06],
  ["1,5 m", "m", 1.5],
  ["2 in", "m", 0.0508],
  ["90 deg", "°", 90],
  ["90°", "°", 90],
  ["1/4 turn", "°", 90],
  ["pi rad", "°", 180],
  ["2*pi/4 rad", "°", 90],
  ["50 %", "", 0.5],
  ["4 1/m", "1/m", 4],
  ["2*pi/3", "°", (2 * Math.PI) / 3],
];

test("a number is read with its unit, in the unit of its field", () => {
  for (const [text, unit, value] of READ) assert.deepEqual(readQuantity(text, unit), { value }, `${text} in ${unit}`);
});

test("a unit that does not fit, or is none, is told in words", () => {
  const told: readonly [string, string, RegExp][] = [
    ["3 mm", "°", /“3 mm” is a length; an angle in degrees is needed/],
    ["3 mm", "", /a plain number is needed/],
    ["3 mm", "1/m", /a number in 1\/m is needed/],
    ["3 parsec", "m", /“parsec” is no unit that is known here, with a unit as in 3 mm/],
    ["nonsense", "m", /“nonsense” is not a number, with a unit as in 3 mm, or a formula/],
    ["", "", /“” is not a number or a formula/],
  ];
  for (const [text, unit, wanted] of told) {
    const read = readQuantity(text, unit);
    assert.ok("error" in read, text);
    assert.match(read.error, wanted);
  }
});
