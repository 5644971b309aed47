import assert from "node:assert/strict";
import { test } from "node:test";
import { assetWords, commandLineText } from "../src/files/commands";
import { readCatalogue } from "../src/model/catalogue";
import { readDocument } from "../src/model/document";
import { createStore } from "../src/model/store";
import type { Session } from "../src/session/session";
import { EMPTY, type SessionState } from "../src/session/state";

const HASH = "5".repeat(64);
const OTHER = "7".repeat(64);
const catalogue = readCatalogue({
  types: [],
  nodes: [{ id: "file_mesh", inputs: [{ name: "source", types: ["text"], names_file: true }], outputs: [] }],
});
const json = (hash: string) => ({
  format: 1,
  meta: { title: "A chair" },
  nodes: {
    seat: { type: "file_mesh", inputs: { source: hash } },
    back: { type: "file_mesh", inputs: { source: hash } },
  },
});

function command(hash: string, change: Partial<SessionState>): string | undefined {
  const read = readDocument(json(hash));
  assert.ok("document" in read);
  const example = { id: "vase", title: "", description: "", figure: "", image: "", graph: json(OTHER) };
  const state: SessionState = { ...EMPTY, document: read.document, catalogue, examples: [example], ...change };
  const session = { store: createStore(state) } as unknown as Session;
  return commandLineText(session, (asked) => (asked === HASH ? "My chair (2).ply" : undefined));
}

test("a command names the file of an uploaded mesh, once", () => {
  const text = command(HASH, { isChanged: true });
  assert.match(text ?? "", /^dini eval - --asset 'my-chair-2=My chair \(2\)\.ply' -o a-chair\.glb <<'GRAPH'\n/);
  const file = command(HASH, { origin: { kind: "file", name: "a.json" } });
  assert.equal(file, "dini eval a.json --asset 'my-chair-2=My chair (2).ply' -o a-chair.glb");
});

test("meshes of the examples need no file", () => {
  assert.match(command(OTHER, { isChanged: true }) ?? "", /^dini eval - -o a-chair\.glb <</);
  const example = command(OTHER, { origin: { kind: "example", id: "vase" }, values: { strength: 0.5 } });
  assert.equal(example, "dini eval examples/vase.json --set strength=0.5 -o a-chair.glb");
});

test("files of the same name, of unknown name and named by a word have names of their own", () => {
  const files = [
    { asset: HASH, node: "a" },
    { asset: OTHER, node: "b" },
    { asset: "9".repeat(64), node: "the_seat" },
    { asset: "table", node: "c" },
  ];
  const words = assetWords(files, (asked) => (asked === HASH || asked === OTHER ? "chair.obj" : undefined));
  assert.deepEqual(words, ["chair=chair.obj", "chair-2=chair.obj", "the-seat=the-seat.obj", "table=table.obj"]);
});
