// The page speaks in words: titles for names, other words for nodes, ranges for colors, values for parameters.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, at, choose, drag, middle, node, output, pane, untilGraph, withEditor } from "./editing.mjs";
import { RING, useServer } from "./fixture.mjs";
import { eventually, saved, settled, still } from "./harness.mjs";

const used = useServer();
const large = { width: 1440, height: 900 };

test("a node is found by another word, which is shown beside its title", () =>
  withEditor(used, { isEmpty: true, ...large }, async (page) => {
    const place = await at(page, 300, 260);
    await page.mouse.dblclick(place.x, place.y);
    const search = page.getByRole("combobox", { name: "Add a node" });
    await search.fill("donut");
    await page.getByRole("option", { name: /Torus mesh.*donut/ }).waitFor();
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.torus_mesh);
  }));

test("a wire that is let go lists first what such wires mostly lead to", () =>
  withEditor(used, { isEmpty: true, ...large }, async (page) => {
    await addNode(page, "point pair", 200, 200);
    await drag(page, await middle(output(page, "point_pair", "generator")), await at(page, 420, 420));
    const options = page.getByRole("dialog", { name: "Add a node" }).getByRole("option");
    await eventually(
      () => options.first().textContent(),
      (text) => text.startsWith("Boost"),
    );
  }));

test("a new warp stays finite near its pair, and older documents are left as they are", () =>
  withEditor(used, { isEmpty: true, ...large }, async (page) => {
    const warp = await addNode(page, "warp", 420, 260);
    await untilGraph(page, ({ nodes }) => nodes[warp].inputs.softening === 0.5);
  }));

test("colors that a node gives have a legend in the shaded view, with the range that was found", () =>
  withEditor(used, { hash: RING, ...large }, async (page) => {
    const legend = page.getByRole("group", { name: /^Colors of Curvature color/ });
    await legend.getByText(/^On the model: -[\d.]+ to -?[\d.]+/).waitFor();
    await page.getByRole("radio", { name: "Normals" }).click();
    await legend.waitFor({ state: "detached" });
    await page.getByRole("radio", { name: "Shaded" }).click();
    await legend.waitFor();
  }));

test("an exposed input shows its value on the node, and parameters stand in groups", () =>
  withEditor(used, { hash: RING, ...large }, async (page) => {
    const slider = page.getByRole("slider", { name: "Reach" });
    await slider.press("Home");
    const value = await slider.getAttribute("aria-valuenow");
    await eventually(
      () => page.locator(".row-parameter-value").allTextContents(),
      (texts) => texts.includes(value),
    );
    const names = await page
      .locator(".parameter-rows [data-parameter]")
      .evaluateAll((rows) => rows.map((row) => row.dataset.parameter));
    const last = names.at(-1);
    await page
      .locator(`[data-parameter="${last}"]`)
      .getByRole("button", { name: /^Settings of/ })
      .click();
    const group = page.getByRole("textbox", { name: "Group" });
    await group.fill("Shape");
    await group.press("Enter");
    await page.getByRole("heading", { name: "Shape" }).waitFor();
    const document = await saved(page);
    assert.deepEqual(document.ui.parameters, { [last]: { group: "Shape" } });
    await page.keyboard.press("Control+z");
    await page.getByRole("heading", { name: "Shape" }).waitFor({ state: "detached" });
  }));

