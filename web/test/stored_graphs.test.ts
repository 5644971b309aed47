// Graphs that the server keeps, when one is deleted that is open.

import assert from "node:assert/strict";
import { test } from "node:test";
import { StoredGraphs } from "../src/files/StoredGraphs";
import type { Json } from "../src/model/json";
import { FakeView, fakeSession, serve } from "./fake_session";

const GRAPH: Json = { format: 1, meta: { title: "Ring" }, nodes: {} };
const version = { id: "ring", version: 2, title: "Ring", created: 0, tag: '"2-a"' };
const stored = { kind: "stored", id: "ring", version: 2, tag: '"2-a"' } as const;

function made(): { said: string[]; dialogs: (string | null)[]; graphs: StoredGraphs; origin: () => string } {
  const session = fakeSession(GRAPH, new FakeView(), { origin: stored });
  const [said, dialogs]: [string[], (string | null)[]] = [[], []];
  const graphs = new StoredGraphs(session, {
    say: (text) => void said.push(text),
    show: (dialog) => void dialogs.push(dialog),
    open: () => true,
    kept: () => undefined,
  });
  return { said, dialogs, graphs, origin: () => session.store.get().origin.kind };
}

test("the open graph is unsaved once it is deleted on the server", async () => {
  serve(() => new Response(null, { status: 204 }));
  const { graphs, origin } = made();
  assert.equal(await graphs.remove({ ...version, id: "other" }), "");
  assert.equal(origin(), "stored");
  assert.equal(await graphs.remove(version), "");
  assert.equal(origin(), "new");
});

test("a graph that was saved meanwhile is not deleted, and it is said what to do", async () => {
  serve(() => new Response("{}", { status: 412 }));
  const { graphs, origin } = made();
  assert.match(await graphs.remove(version), /saved meanwhile/);
  assert.equal(origin(), "stored");
});

test("saving what was deleted elsewhere asks for a name, and compares it with nothing", async () => {
  serve((address) => {
    if (address.endsWith("/versions")) return new Response(JSON.stringify({ versions: [{ id: "ring", version: 2 }] }));
    return new Response("{}", { status: address.includes("ring") && seen++ > 0 ? 404 : 412 });
  });
  let seen = 0;
  const { said, dialogs, graphs } = made();
  await graphs.keep();
  assert.match(said[0] ?? "", /ring was deleted on the server/);
  assert.deepEqual(dialogs, ["keep"]);
});
