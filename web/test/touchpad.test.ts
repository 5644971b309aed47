import assert from "node:assert/strict";
import { test } from "node:test";
import { TouchpadSense } from "../src/graph/touchpad";

const event = (deltaX: number, deltaY: number, timeStamp: number, more = {}) => ({
  ...{ deltaX, deltaY, timeStamp, deltaMode: 0, ctrlKey: false, metaKey: false },
  ...more,
});

test("notches of a wheel zoom, steps of fingers move, and large ones that follow them do too", () => {
  const sense = new TouchpadSense();
  assert.ok(!sense.moves(event(0, 120, 0)));
  assert.ok(!sense.moves(event(0, 240, 50)));
  assert.ok(sense.moves(event(0, 3, 1000)));
  assert.ok(sense.moves(event(0, 180, 1050)), "swinging out");
  assert.ok(!sense.moves(event(0, 100, 2000)), "later it is a wheel again");
  assert.ok(sense.moves(event(24, 100, 3000)), "no wheel goes sideways");
  assert.ok(!sense.moves(event(0, 3, 4000, { ctrlKey: true })), "a pinch");
  assert.ok(!sense.moves(event(0, 3, 5000, { deltaMode: 1 })), "lines are told by wheels");
});
