import assert from "node:assert/strict";
import { test } from "node:test";
import { Evaluator, SETTLE_MILLISECONDS, type Stamp } from "../src/net/evaluator";
import { localProblem } from "../src/net/problem";
import { readReport } from "../src/net/report";
import type { Answer } from "../src/net/requests";
import { FakeClock } from "./fake_clock";
import { randomFrom } from "./random";

interface Setup {
  evaluate?: (body: number, quality: string) => number;
  decode?: (body: number) => number;
  answer?: (body: number, quality: string) => Answer;
}

function bodyOf(answer: Answer): number {
  return answer.kind === "model" ? (answer.model[0] ?? 0) : -1;
}

/** An evaluator whose server answers after the given times; bodies are numbers from 0 to 255. */
function setUp({ evaluate = () => 10, decode = () => 5, answer }: Setup = {}) {
  const clock = new FakeClock();
  const log = {
    shown: [] as (Stamp & { body: number })[],
    failed: [] as Stamp[],
    sent: [] as string[],
    budgets: [] as number[],
    away: 0,
    busy: false,
    most: 0,
    live: 0,
    aborted: 0,
  };
  const modelOf = (body: number): Answer => ({
    kind: "model",
    report: readReport({ model: { triangles: 1e6 } }),
    model: new Uint8Array([body]),
    preview: null,
  });
  const evaluator = new Evaluator<number, number>({
    async send(body, { quality, triangles }, signal) {
      log.sent.push(`${body} ${quality}`);
      if (quality === "draft") log.budgets.push(triangles);
      log.most = Math.max(log.most, ++log.live);
      let isOver = false;
      const aborted = new Promise<never>((_, reject) => {
        signal.addEventListener("abort", () => {
          if (!isOver) log.live--;
          isOver = true;
          log.aborted++;
          reject(new Error("aborted"));
        });
      });
      await Promise.race([clock.wait(evaluate(body, quality)), aborted]);
      if (!isOver) log.live--;
      isOver = true;
      return answer?.(body, quality) ?? modelOf(body);
    },
    async decode(received) {
      const body = bodyOf(received);
      await clock.wait(decode(body));
      return body;
    },
    show: (body, _, stamp) => log.shown.push({ ...stamp, body }),
    discard: () => undefined,
    fail: (_, stamp) => log.failed.push(stamp),
    away: () => log.away++,
    busy: (busy) => (log.busy = busy),
    clock,
  });
  return { clock, evaluator, log };
}

function assertNeverOlder(shown: Stamp[]): void {
  const ranks = shown.map((stamp) => 2 * stamp.revision + (stamp.quality === "final" ? 1 : 0));
  for (let i = 1; i < ranks.length; i++)
    assert.ok((ranks[i] ?? 0) > (ranks[i - 1] ?? 0), `shown in order: ${ranks.join()}`);
}

test("one input that does not move asks for the full quality at once", async () => {
  const { clock, evaluator, log } = setUp();
  evaluator.input(7, false);
  assert.equal(log.busy, true);
  await clock.advance(100);
  assert.deepEqual(log.sent, ["7 final"]);
  assert.deepEqual(log.shown, [{ revision: 1, quality: "final", body: 7 }]);
  assert.equal(log.busy, false);
});

test("while inputs move drafts are shown, and the full quality once they stop", async () => {
  const { clock, evaluator, log } = setUp();
  for (let body = 1; body <= 30; body++) {
    evaluator.input(body, true);
    await clock.advance(33);
  }
  assert.ok(log.shown.length >= 25, "a quick server keeps up");
  assert.ok(log.shown.every((item) => item.quality === "draft"));
  await clock.advance(SETTLE_MILLISECONDS + 50);
  assert.deepEqual(log.shown.at(-1), { revision: 30, quality: "final", body: 30 });
});

test("never more than two in flight, never an older picture, always the newest at the end", async () => {
  for (let seed = 1; seed <= 40; seed++) {
    const random = randomFrom(seed);
    const { clock, evaluator, log } = setUp({
      evaluate: (_, quality) => random(quality === "final" ? 400 : 150),
      decode: () => random(120),
    });
    const inputs = 20 + random(40);
    for (let body = 1; body <= inputs; body++) {
      evaluator.input(body, random(10) > 0);
      assert.ok(evaluator.inFlight <= 2);
      await clock.advance(random(90));
    }
    await clock.advance(3000);
    assert.ok(log.most <= 2, `seed ${seed}: ${log.most} in flight`);
    assertNeverOlder(log.shown);
    assert.deepEqual(log.shown.at(-1), { revision: inputs, quality: "final", body: inputs }, `seed ${seed}`);
    assert.equal(log.busy, false);
  }
});

test("a slow graph still shows drafts while a slider moves", async () => {
  const { clock, evaluator, log } = setUp({ evaluate: () => 80 });
  for (let body = 1; body <= 120; body++) {
    evaluator.input(body, true);
    await clock.advance(33);
  }
  assert.ok(log.shown.length > 40, `${log.shown.length} drafts shown`);
  assert.equal(log.aborted, 0);
});

test("a quick server has one request at a time", async () => {
  const { clock, evaluator, log } = setUp({ evaluate: () => 8, decode: () => 4 });
  for (let body = 1; body <= 60; body++) {
    evaluator.input(body, true);
    await clock.advance(5);
  }
  assert.equal(log.most, 1);
});

test("a full evaluation is dropped when the slider moves again", async () => {
  const { clock, evaluator, log } = setUp({ evaluate: (_, quality) => (quality === "final" ? 5000 : 10) });
  evaluator.input(1, true);
  await clock.advance(SETTLE_MILLISECONDS + 20);
  assert.deepEqual(log.sent, ["1 draft", "1 final"]);
  evaluator.input(2, true);
  await clock.advance(50);
  assert.equal(log.aborted, 1);
  assert.equal(log.shown.at(-1)?.body, 2);
});

