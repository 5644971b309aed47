import assert from "node:assert/strict";
import { test } from "node:test";
import { addressesOf } from "../src/files/addresses";
import { assetWords, commandLineText } from "../src/files/commands";
import { addImport } from "../src/files/import_mesh";
import { type Catalogue, readCatalogue } from "../src/model/catalogue";
import { type GraphDocument, lookedAt, readDocument } from "../src/model/document";
import { removeNodes } from "../src/model/edit";
import { withGroups } from "../src/model/group_cards";
import { createStore } from "../src/model/store";
import type { Session } from "../src/session/session";
import { EMPTY, type SessionState } from "../src/session/state";
import { catalogue as real } from "./real";

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

/** A document whose only file and whose only mesh are in groups, looked at inside of one of them. */
function grouped(): { document: GraphDocument; catalogue: Catalogue } {
  const read = readDocument({
    format: 2,
    groups: {
      chair: {
        inputs: [{ name: "source", default: OTHER }],
        outputs: [{ name: "file", from: "out" }],
        nodes: { seat: { type: "import", inputs: { asset: { input: "source" } } }, out: { type: "export" } },
      },
    },
    nodes: { chair: { type: "group/chair", inputs: { source: HASH } } },
  });
  assert.ok("document" in read);
  const document = lookedAt(read.document, [{ id: "chair", group: "chair" }]);
  return { document, catalogue: withGroups(real, document) };
}

test("what a group is given is found from inside of the group as well", () => {
  const state = { ...EMPTY, ...grouped(), examples: [], isChanged: true };
  const session = { store: createStore(state) } as unknown as Session;
  const text = commandLineText(session, (asked) => (asked === HASH ? "chair.ply" : undefined));
  assert.match(text ?? "", /^dini eval - --asset chair=chair\.ply --asset source=source\.obj -o /);
});

test("a mesh that is imported inside of a group gets no end of its own there", () => {
  const { document, catalogue: cards } = grouped();
  const added = addImport(document, cards, HASH);
  assert.ok(added);
  assert.equal(added.edit(document).nodes.size, document.nodes.size + 1);
  const bare = lookedAt(removeNodes(["out"])(document), document.inside);
  const alone = addImport(bare, withGroups(real, bare), HASH);
  assert.equal(alone?.edit(bare).nodes.size, bare.nodes.size + 1);
});

test("a file that a group makes is found from inside of the group as well", () => {
  globalThis.document = { baseURI: "http://somewhere/" } as Document;
  const origin = { kind: "stored", id: "chair", version: 1, tag: "" } as const;
  const addresses = addressesOf({ ...EMPTY, ...grouped(), origin });
  assert.deepEqual(
    addresses.map(({ title }) => title),
    ["Graph in the editor", "Model", "Frame for a page"],
  );
});
