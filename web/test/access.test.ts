// Requests to a server that has a token.

import assert from "node:assert/strict";
import { test } from "node:test";
import { access, giveToken, send } from "../src/net/access";
import { fetchSensitivity } from "../src/net/api";

const TOKEN = "right";
let asked: string[] = [];

/** Answers 200 to whoever has the token, once it has been asked for `patience` times. */
function guarded(): void {
  asked = [];
  globalThis.fetch = async (address, request) => {
    request?.signal?.throwIfAborted();
    const given = new Headers(request?.headers).get("authorization") ?? "";
    asked.push(`${address} ${given}`);
    if (given === "Bearer locked") return new Response(`{"code": "too-many-wrong-tokens"}`, { status: 429 });
    return new Response("ok", { status: given === `Bearer ${TOKEN}` ? 200 : 401 });
  };
}

const pause = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

test("the time that a person takes to find the token is not the server's", async () => {
  guarded();
  const answer = send("v1/graphs", {}, 20);
  await pause(60);
  assert.equal(access.get().isWanted, true);
  assert.equal(access.get().isWrong, false);
  giveToken("wrong");
  await pause(5);
  assert.deepEqual(access.get(), { isWanted: true, isWrong: true, isLocked: false });
  giveToken("locked");
  await pause(5);
  assert.equal(access.get().isLocked, true);
  giveToken(TOKEN);
  assert.equal((await answer).status, 200);
  assert.equal(access.get().isWanted, false);
});

test("what a parameter moves is asked for with the token as well", async () => {
  guarded();
  await fetchSensitivity({ graph: {}, parameters: {}, by: ["a"] }, new AbortController().signal);
  assert.deepEqual(asked, [`v1/gradient Bearer ${TOKEN}`]);
});