test("a refused value is reported for the newest input only", async () => {
  const refuse: Setup["answer"] = (body) =>
    body === 2
      ? { kind: "problem", problem: localProblem("wrong", "") }
      : { kind: "model", report: readReport({}), model: new Uint8Array([body]), preview: null };
  const { clock, evaluator, log } = setUp({ answer: refuse });
  evaluator.input(1, false);
  await clock.advance(100);
  evaluator.input(2, true);
  await clock.advance(400);
  assert.deepEqual(log.failed.at(-1), { revision: 2, quality: "final" });
  assert.equal(log.shown.at(-1)?.body, 1);
  assert.equal(log.busy, false);
  evaluator.input(3, true);
  await clock.advance(400);
  assert.equal(log.shown.at(-1)?.body, 3);
});

test("a request the server dropped for a newer one is no failure", async () => {
  const answer: Setup["answer"] = (body) =>
    body === 1
      ? { kind: "problem", problem: { ...localProblem("superseded", ""), status: 409 } }
      : { kind: "model", report: readReport({}), model: new Uint8Array([body]), preview: null };
  const { clock, evaluator, log } = setUp({ answer });
  evaluator.input(1, true);
  evaluator.input(2, true);
  await clock.advance(1000);
  assert.equal(log.failed.length, 0);
  assert.equal(log.shown.at(-1)?.body, 2);
});

test("a server that is away is asked again until it answers, for the newest input", async () => {
  let isAway = true;
  const answer: Setup["answer"] = (body) =>
    isAway ? { kind: "away" } : { kind: "model", report: readReport({}), model: new Uint8Array([body]), preview: null };
  const { clock, evaluator, log } = setUp({ answer });
  evaluator.input(1, false);
  await clock.advance(2000);
  evaluator.input(2, true);
  await clock.advance(5000);
  assert.ok(log.away >= 3 && log.away < 12, `${log.away} tries`);
  assert.equal(log.busy, true);
  isAway = false;
  evaluator.resume();
  await clock.advance(1000);
  assert.deepEqual(log.shown.at(-1), { revision: 2, quality: "final", body: 2 });
  assert.equal(log.busy, false);
});

test("after a reset nothing of the old document is shown", async () => {
  const { clock, evaluator, log } = setUp({ evaluate: () => 50, decode: () => 50 });
  evaluator.input(1, true);
  await clock.advance(70);
  evaluator.reset();
  await clock.advance(500);
  assert.equal(log.shown.length, 0);
  evaluator.input(2, false);
  await clock.advance(500);
  assert.equal(log.shown.at(-1)?.body, 2);
});

test("drafts get coarser while round trips are slow, and finer while they are quick", async () => {
  const slow = setUp({ evaluate: () => 90 });
  for (let body = 1; body <= 60; body++) {
    slow.evaluator.input(body, true);
    await slow.clock.advance(33);
  }
  assert.equal(slow.log.budgets[0], 20_000);
  assert.equal(slow.log.budgets.at(-1), 1250);
  assert.ok(slow.log.budgets.every((budget, at) => at === 0 || budget <= (slow.log.budgets[at - 1] ?? 0)));
  const quick = setUp({ evaluate: () => 5, decode: () => 5 });
  for (let body = 1; body <= 60; body++) {
    quick.evaluator.input(body, true);
    await quick.clock.advance(33);
  }
  assert.equal(quick.log.budgets.at(-1), 320_000);
  const even = setUp({ evaluate: () => 30, decode: () => 5 });
  for (let body = 1; body <= 60; body++) {
    even.evaluator.input(body, true);
    await even.clock.advance(33);
  }
  assert.deepEqual(new Set(even.log.budgets), new Set([20_000]));
});

test("whatever happens, nothing older than what is shown is shown", async () => {
  for (let seed = 1; seed <= 60; seed++) {
    const random = randomFrom(seed);
    const answer: Setup["answer"] = (body) => {
      const kind = random(12);
      if (kind === 0) return { kind: "away", retryAfter: random(2) ? 100 + random(400) : undefined };
      if (kind === 1)
        return { kind: "problem", problem: { ...localProblem("wrong", ""), status: random(2) ? 422 : 409 } };
      return { kind: "model", report: readReport({}), model: new Uint8Array([body]), preview: null };
    };
    const { clock, evaluator, log } = setUp({ evaluate: () => random(200), decode: () => random(150), answer });
    let [lastReset, shownAtReset] = [0, 0];
    for (let body = 1; body <= 50; body++) {
      if (random(15) === 0) {
        evaluator.reset();
        lastReset = body - 1;
        shownAtReset = log.shown.length;
      }
      if (random(20) === 0) evaluator.resume();
      const revision = evaluator.input(body, random(4) > 0);
      assert.equal(revision, body);
      await clock.advance(random(120));
      assertNeverOlder(log.shown);
      const since = log.shown.slice(shownAtReset);
      assert.ok(
        since.every((stamp) => stamp.revision > lastReset),
        `seed ${seed}: nothing of the last document`,
      );
      assert.ok(evaluator.inFlight <= 2 && log.most <= 2, `seed ${seed}`);
    }
    await clock.advance(10_000);
    assertNeverOlder([...log.shown]);
    const newest = Math.max(log.shown.at(-1)?.revision ?? 0, log.failed.at(-1)?.revision ?? 0);
    assert.equal(newest, 50, `seed ${seed}: the newest input has its answer`);
  }
});
