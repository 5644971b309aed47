// Playing and comparing against a server that fails, forgets and is slow.

import assert from "node:assert/strict";
import { test } from "node:test";
import { rewritten } from "../src/model/document";
import { setTitle } from "../src/model/edit";
import type { Json } from "../src/model/json";
import { comparisonOf } from "../src/session/comparison";
import { type Player, playerOf, Stopped } from "../src/session/player";
import type { Session } from "../src/session/session";
import { FakeView, fakeSession, lines, serve, settle } from "./fake_session";

globalThis.requestAnimationFrame = (run) => setTimeout(() => run(performance.now()), 1) as unknown as number;

const GRAPH: Json = {
  format: 1,
  parameters: { reach: { type: "number", default: 1, min: 0, max: 3 } },
  nodes: { out: { type: "export" } },
};

const line = (index: number): object => ({ index, parameters: {}, status: "done", model: { sha256: `step-${index}` } });
const failed = (index: number): object => ({
  ...{ index, parameters: {}, status: "failed" },
  errors: [{ code: "degenerate", detail: "no circle" }],
});

/** A server whose batch has these lines; a model is called like its step. */
function batch(items: readonly object[]): void {
  serve((address) => (address.includes("artifacts") ? new Response(address.split("/").at(-1)) : lines(items)));
}

function made(): { view: FakeView; session: Session; player: Player } {
  const view = new FakeView();
  const session = fakeSession(GRAPH, view);
  return { view, session, player: playerOf(session) };
}

async function until(test: () => boolean): Promise<void> {
  for (let turn = 0; turn < 400 && !test(); turn++) await new Promise((done) => setTimeout(done, 2));
  assert.ok(test());
}

test("a step that has no model is left out and said, and the others are played", async () => {
  batch([line(0), failed(1), line(2), line(3)]);
  const { view, player } = made();
  player.set({ mode: "once", speed: 60 });
  player.open("reach", 4);
  player.play();
  await until(() => !player.store.get().isPlaying);
  assert.deepEqual(view.shown, ["step-0", "step-2", "step-3"]);
  assert.match(player.store.get().error, /Step 2 cannot be shown\. no circle/);
  assert.deepEqual([player.store.get().ready, player.store.get().missing], [3, 1]);
});

test("where no step has a model nothing is played for ever", async () => {
  batch([failed(0), failed(1), failed(2)]);
  const { player } = made();
  player.open("reach", 3);
  player.play();
  await until(() => !player.store.get().isPlaying);
  assert.equal(player.store.get().missing, 3);
});

test("pictures that were made ahead are let go when the batch breaks off, and play asks again", async () => {
  serve((address) => {
    if (address.includes("artifacts")) return new Response(address.split("/").at(-1));
    const stopped = { status: "stopped", errors: [{ code: "x", detail: "The server stops." }] };
    return lines([line(1), line(2), stopped]);
  });
  const { view, player } = made();
  player.open("reach", 4);
  player.play();
  await until(() => player.store.get().error !== "");
  await settle();
  assert.equal(player.store.get().isPlaying, false);
  assert.deepEqual(view.shown, [], "the first step never came");
  assert.equal(view.left, 0);
  batch([line(0), line(1), line(2), line(3)]);
  player.set({ mode: "once", speed: 60 });
  player.play();
  await until(() => view.shown.length === 4);
  assert.equal(player.store.get().error, "");
});

test("only a graph that is evaluated otherwise ends the player", async () => {
  batch([line(0), line(1)]);
  const { session, player } = made();
  player.open("reach", 2);
  const { document } = session.store.get();
  assert.ok(document);
  session.store.set({ document: setTitle("Another")(document) });
  assert.equal(player.store.get().parameter, "reach");
  session.store.set({ document: rewritten(document, { nodes: {} }) });
  assert.equal(player.store.get().parameter, null);
});

test("a recording that is stopped says so by its kind, and leaves nothing playing", async () => {
  batch([line(0), line(1), line(2)]);
  const { view, player } = made();
  player.open("reach", 3);
  await until(() => player.store.get().ready === 3);
  const walk = player.walk(async () => player.pause());
  await assert.rejects(walk, Stopped);
  assert.equal(player.store.get().isPlaying, false);
  await assert.rejects(
    player.walk(() => Promise.reject(new Error("no picture"))),
    /no picture/,
  );
  assert.equal(player.store.get().isPlaying, false);
  assert.equal(view.left, 0);
});

test("there and back goes on in the direction in which it was paused", async () => {
  batch([line(0), line(1), line(2), line(3)]);
  const { view, player } = made();
  player.set({ mode: "swing", speed: 60 });
  player.open("reach", 4);
  player.play();
  // 0 1 2 3 2: on its way back.
  await until(() => view.shown.length === 5);
  player.pause();
  const shown = view.shown.length;
  player.play();
  await until(() => view.shown.length > shown);
  player.pause();
  const at = view.shown.slice(0, shown + 1).map((text) => Number(text.slice(-1)));
  assert.deepEqual(at.slice(0, 6), [0, 1, 2, 3, 2, 1]);
});

/** The answer of an evaluation. */
function model(text: string): Response {
  const part = (name: string, type: string, body: string): string =>
    `--x\r\nContent-Disposition: form-data; name="${name}"\r\nContent-Type: ${type}\r\n\r\n${body}\r\n`;
  const body = `${part("report", "application/json", "{}")}${part("model", "model/gltf-binary", text)}--x--\r\n`;
  return new Response(body, { headers: { "content-type": "multipart/form-data; boundary=x" } });
}

test("a change within a group ends a comparison, one of the drawing does not", async () => {
  serve(() => model("other"));
  const view = new FakeView();
  const session = fakeSession({ ...(GRAPH as object), format: 2, groups: { g: { nodes: {} } } } as Json, view);
  const comparison = comparisonOf(session);
  await comparison.open("Variant 1", {});
  assert.deepEqual(view.compared, ["other"]);
  const { document } = session.store.get();
  assert.ok(document);
  const titled = setTitle("Another")(document);
  session.store.set({ document: titled });
  assert.equal(comparison.store.get().name, "Variant 1");
  session.store.set({ document: rewritten(titled, { groups: { g: { nodes: { a: { type: "circle" } } } } }) });
  assert.equal(comparison.store.get().name, null);
});

test("what is compared and cannot be drawn says so, and a view that takes the place of another shows it again", async () => {
  serve(() => model("odd"));
  const view = new FakeView();
  view.broken.add("odd");
  const comparison = comparisonOf(fakeSession(GRAPH, view));
  await comparison.open("Variant 1", {});
  assert.deepEqual(comparison.store.get(), {
    ...{ name: "Variant 1", how: "beside", isLoading: false },
    error: "Variant 1 cannot be drawn.",
  });
  view.broken.clear();
  await comparison.open("Variant 1", {});
  const next = new FakeView();
  comparison.drawAgain(next.viewer);
  await settle();
  assert.deepEqual(next.compared, ["odd"]);
});
