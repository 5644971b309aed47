import assert from "node:assert/strict";
import { test } from "node:test";
import { fineRatio, Rest } from "../src/view3d/rest";
import { FakeClock } from "./fake_clock";

function resting(isNeeded = true) {
  const clock = new FakeClock();
  const seen = { fine: 0, still: false };
  const rest: Rest = new Rest(isNeeded, {
    setTimeout: (run, milliseconds) => clock.setTimeout(run, milliseconds) as number,
    clearTimeout: (timer) => clock.clearTimeout(timer),
    drawFine: () => {
      seen.fine++;
      rest.drawn(true);
    },
    mark: (isStill) => (seen.still = isStill),
  });
  return { clock, seen, rest };
}

test("a picture that rests is drawn finely once, and never again", async () => {
  const { clock, seen, rest } = resting();
  rest.changed();
  rest.drawn(false);
  assert.equal(seen.still, false);
  await clock.advance(10_000);
  assert.deepEqual(seen, { fine: 1, still: true });
});

test("while something moves nothing is drawn finely", async () => {
  const { clock, seen, rest } = resting();
  for (let step = 0; step < 20; step++) {
    rest.changed();
    rest.drawn(false);
    await clock.advance(100);
  }
  assert.deepEqual(seen, { fine: 0, still: false });
  await clock.advance(100);
  assert.deepEqual(seen, { fine: 1, still: true });
});

test("an evaluation is waited for", async () => {
  const { clock, seen, rest } = resting();
  rest.setBusy(true);
  rest.drawn(false);
  await clock.advance(5000);
  assert.equal(seen.fine, 0);
  rest.setBusy(false);
  await clock.advance(200);
  assert.equal(seen.fine, 1);
  rest.setBusy(true);
  rest.setBusy(false);
  await clock.advance(5000);
  assert.equal(seen.fine, 1, "nothing was drawn in between");
});

test("with a GPU every picture is fine", async () => {
  const { clock, seen, rest } = resting(false);
  rest.changed();
  rest.drawn(false);
  assert.deepEqual(seen, { fine: 0, still: true });
  await clock.advance(5000);
  assert.equal(seen.fine, 0);
});

test("a picture has twice the pixels, a large one fewer", () => {
  assert.equal(fineRatio(700, 500), 2);
  assert.ok(fineRatio(1920, 1080) < 1.5 && fineRatio(1920, 1080) > 1.3);
  assert.equal(fineRatio(4000, 3000), 1);
  assert.equal(fineRatio(0, 0), 2);
});
