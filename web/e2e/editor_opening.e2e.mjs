// What is seen first: a graph at a size at which it can be read, and what is said to someone new.

import assert from "node:assert/strict";
import { test } from "node:test";
import { useServer, withCleanPage } from "./fixture.mjs";
import { eventually, settled, still } from "./harness.mjs";

const used = useServer();

const withPage = (options, run) =>
  withCleanPage(used, options, async (page) => {
    await settled(page);
    await run(page);
  });

const graph = (page) => page.getByRole("region", { name: "Graph" });
const map = (page) => page.getByRole("img", { name: "Map of the graph" });

/** In the page: how many nodes are wholly in the pane, of how many, and how high their letters are. */
const inSight = () => {
  const pane = document.querySelector(".graph-pane").getBoundingClientRect();
  const boxes = [...document.querySelectorAll(".react-flow__node")].map((node) => node.getBoundingClientRect());
  return boxes.filter(
    ({ left, top, right, bottom }) =>
      left >= pane.left && top >= pane.top && right <= pane.right && bottom <= pane.bottom,
  ).length;
};

const zoom = (page) =>
  page.locator(".react-flow__viewport").evaluate((element) => new DOMMatrix(getComputedStyle(element).transform).a);

test("a wide graph opens at the nodes that its form drives, large enough to be read", () =>
  withPage({ hash: "#example=fig05_twisted_ring" }, async (page) => {
    const count = await page.locator(".react-flow__node").count();
    await eventually(
      () => page.evaluate(inSight),
      (seen) => seen >= 2 && seen < count,
      `some of ${count} nodes in sight`,
    );
    await eventually(
      () => zoom(page),
      (value) => value >= 0.899 && value <= 1.001,
    );
    const driven = await still(page.locator(".react-flow__node:has(.row-parameter)").last());
    const pane = await still(graph(page));
    assert.ok(driven.x > pane.x && driven.x + driven.width < pane.x + pane.width, "a driven node is in sight");
    await graph(page).getByRole("button", { name: "Fit graph" }).click();
    await eventually(() => page.evaluate(inSight), count, "everything in sight");
    // A map would cover nodes of a graph of this size.
    assert.equal(await map(page).count(), 0);
  }));

test("a graph that is readable as a whole needs no map", () =>
  withPage({ hash: "#example=fig02_boosted_circle", width: 3600, height: 1200 }, async (page) => {
    await page.locator(".react-flow__node").first().waitFor();
    await map(page).waitFor({ state: "detached" });
    await eventually(() => page.evaluate(inSight), await page.locator(".react-flow__node").count());
  }));

test("what is said to someone new covers neither graph nor model nor form", async () => {
  for (const size of [
    { width: 1280, height: 720 },
    { width: 800, height: 900 },
  ]) {
    await withPage({ firstRun: true, ...size }, async (page) => {
      const hint = page.getByRole("complementary", { name: "How to begin" });
      await hint.waitFor();
      const [box, work] = [await still(hint), await still(page.getByRole("main"))];
      assert.ok(
        box.y >= work.y + work.height - 1,
        `the panes end at ${work.y + work.height}, the hint begins at ${box.y}`,
      );
      assert.ok(box.x >= 0 && box.x + box.width <= size.width);
      await hint.getByRole("button", { name: "Begin an empty graph" }).click();
      await hint.waitFor({ state: "detached" });
    });
  }
});
