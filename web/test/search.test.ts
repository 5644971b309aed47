import assert from "node:assert/strict";
import { test } from "node:test";
import { runsThrough } from "../src/graph/drop_on_wire";
import { readCatalogue } from "../src/model/catalogue";
import { readDocument } from "../src/model/document";
import { evaluateExpression } from "../src/model/expression";
import { Habits } from "../src/model/habits";
import { asParameter, controlKind, listText, readList } from "../src/model/inputs";
import type { Json } from "../src/model/json";
import { patchDocument } from "../src/model/patch";
import { freePlace } from "../src/model/place";
import { findNodes } from "../src/model/search";
import { catalogue, examples } from "./real";

const titles = (text: string): string[] => findNodes(catalogue, text).map(({ card }) => card.title);

test("the search finds by title, id, family, description, and with letters left out, the best first", () => {
  assert.equal(titles("boost")[0], "Boost");
  assert.equal(titles("point_pair")[0], "Point pair");
  assert.equal(titles("tub")[0], "Tube");
  assert.ok(titles("transforms").includes("Twist"));
  assert.ok(findNodes(catalogue, "linked circle").some(({ card }) => card.id === "hopf"));
  assert.equal(titles("sphrmsh")[0], "Sphere mesh");
  assert.deepEqual(titles("qqqq"), []);
  assert.equal(titles("").length, catalogue.nodes.size);
});

/** What people type who do not know what we call it, and one of what they may mean, which is to come first. */
const WORDS: readonly [string, readonly string[]][] = [
  ["ring", ["circle"]],
  ["lathe", ["surface", "twist", "rotate"]],
  ["slider", ["number"]],
  ["helix", ["helix", "twist", "loxodrome"]],
  ["array", ["array", "range", "list"]],
  ["bend", ["boost", "point_pair", "warp", "curvature"]],
  ["noise", ["noise", "random"]],
  ["ball", ["sphere", "sphere_mesh"]],
  ["cube", ["box_mesh"]],
  ["donut", ["torus_mesh"]],
  ["pipe", ["tube"]],
  ["loft", ["surface"]],
  ["move", ["translate"]],
  ["resize", ["scale"]],
  ["turn", ["rotate", "rotation"]],
  ["screw", ["twist"]],
  ["blend", ["interpolate", "blend"]],
  ["formula", ["expression"]],
  ["dipole", ["point_pair", "point_pair_through"]],
  ["deform", ["warp", "boost"]],
  ["streamline", ["orbit"]],
  ["isoline", ["contour"]],
  ["paint", ["color"]],
  ["glass", ["material"]],
  ["gradient", ["color_by"]],
  ["volume", ["measure"]],
  ["download", ["export"]],
  ["obj", ["import"]],
  ["join", ["merge"]],
  ["linked circles", ["hopf"]],
  ["path trajectory", ["orbit"]],
];

test("other words find what is meant, and say so", () => {
  for (const [word, meant] of WORDS) {
    const [first] = findNodes(catalogue, word);
    assert.ok(first && meant.includes(first.card.id), `${word} finds ${first?.card.id} first`);
  }
  assert.equal(findNodes(catalogue, "donut")[0]?.word, "donut");
  assert.equal(findNodes(catalogue, "boost")[0]?.word, undefined);
});

test("every node can be found by other words than its own", () => {
  for (const card of catalogue.nodes.values()) assert.ok(card.synonyms.length > 0, card.id);
});

test("the likeliest node for a loose wire comes first, as the examples connect such wires", () => {
  const habits = new Habits(
    catalogue,
    examples.map(({ graph }) => graph),
  );
  const first = (side: "output" | "input", type: string): string | undefined =>
    findNodes(catalogue, "", { side, types: [type] }, habits)[0]?.card.id;
  assert.equal(first("output", "asset"), undefined);
  assert.equal(first("output", "generator"), "boost");
  assert.ok(["export", "merge", "color", "material"].includes(first("output", "mesh") ?? ""), first("output", "mesh"));
  assert.equal(first("input", "generator"), "point_pair");
  assert.ok(["surface", "tube"].includes(first("input", "mesh") ?? ""), first("input", "mesh"));
});

test("a loose wire limits the search to nodes with a socket for it", () => {
  const feeding = findNodes(catalogue, "", { side: "output", types: ["generator"] });
  assert.ok(feeding.length > 0 && feeding.length < catalogue.nodes.size);
  for (const { card, socket } of feeding) {
    assert.ok(card.inputs.find((input) => input.name === socket)?.types.includes("generator"), card.id);
  }
  const fed = findNodes(catalogue, "", { side: "input", types: ["mesh"] });
  for (const { card, socket } of fed) {
    assert.ok(card.outputs.find((output) => output.name === socket)?.types.includes("mesh"), card.id);
  }
  assert.deepEqual(findNodes(catalogue, "", { side: "output", types: ["asset"] }), []);
});

