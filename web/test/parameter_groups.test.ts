import assert from "node:assert/strict";
import { test } from "node:test";
import { type GraphDocument, lookedAt, readDocument } from "../src/model/document";
import { groupedParameters, moveIntoPlace, setGroup } from "../src/model/parameter_groups";

function graph(): GraphDocument {
  const parameters = Object.fromEntries(["a", "b", "c", "d"].map((name) => [name, { type: "number", default: 0 }]));
  const read = readDocument({ format: 1, parameters, nodes: {} });
  if ("error" in read) throw new Error(read.error);
  return read.document;
}

const shown = (document: GraphDocument): string[] =>
  groupedParameters(document).map(({ title, parameters }) => `${title}:${parameters.map(({ name }) => name).join("")}`);

test("a parameter that is put into a group stands behind the others of it", () => {
  const one = setGroup("a", "Size")(graph());
  assert.deepEqual(shown(one), ["Size:a", ":bcd"]);
  const two = setGroup("d", "Size")(one);
  assert.deepEqual(shown(two), ["Size:ad", ":bc"]);
  const none = setGroup("d", "")(setGroup("a", "")(two));
  assert.equal((none.json["ui"] as Record<string, unknown>)["parameters"], undefined);
});

test("a parameter that is moved joins the group that it is put into, and keeps its own at its border", () => {
  const grouped = setGroup("b", "Size")(setGroup("a", "Size")(graph()));
  assert.deepEqual(shown(moveIntoPlace("d", 1)(grouped)), ["Size:adb", ":c"]);
  assert.deepEqual(shown(moveIntoPlace("b", 0)(grouped)), ["Size:ba", ":cd"]);
  assert.deepEqual(shown(moveIntoPlace("c", 3)(grouped)), ["Size:ab", ":dc"]);
});

test("a parameter that is taken out of the middle of its group does not part the others", () => {
  const all = ["a", "b", "c"].reduce((document, name) => setGroup(name, "Size")(document), graph());
  assert.deepEqual(shown(setGroup("b", "")(all)), [":b", "Size:ac", ":d"]);
  assert.deepEqual(shown(setGroup("c", "")(all)), ["Size:ab", ":cd"]);
});

test("inputs of a group have headings of their own, whatever the graph's parameters of the same names have", () => {
  const read = readDocument({
    format: 2,
    parameters: { a: { type: "number", default: 0 } },
    groups: { g: { inputs: [{ name: "a", default: 1 }], outputs: [], nodes: {} } },
    nodes: { g: { type: "group/g" } },
  });
  assert.ok("document" in read);
  const whole = setGroup("a", "Outside")(read.document);
  const inside = lookedAt(whole, [{ id: "g", group: "g" }]);
  assert.deepEqual(shown(inside), [":a"]);
  const named = setGroup("a", "Inside")(inside);
  assert.deepEqual(shown(named), ["Inside:a"]);
  assert.deepEqual(shown(lookedAt(named, [])), ["Outside:a"]);
});
