// Habits of hands from other programs: units typed behind numbers, bars filled from zero, panes put where they are wanted.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, choose, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, settled, still } from "./harness.mjs";

const RING = "#example=fig04_boosted_ring";
const used = useServer();
const SIZE = { hash: RING, width: 1500, height: 900 };

test("a number is typed with its unit, and a unit that does not fit is told in words at its field", () =>
  withEditor(used, SIZE, async (page) => {
    const height = page.getByRole("textbox", { name: "Height value", exact: true });
    await height.fill("45 cm");
    await height.press("Enter");
    await eventually(() => height.inputValue(), "0.45");
    await settled(page);
    await height.fill("90 deg");
    await height.press("Enter");
    const alert = page.getByRole("alert");
    await alert.filter({ hasText: "“90 deg” is an angle; a length in m is needed." }).waitFor();
    assert.equal(await alert.count(), 1, "only the one field that is wrong is told");
  }));

test("a bar whose range crosses zero is filled from there", () =>
  withEditor(used, { ...SIZE, isEmpty: true }, async (page) => {
    await addNode(page, "-2<-1<2", 200, 200);
    await page.getByRole("tab", { name: "Controls" }).click();
    const slider = page.getByRole("tabpanel").getByRole("slider");
    const filled = () =>
      slider.evaluate((bar) => ["--from", "--to", "--at"].map((name) => Number(bar.style.getPropertyValue(name))));
    await eventually(filled, [0.25, 0.5, 0.25]);
    await slider.locator(".zero-tick").waitFor();
  }));

test("the graph is put below the model over the whole width, and stays there over a reload", () =>
  withEditor(used, SIZE, async (page) => {
    const graph = page.getByRole("region", { name: "Graph" });
    const model = page.getByRole("region", { name: "Model" });
    assert.ok((await still(graph)).width < 1000);
    await page.getByRole("button", { name: "Graph below the model" }).click();
    const isBelow = async () => {
      const [below, above] = [await still(graph), await still(model)];
      return below.width > 1490 && below.y >= above.y + above.height - 1;
    };
    await eventually(isBelow, true);
    await settled(page);
    await page.reload();
    await settled(page);
    await eventually(isBelow, true);
    await page.getByRole("button", { name: "Graph beside the model" }).click();
    await eventually(isBelow, false);
  }));

test("selected nodes are aligned and distributed in one step, and Alt and a press preview a node", () =>
  withEditor(used, { ...SIZE, isEmpty: true }, async (page) => {
    const names = [];
    for (const [x, y] of [
      [160, 120],
      [200, 330],
      [170, 600],
    ]) {
      names.push(await addNode(page, "point", x, y));
      await page.keyboard.press("Escape");
    }
    const [first, ...others] = names;
    await choose(page, first);
    for (const id of others) await choose(page, id, ["Shift"]);
    const edit = async (item) => {
      await page.getByRole("button", { name: "Edit", exact: true }).click();
      await page.getByRole("menuitem", { name: item }).click();
    };
    await edit("Align left edges");
    const boxes = async () => Promise.all(names.map((id) => still(page.locator(`.react-flow__node[data-id="${id}"]`))));
    await eventually(boxes, (all) => all.every(({ x }) => Math.abs(x - all[0].x) < 1));
    await edit("Distribute downward");
    await eventually(boxes, ([a, b, c]) => Math.abs(b.y - a.y - a.height - (c.y - b.y - b.height)) < 2);
    await page.keyboard.down("Alt");
    const box = await still(page.locator(`.react-flow__node[data-id="${first}"]`));
    await page.mouse.click(box.x + 40, box.y + 12);
    await page.keyboard.up("Alt");
    await eventually(
      () => page.locator(`.react-flow__node[data-id="${first}"] .node-eye`).getAttribute("aria-pressed"),
      "true",
    );
  }));