test("two fingers move the canvas, a pinch zooms it, and so does the wheel of a mouse", () =>
  withEditor(used, { hash: RING, ...large }, async (page) => {
    const viewport = pane(page).locator(".react-flow__viewport");
    const view = async () => {
      const { transform } = await still(viewport);
      const [, x, y, zoom] = /translate\(([-\d.]+)px, ([-\d.]+)px\) scale\(([\d.]+)\)/.exec(transform);
      return { x: Number(x), y: Number(y), zoom: Number(zoom) };
    };
    const place = await at(page, 40, 600);
    await page.mouse.move(place.x, place.y);
    const first = await view();
    await page.mouse.wheel(0, 240);
    const before = await eventually(view, ({ zoom }) => zoom < first.zoom);
    await page.mouse.wheel(30, 12);
    const moved = await eventually(view, ({ x }) => x !== before.x);
    const { x, y, zoom } = before;
    assert.deepEqual(
      [moved.x - x + 30, moved.y - y + 12].map((off) => Math.abs(off) < 0.01),
      [true, true],
    );
    assert.equal(moved.zoom, zoom);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, -20);
    await page.keyboard.up("Control");
    await eventually(view, (now) => now.zoom > zoom);
  }));

test("what is given wires only is a pill with its title, which opens to its inputs and closes again", () =>
  withEditor(used, { hash: RING, ...large }, async (page) => {
    const pills = pane(page).locator('.node[data-pill="true"]');
    await eventually(
      () => pills.count(),
      (count) => count > 0,
    );
    const pill = pills.first();
    const id = await pill.evaluate((item) => item.closest(".react-flow__node").dataset.id);
    const box = await still(node(page, id));
    const zoom = await pane(page)
      .locator(".react-flow__viewport")
      .evaluate((item) => Number(/scale\(([\d.]+)\)/.exec(item.style.transform)[1]));
    assert.ok(Math.abs(box.width / zoom - 140) < 1 && Math.abs(box.height / zoom - 28) < 1, JSON.stringify(box));
    await node(page, id)
      .getByRole("button", { name: /^Show the inputs of/ })
      .click();
    await node(page, id).getByRole("button", { name: "Title only" }).click();
    await eventually(() => node(page, id).locator(".node").getAttribute("data-pill"), "true");
  }));

test("where the keys go is marked in another color than what is selected", () =>
  withEditor(used, { hash: RING, ...large }, async (page) => {
    await choose(page, "skin");
    const colors = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      return [style.getPropertyValue("--focus"), style.getPropertyValue("--accent")];
    });
    assert.notEqual(colors[0], colors[1]);
    await page.keyboard.press("Tab");
    const outline = () =>
      page.evaluate(() => {
        const probe = document.createElement("i");
        probe.style.color = "var(--focus)";
        document.body.append(probe);
        const wanted = getComputedStyle(probe).color;
        probe.remove();
        const focused = document.activeElement;
        const drawn = focused.matches(".react-flow__node") ? focused.querySelector(".node") : focused;
        return getComputedStyle(drawn).outlineColor === wanted;
      });
    await eventually(outline, true, "a ring in the color of the focus");
  }));

test("in the light theme the examples have light pictures", () =>
  withEditor(used, { hash: RING, theme: "light", ...large }, async (page) => {
    await page.getByRole("button", { name: "Examples" }).click();
    const dialog = page.getByRole("dialog", { name: "Examples" });
    await dialog.locator(".card-light img").first().waitFor();
    const sizes = await dialog
      .locator(".card-light:has(img)")
      .first()
      .evaluate((item) => [item.querySelector(".graph-picture"), item.parentElement].map((one) => one.clientWidth));
    assert.equal(sizes[0], sizes[1], "the whole card");
  }));

test("at 200 % zoom everything can be reached without scrolling sideways", () =>
  withEditor(used, { hash: RING, width: 720, height: 450 }, async (page) => {
    await settled(page);
    await eventually(() => page.evaluate(() => document.documentElement.scrollWidth), 720);
    const bar = await page.locator(".top-bar").evaluate((item) => [item.scrollWidth, item.clientWidth]);
    assert.equal(bar[0], bar[1], "the top bar has room for all of its buttons");
    for (const name of ["Graph", "Examples", "Model"]) {
      await page.getByRole("tablist", { name: "Panes" }).getByRole("tab", { name }).click();
      await eventually(() => page.evaluate(() => document.documentElement.scrollWidth), 720);
    }
  }));
