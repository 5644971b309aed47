// Documents that everybody takes, and documents that nobody takes. Each wrong one differs from a right one by one thing.

const ring = { type: "circle", inputs: { radius: 1 } };
const number = { type: "number", inputs: { value: 2 } };
const pair = { type: "point_pair", inputs: { position: [0, 0, 1], direction: [0, 0, 1] } };
const box = { type: "box_mesh" };
const reach = { type: "number", default: 1 };

const graph = (nodes, more) => ({ format: 1, nodes, ...more });
const node = (type, inputs, more) => graph({ ring, number, pair, box, n: { type, inputs, ...more } });
const parameter = (members) => graph({}, { parameters: { reach: { ...reach, ...members } } });

export const right = {
  "an empty graph": graph({}),
  "a document that says where its schema is": graph({}, { $schema: "http://127.0.0.1:8080/schema/graph-1.json" }),
  "free members": graph({}, { meta: { title: "T", anything: [1] }, ui: { nodes: {} } }),
  "a whole number written as 16.0": node("range", { count: 16.0 }),
  "a link to the first output": node("sample", { shape: { from: "ring" } }),
  "a link to a named output": node("sample", { shape: { from: "ring.circle" } }),
  "a parameter at an input": {
    ...graph({ n: { type: "circle", inputs: { radius: { parameter: "reach" } } } }),
    parameters: { reach },
  },
  "a list of links and literals": node("list", { items: [{ from: "number" }, 3] }),
  "a list of literals": node("list", { items: [[0, 0, 1], [1, 0, 0]] }),
  "one link where several are taken": node("list", { items: { from: "number" } }),
  "a node that is bypassed": node("scale", { shape: { from: "ring" } }, { bypass: true }),
  "a bypassed node without what it would need": node("boost", { shape: { from: "ring" } }, { bypass: true }),
  "parameters of every type": graph(
    {},
    {
      parameters: {
        a: { ...reach, min: 0, max: 2, step: 0.1, unit: "m", label: "A", description: "How far." },
        b: { type: "integer", default: 2 },
        c: { type: "boolean", default: true },
        d: { type: "choice", default: "x", choices: ["x", "y"] },
        e: { type: "vector", default: [0, 0, 1] },
        f: { type: "color", default: [1, 0.5, 0] },
      },
    },
  ),
};

export const wrong = {
  "no object": [],
  "no format": { nodes: {} },
  "another format": { format: 3, nodes: {} },
  "a format in words": { format: "1", nodes: {} },
  "no nodes": { format: 1 },
  "nodes in a list": graph([]),
  "an unknown member": graph({}, { nods: {} }),
  "a schema that is no text": graph({}, { $schema: 1 }),
  "an id that starts with a digit": graph({ "1a": ring }),
  "an id with a dot": graph({ "a.b": ring }),
  "an id of 65 letters": graph({ ["a".repeat(65)]: ring }),
  "an empty id": graph({ "": ring }),
  "a node that is no object": graph({ n: 1 }),
  "a node without a type": graph({ n: { inputs: {} } }),
  "a type that is no text": graph({ n: { type: 1 } }),
  "an unknown type": node("crcle", {}),
  "an unknown member of a node": node("circle", {}, { input: {} }),
  "inputs in a list": node("circle", []),
  "an unknown input": node("circle", { radios: 1 }),
  "a bypass in words": node("scale", { shape: { from: "ring" } }, { bypass: "yes" }),
  "a bypassed node that is given nothing": node("scale", {}, { bypass: true }),
  "a required input that is missing": node("boost", { shape: { from: "ring" } }),
  "a text for a number": node("circle", { radius: "1" }),
  "a number for a text": node("range", { count: 3, axis: 1 }),
  "a number for a boolean": node("range", { count: 3, closed: 1 }),
  "a number that is not whole": node("range", { count: 2.5 }),
  "a number below its range": node("tube", { shape: { from: "ring" }, radius: -1 }),
  "a number above its range": node("export", { model: { from: "ring" }, speed: 11 }),
  "a word that is no choice": node("warp", { shape: [0, 0, 0], generators: { from: "pair" }, rule: "rapid" }),
  "a point of two numbers": node("circle", { center: [0, 0] }),
  "a point with a text": node("circle", { center: [0, 0, "0"] }),
  "a literal circle": node("sample", { shape: { radius: 1 } }),
  "a literal among exported things": node("export", { model: [[0, 0, 0]] }),
  "a color beyond 1": node("color", { shape: { from: "box" }, color: [2, 0, 0] }),
  "a link that is no text": node("sample", { shape: { from: 1 } }),
  "a link with more": node("sample", { shape: { from: "ring", x: 1 } }),
  "a link to a literal": node("range", { count: { from: "number" } }),
  "a list where one value is taken": node("sample", { shape: [{ from: "ring" }] }),
  "an empty list": node("list", { items: [] }),
  "a parameter that is no text": node("circle", { radius: { parameter: 1 } }),
  "a parameter for a circle": { ...node("sample", { shape: { parameter: "reach" } }), parameters: { reach } },
  "parameters in a list": graph({}, { parameters: [] }),
  "a parameter with a digit first": graph({}, { parameters: { "1a": reach } }),
  "a parameter that is no object": graph({}, { parameters: { reach: 1 } }),
  "a parameter without a type": parameter({ type: undefined }),
  "a parameter of an unknown type": parameter({ type: "circle" }),
  "a parameter without a default": parameter({ default: undefined }),
  "a default of another type": parameter({ default: "1" }),
  "a default that is not whole": parameter({ type: "integer", default: 1.5 }),
  "a vector of two numbers": parameter({ type: "vector", default: [0, 0] }),
  "an unknown member of a parameter": parameter({ maximum: 2 }),
  "a bound in words": parameter({ max: "2" }),
  "a step of 0": parameter({ step: 0 }),
  "a label that is no text": parameter({ label: 1 }),
  "a choice without choices": parameter({ type: "choice", default: "x" }),
  "choices of a number": parameter({ choices: ["x"] }),
  "choices that are no texts": parameter({ type: "choice", default: "x", choices: ["x", 1] }),
};
