import assert from "node:assert/strict";
import { test } from "node:test";
import { finest, inOrderOfFigures, readExample } from "../src/session/examples";

test("examples are listed by figure, then those that are none as the server gave them", () => {
  const given = ["", "10", "2", "", "12", "5"].map((figure, at) => readExample({ id: `e${at}`, figure }));
  const listed = inOrderOfFigures(given);
  assert.deepEqual(
    listed.map(({ id }) => id),
    ["e2", "e5", "e1", "e4", "e0", "e3"],
  );
  assert.equal(finest(listed)?.id, "e5");
});