test("typed values find the nodes that hold them, by types and not by names", () => {
  const input = (name: string, type: string): Json => ({ name, types: [type], default: 0 });
  const made = readCatalogue({
    nodes: [
      { id: "n", title: "N", inputs: [input("it", "number")], outputs: [{ name: "o", types: ["number"] }] },
      { id: "p", title: "P", inputs: [input("at", "point")], outputs: [{ name: "o", types: ["point"] }] },
      {
        id: "v",
        title: "V",
        inputs: ["a", "b", "c"].map((name) => input(name, "number")),
        outputs: [{ name: "o", types: ["vector"] }],
      },
    ],
  });
  assert.deepEqual(findNodes(made, "2*pi")[0]?.inputs, { it: 2 * Math.PI });
  assert.deepEqual(findNodes(made, "0<5<10")[0]?.slider?.item, { type: "number", default: 5, min: 0, max: 10 });
  const triples = findNodes(made, "1, 2,3");
  assert.deepEqual(
    triples.map(({ card }) => card.id),
    ["p", "v"],
  );
  assert.deepEqual(
    triples.map(({ inputs }) => inputs),
    [{ at: [1, 2, 3] }, { a: 1, b: 2, c: 3 }],
  );
  assert.deepEqual(findNodes(made, "1,2")[0]?.inputs, { it: 1.2 }, "as in a field");
  for (const text of ["1,2; 3", "1, 2", "10<5<0", "1<2", "1,2,x", "n"]) {
    assert.ok(!findNodes(made, text).some((item) => item.inputs ?? item.slider), text);
  }
});

test("commas mean the same in a list as in a field", () => {
  const lists: [string, Json][] = [
    ["1,5", [1.5]],
    [",5", [0.5]],
    ["1,5; 2,5", [1.5, 2.5]],
    ["1,5;-,5; 2*0,5+1,5", [1.5, -0.5, 2.5]],
    ["1, 5", [1, 5]],
    ["1,2,3", [1, 2, 3]],
    ["1, 2,3", [1, 2, 3]],
    ["1.5,2.5", [1.5, 2.5]],
    ["1e3,5", [1000, 5]],
    ["-1,pi/pi", [-1, 1]],
    [
      "(0,5; 1; 2) (1,0,0)",
      [
        [0.5, 1, 2],
        [1, 0, 0],
      ],
    ],
    ["(1+1,5)*2", [5]],
  ];
  for (const [text, expected] of lists) {
    assert.deepEqual(readList(text), expected, text);
    const alone = Array.isArray(expected) && expected.length === 1 ? expected[0] : undefined;
    assert.equal(evaluateExpression(text), alone, text);
  }
  for (const text of ["1,,5", "1;2,3,4", "1,5;", ",", "1.000,5,5x"]) assert.equal(readList(text), undefined, text);
});

test("lists are written and read, as numbers or as triples", () => {
  for (const value of [
    [1, -1, 0.5],
    [
      [0, 0, 1],
      [1, 0, 0],
    ],
  ] as Json[])
    assert.deepEqual(readList(listText(value)), value);
  assert.deepEqual(readList("pi/pi; 2"), [1, 2]);
  for (const text of ["", "a, b", "(1, 2)", "(1,2,3) 4"]) assert.equal(readList(text), undefined, text);
});

test("every input of the catalogue has a control, or takes wires only", () => {
  for (const card of catalogue.nodes.values()) {
    for (const input of card.inputs) {
      const kind = controlKind(input, input.fallback);
      const isWire = input.types.every((type) => !catalogue.types.get(type)?.literalOnly);
      assert.ok(kind !== undefined || isWire, `${card.id}.${input.name}`);
      if (kind !== undefined && kind !== "list") assert.equal(asParameter(input, kind).type, kind);
    }
  }
});

test("a new box stands clear of all others, as near as can be", () => {
  const boxes = [0, 1, 2, 3].map((at) => ({ x: 100 * at, y: 0, width: 90, height: 200 }));
  const size = { width: 208, height: 120 };
  for (const wanted of [
    { x: 0, y: 0 },
    { x: 150, y: 90 },
    { x: 5000, y: 5000 },
  ]) {
    const { x, y } = freePlace(wanted, size, boxes);
    for (const box of boxes) {
      const isClear =
        x + size.width <= box.x || box.x + box.width <= x || y + size.height <= box.y || box.y + box.height <= y;
      assert.ok(isClear, `${x}, ${y}`);
    }
    if (wanted.x === 5000) assert.deepEqual({ x, y }, wanted);
  }
});

test("a wire runs through the boxes on its way, forwards and backwards", () => {
  const box = { x: 90, y: -20, width: 60, height: 40 };
  assert.ok(runsThrough({ x: 0, y: 0 }, { x: 240, y: 0 }, box));
  assert.ok(!runsThrough({ x: 0, y: 100 }, { x: 240, y: 100 }, box));
  assert.ok(!runsThrough({ x: 400, y: 0 }, { x: 300, y: 0 }, box));
});

test("a fix changes what it points at, and one that does not fit changes nothing", () => {
  const read = readDocument({ format: 1, nodes: { a: { type: "range", inputs: { count: 0, list: [1, 2] } } } });
  if ("error" in read) throw new Error(read.error);
  const apply = (op: string, path: string, value?: Json): Json =>
    patchDocument(read.document, [{ op, path, value }])?.json["nodes"];
  const inputs = "/graph/nodes/a/inputs";
  assert.deepEqual(apply("replace", `${inputs}/count`, 1), {
    a: { type: "range", inputs: { count: 1, list: [1, 2] } },
  });
  assert.deepEqual(apply("remove", `${inputs}/count`), { a: { type: "range", inputs: { list: [1, 2] } } });
  assert.deepEqual(apply("add", `${inputs}/list/1`, 9), {
    a: { type: "range", inputs: { count: 0, list: [1, 9, 2] } },
  });
  for (const path of [`${inputs}/none`, "/graph/nodes/b/inputs/count", "/parameters/x", `${inputs}/list/7`]) {
    assert.equal(apply("replace", path, 1), undefined, path);
  }
  assert.deepEqual(read.document.json["nodes"], { a: { type: "range", inputs: { count: 0, list: [1, 2] } } });
});
