// Habits of hands from other programs: units typed behind numbers, bars filled from zero, panes put where they are wanted.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, choose, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { canvasOf, eventually, saved, settled, still } from "./harness.mjs";

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

test("the rows of the form are put in another order by dragging and by keys, each in one step", () =>
  withEditor(used, SIZE, async (page) => {
    const labels = () => page.locator(".parameter-label").allTextContents();
    const before = await eventually(labels, (list) => list.length === 3);
    const grip = (label) => page.getByRole("button", { name: `Move ${label}`, exact: true });
    const [first, second, third] = before;
    const box = await still(grip(first));
    const last = await still(grip(third));
    await page.mouse.move(box.x + 8, box.y + 12);
    await page.mouse.down();
    await page.mouse.move(box.x + 8, last.y + 60, { steps: 12 });
    await page.mouse.up();
    await eventually(labels, [second, third, first]);
    await page.getByRole("button", { name: "Undo" }).click();
    await eventually(labels, before);
    await grip(third).focus();
    await page.keyboard.press("ArrowUp");
    await eventually(labels, [first, third, second]);
    await page.waitForFunction((name) => document.activeElement?.ariaLabel === name, `Move ${third}`);
    await page.keyboard.press("ArrowUp");
    await eventually(labels, [third, first, second]);
  }));

test("a view that is kept is the one that the graph opens with", () =>
  withEditor(used, SIZE, async (page) => {
    const eye = () => canvasOf(page).getAttribute("data-eye");
    const near = (wanted) => (place) =>
      place.split(",").every((part, axis) => Math.abs(Number(part) - Number(wanted.split(",")[axis])) < 1e-3);
    const home = await eye();
    await canvasOf(page).press("ArrowLeft");
    const turned = await eventually(eye, (place) => place !== home);
    await page.getByRole("button", { name: "Keep this view" }).click();
    await page.getByRole("button", { name: "Front", exact: true }).click();
    await eventually(eye, (place) => !near(turned)(place));
    await page.getByRole("button", { name: "Home view" }).click();
    await eventually(eye, near(turned));
    await page.reload();
    await settled(page);
    await eventually(eye, near(turned));
    await page
      .getByText("edited", { exact: true })
      .or(page.getByText("draft", { exact: true }))
      .waitFor();
  }));

test("opening an example shows its form", () =>
  withEditor(used, SIZE, async (page) => {
    await page.getByRole("tab", { name: "Problems" }).click();
    await page.getByRole("button", { name: "New graph" }).click();
    await page.getByText("An empty graph").waitFor();
    await page.getByRole("tab", { name: "Controls", selected: true }).waitFor();
  }));

test("variants of the form's values are kept in the document with their pictures, and brought back by a press", () =>
  withEditor(used, SIZE, async (page) => {
    const value = page.getByRole("textbox", { name: "Reach value", exact: true });
    const before = await value.inputValue();
    const variants = page.getByRole("region", { name: "Variants" });
    await variants.getByRole("button", { name: "Keep as a variant" }).click();
    await value.fill("1.75");
    await value.press("Enter");
    await variants.getByRole("button", { name: "Keep as a variant" }).click();
    const name = variants.getByRole("textbox", { name: "Name of Variant 2" });
    await name.fill("Far");
    await name.press("Enter");
    await eventually(() => variants.locator("li img").count(), 2);
    await variants.getByRole("button", { name: "Use Variant 1" }).click();
    await eventually(() => value.inputValue(), before);
    await variants.getByRole("button", { name: "Use Far", exact: true }).click();
    await eventually(() => value.inputValue(), "1.75");
    const json = await saved(page);
    assert.deepEqual(
      json.ui.variants.map(({ name: called, values }) => [called, values]),
      [
        ["Variant 1", {}],
        ["Far", { reach: 1.75 }],
      ],
    );
    await variants.getByRole("button", { name: "Delete Far" }).click();
    await page.getByRole("button", { name: "Undo" }).click();
    await variants.getByRole("button", { name: "Use Far", exact: true }).waitFor();
  }));

test("a link is seen as whoever shared it saw the graph", () =>
  withEditor(used, SIZE, async (page) => {
    const eye = (from) => canvasOf(from).getAttribute("data-eye");
    const home = await eye(page);
    await canvasOf(page).press("ArrowLeft");
    const turned = await eventually(
      () => eye(page),
      (place) => place !== home,
    );
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("menuitem", { name: "Link to this graph…" }).click();
    const link = page.getByRole("dialog", { name: "Share" }).getByRole("textbox", { name: "Link" });
    const { hash } = new URL(await link.inputValue());
    const numbers = (place) => place.split(",").map(Number);
    await withEditor(used, { ...SIZE, hash }, (other) =>
      eventually(
        () => eye(other),
        (place) => numbers(place).every((value, axis) => Math.abs(value - numbers(turned)[axis]) < 0.01),
      ),
    );
  }));
