// Copying and pasting between graphs: what drives the nodes comes along, and what does not is told.

import assert from "node:assert/strict";
import { test } from "node:test";
import { copyText, paste, readClip } from "../src/model/clip";
import { withPlaces } from "../src/model/clip_layout";
import { emptyDocument, type GraphDocument, readDocument } from "../src/model/document";
import type { Json, JsonObject } from "../src/model/json";
import { type ParameterValues, parameterValue } from "../src/model/parameters";
import { pastedText } from "../src/session/clipboard";
import { randomFrom } from "./random";
import { catalogue } from "./real";

const SHIFT = { x: 10, y: 10 };

function open(json: Json): { document: GraphDocument; values: ParameterValues } {
  const result = readDocument(json);
  if ("error" in result) throw new Error(result.error);
  return result;
}

const ring = (parameters: JsonObject, nodes: JsonObject): GraphDocument =>
  open({ format: 1, parameters, nodes }).document;

/** The number that stands at an input: its literal, or the value of its parameter. */
function effective(document: GraphDocument, values: ParameterValues, node: string, input: string): Json {
  const source = document.nodes.get(node)?.inputs.get(input)?.[0];
  if (source?.kind === "literal") return source.value;
  const parameter = source?.kind === "parameter" && document.parameters.find(({ name }) => name === source.name);
  return parameter ? (parameterValue(parameter, values) as Json) : undefined;
}

function carry(from: GraphDocument, fromValues: ParameterValues, to: GraphDocument, toValues: ParameterValues) {
  const clip = readClip(copyText(from, new Set(from.nodes.keys()), fromValues) ?? "");
  assert.ok(clip);
  const pasted = paste(to, clip, SHIFT, false, toValues);
  return { pasted, document: pasted.edit(to), values: { ...toValues, ...pasted.values } };
}

test("nodes without places are laid out along their wires, and those with places stay where they are", () => {
  const nodes = {
    radius: { type: "number", inputs: { value: 2 } },
    ring: { type: "circle", inputs: { radius: { from: "radius" } } },
    other: { type: "circle", inputs: { radius: { from: "radius" } } },
    lifted: { type: "translate", inputs: { shape: { from: "ring" }, vector: [0, 0, 1] } },
  };
  const to = ring({}, { ring: { type: "circle", inputs: {} } });
  const clip = readClip(JSON.stringify({ format: 1, nodes }));
  assert.ok(clip);
  const placed = withPlaces(clip, to, catalogue);
  const at = (id: string): { x: number; y: number } => placed.places.get(id) ?? assert.fail(`${id} has no place`);
  assert.ok(at("radius").x < at("ring").x && at("ring").x < at("lifted").x);
  assert.ok(at("radius").x < at("other").x);
  assert.notDeepEqual(at("other"), at("ring"));
  assert.notDeepEqual(at("other"), at("lifted"));
  const kept = readClip(JSON.stringify({ format: 1, nodes, ui: { nodes: { ring: { x: 7, y: 9 } } } }));
  assert.ok(kept);
  assert.deepEqual(withPlaces(kept, to, catalogue).places.get("ring"), { x: 7, y: 9 });
});

test("a parameter comes along with its value, and its default stays what it was", () => {
  const reach = { type: "number", default: 1, min: 0, max: 4, label: "Reach" };
  const from = ring(
    { reach, other: { ...reach } },
    { n: { type: "number", inputs: { value: { parameter: "reach" } } } },
  );
  const { pasted, document, values } = carry(from, { reach: 2.75 }, emptyDocument(), {});
  assert.deepEqual(document.json["parameters"], { reach });
  assert.deepEqual(values, { reach: 2.75 });
  assert.equal(pastedText(pasted), "Added 1 node; with the parameter Reach");
});

test("in its own graph a parameter drives the copy too", () => {
  const from = ring(
    { reach: { type: "number", default: 1 } },
    { n: { type: "number", inputs: { value: { parameter: "reach" } } } },
  );
  for (const values of [{}, { reach: 3 }] as ParameterValues[]) {
    const { pasted, document } = carry(from, values, from, values);
    assert.deepEqual(document.json["parameters"], from.json["parameters"]);
    assert.equal(pastedText(pasted), "Added 1 node");
  }
  // Moved on between copying and pasting: the copy follows, and that is said.
  const { pasted } = carry(from, {}, from, { reach: 3 });
  assert.equal(pastedText(pasted), "Added 1 node; Reach is 3 in this graph");
});

test("another parameter of the same name is left alone", () => {
  const from = ring(
    { k: { type: "number", default: 5, max: 9 } },
    { n: { type: "number", inputs: { value: { parameter: "k" } } } },
  );
  const to = ring({ k: { type: "number", default: 1 } }, {});
  const { document, values } = carry(from, {}, to, {});
  assert.equal(effective(document, values, "n", "value"), 5);
  assert.deepEqual(Object.keys(document.json["parameters"] as object), ["k", "k_2"]);
});

test("what has no definition falls to its default, and that is said; wires that are cut are counted", () => {
  const clip = readClip(
    JSON.stringify({
      format: 1,
      nodes: {
        a: { type: "number", inputs: { value: { parameter: "gone" } } },
        b: {
          type: "add",
          inputs: { generators: [{ from: "x" }, { from: "y" }, { from: "a" }], weights: { from: "z" } },
        },
      },
    }),
  );
  assert.ok(clip);
  const pasted = paste(emptyDocument(), clip, SHIFT, true);
  assert.equal(
    pastedText(pasted),
    "Added 2 nodes; value of a lost the parameter gone, which this graph does not have; 3 incoming wires left out",
  );
  const document = pasted.edit(emptyDocument());
  assert.equal(document.nodes.get("a")?.inputs.size, 0);
  assert.deepEqual(document.nodes.get("b")?.inputs.get("generators"), [{ kind: "link", node: "a" }]);
});

test("no value changes by pasting unless it is told", () => {
  const names = ["a", "b", "c"];
  for (let seed = 1; seed <= 300; seed++) {
    const random = randomFrom(seed);
    const graph = (): { document: GraphDocument; values: ParameterValues } => {
      const known = names.filter(() => random(3) > 0);
      const parameters = Object.fromEntries(
        known.map((name) => [
          name,
          random(4) === 0 ? { type: "boolean", default: true } : { type: "number", default: random(3) },
        ]),
      );
      const nodes = Object.fromEntries(
        names.map((name) => [
          `n${name}`,
          { type: "number", inputs: { value: known.includes(name) ? { parameter: name } : random(5) } },
        ]),
      );
      const values = Object.fromEntries(
        known.filter((name) => random(2) && parameters[name]?.type === "number").map((name) => [name, 10 + random(2)]),
      );
      return { document: ring(parameters, nodes), values };
    };
    const [from, to] = [graph(), graph()];
    const { pasted, document, values } = carry(from.document, from.values, to.document, to.values);
    const told = new Set(
      pasted.drivers.flatMap((driver) =>
        driver.kind === "present" && driver.value !== undefined ? [driver.name] : [],
      ),
    );
    names.forEach((name, at) => {
      const before = effective(from.document, from.values, `n${name}`, "value");
      if (!told.has(name))
        assert.equal(effective(document, values, pasted.ids[at] ?? "", "value"), before, `seed ${seed}, ${name}`);
      // The graph that was pasted into is as it was.
      const present = effective(to.document, to.values, `n${name}`, "value");
      assert.equal(effective(document, values, `n${name}`, "value"), present, `seed ${seed}, ${name}`);
    });
  }
});
