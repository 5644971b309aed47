// Working on the canvas: selecting, moving, copying, flags, frames and notes, finding one's way.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addNode,
  at,
  canvasReady,
  choose,
  drag,
  node,
  output,
  pane,
  placeOf,
  said,
  undo,
  untilApart,
  untilGraph,
  untilSelected,
  wire,
  withEditor,
} from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { covered, eventually, openPage, settled, still, wholeGraph } from "./harness.mjs";

const RING = "#example=fig04_boosted_ring";
const used = useServer();

const large = { width: 1500, height: 900 };
const empty = (run) => withEditor(used, { isEmpty: true, ...large }, run);
const ring = (run, options = {}) => withEditor(used, { hash: RING, ...large, ...options }, run);

/** What Ctrl+C puts on the clipboard. */
async function copied(page) {
  await page.evaluate(() => navigator.clipboard.writeText(""));
  await page.keyboard.press("Control+c");
  return eventually(async () => JSON.parse(await page.evaluate(() => navigator.clipboard.readText())), Boolean);
}

test("a left drag draws a box that selects, the selection moves together in one step of undo", () =>
  empty(async (page) => {
    await addNode(page, "circle", 150, 200);
    await addNode(page, "line", 420, 200);
    await addNode(page, "sphere mesh", 420, 600);
    await drag(page, await at(page, 20, 60), await at(page, 540, 420));
    await untilSelected(page, ["circle", "line"]);
    const before = [await placeOf(page, "circle"), await placeOf(page, "line")];
    await drag(page, { x: before[0].x + 60, y: before[0].y + 12 }, { x: before[0].x + 140, y: before[0].y + 72 });
    /** How far both have moved. */
    const moved = async () => {
      const after = [await placeOf(page, "circle"), await placeOf(page, "line")];
      return after.flatMap((box, index) => [box.x - before[index].x, box.y - before[index].y]);
    };
    await eventually(moved, (way) => way.every((part, index) => Math.abs(part - [80, 60][index % 2]) < 8));
    await undo(page);
    await eventually(moved, (way) => way.every((part) => Math.abs(part) < 1));
    await choose(page, "circle");
    await choose(page, "sphere_mesh", ["Shift"]);
    await page.keyboard.press("Control+a");
    await untilSelected(page, ["circle", "line", "sphere_mesh"]);
    await page.keyboard.press("Escape");
    await untilSelected(page, []);
  }));

test("middle and right button and Space move the canvas, the wheel zooms where the pointer is, a setting swaps the left", () =>
  ring(async (page) => {
    const [from, to] = [await at(page, 300, 700), await at(page, 360, 740)];
    const viewport = async () => (await still(page.locator(".react-flow__viewport"))).transform;
    const moves = async (what, act) => {
      const before = await viewport();
      await act();
      await eventually(viewport, (after) => after !== before, `a canvas moved with ${what}`);
    };
    for (const button of ["middle", "right"]) {
      await moves(button, async () => {
        await page.mouse.move(from.x, from.y);
        await page.mouse.down({ button });
        await page.mouse.move(to.x, to.y, { steps: 4 });
        await page.mouse.up({ button });
      });
      assert.equal(await page.getByRole("menu").count(), 0, "a drag is no press");
    }
    await moves("Space", async () => {
      await page.mouse.move(from.x, from.y);
      await page.keyboard.down("Space");
      await drag(page, from, to);
      await page.keyboard.up("Space");
    });
    assert.equal(await page.getByRole("dialog").count(), 0, "Space with a drag opens no search");
    await moves("wheel", () => page.mouse.wheel(0, -200));
    await page.mouse.click(from.x, from.y, { button: "right" });
    await page.getByRole("menuitem", { name: "Left drag moves the canvas" }).click();
    await moves("left", () => drag(page, from, to));
    await page.mouse.move(from.x, from.y);
    await page.keyboard.press("Home");
    const area = await still(pane(page));
    const outside = () =>
      pane(page)
        .locator(".node")
        .evaluateAll(
          (list, { x, width }) =>
            list
              .map((item) => item.getBoundingClientRect().toJSON())
              .filter(({ left, right }) => left < x || right > x + width),
          area,
        );
    await eventually(outside, [], "Home shows everything");
  }));

test("nodes are copied as JSON, pasted, cut and duplicated; Ctrl+Shift+V keeps the wires that come in", () =>
  empty(async (page) => {
    await addNode(page, "circle", 130, 160);
    await addNode(page, "boost", 430, 160);
    await wire(page, "circle", "circle", "boost", "shape");
    await untilGraph(page, ({ nodes }) => nodes.boost.inputs.shape);
    await choose(page, "boost");
    const clip = await copied(page);
    assert.deepEqual(Object.keys(clip.nodes), ["boost"]);
    const place = await at(page, 300, 500);
    await page.mouse.move(place.x, place.y);
    await page.keyboard.press("Control+v");
    await untilGraph(page, ({ nodes }) => nodes.boost_2 && !nodes.boost_2.inputs.shape);
    await page.keyboard.press("Control+Shift+v");
    await untilGraph(page, ({ nodes }) => nodes.boost_3?.inputs.shape?.from === "circle");
    await page.keyboard.press("Control+d");
    await untilGraph(page, ({ nodes }) => nodes.boost_4?.inputs.shape?.from === "circle");
    await page.keyboard.press("Control+x");
    await untilGraph(page, ({ nodes }) => !nodes.boost_4);
    // Without keys: the Edit menu.
    await choose(page, "circle");
    await page.getByRole("button", { name: "Edit", exact: true }).click();
    await page.getByRole("menuitem", { name: "Duplicate" }).click();
    await untilGraph(page, ({ nodes }) => nodes.circle_2);
    await node(page, "circle_2").waitFor();
    await untilApart(page);
  }));

test("undo and redo bring back graph and picture, by keys and buttons, and leave flags of previews alone", () =>
  ring(async (page) => {
    await choose(page, "skin");
    await page.keyboard.press("v");
    await page.locator('[data-id="skin"] .node-eye[aria-pressed="true"]').waitFor();
    await page.keyboard.press("Escape");
    await settled(page);
    const before = JSON.stringify(page.graph().nodes);
    await choose(page, "boosted");
    await page.keyboard.press("Delete");
    await page.waitForFunction(() => document.documentElement.dataset.state === "error");
    await page.keyboard.press("Control+z");
    await settled(page);
    await untilGraph(page, ({ nodes }) => JSON.stringify(nodes) === before);
    await page.locator('[data-id="skin"] .node-eye[aria-pressed="true"]').waitFor();
    await covered(page, 0.03);
    await page.keyboard.press("Control+Shift+z");
    await untilGraph(page, ({ nodes }) => !nodes.boosted);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+y");
    await untilGraph(page, ({ nodes }) => !nodes.boosted);
    await page.getByRole("button", { name: "Undo" }).click();
    await untilGraph(page, ({ nodes }) => JSON.stringify(nodes) === before);
    await page.getByRole("button", { name: "Redo" }).click();
    await untilGraph(page, ({ nodes }) => !nodes.boosted);
  }));

test("M bypasses a node, which is marked with a dashed line, and the first input passes through", () =>
  ring(async (page) => {
    const id = Object.entries(page.graph().nodes).find(([, item]) => item.inputs.amount)[0];
    await choose(page, id);
    await page.keyboard.press("m");
    await untilGraph(page, ({ nodes }) => nodes[id].bypass === true);
    await page.locator(`[data-id="${id}"] .node[data-bypass="true"]`).waitFor();
    const passed = page.locator(".react-flow__edge.wire-passed .react-flow__edge-path").first();
    await eventually(
      () => passed.evaluate((path) => getComputedStyle(path).strokeDasharray),
      (dash) => dash !== "none",
    );
    await page.keyboard.press("m");
    await untilGraph(page, ({ nodes }) => nodes[id].bypass === undefined);
    await settled(page);
  }));

test("a frame has a title and moves its members; a note holds text; markup in them is text", () =>
  empty(async (page) => {
    await addNode(page, "circle", 200, 200);
    await addNode(page, "line", 200, 500);
    await choose(page, "circle");
    await page.keyboard.press("Control+j");
    await page.getByRole("textbox", { name: "Title of the frame" }).fill("<img src=x onerror=alert(1)>");
    await page.keyboard.press("Enter");
    const frame = pane(page).getByRole("group", { name: /^Frame <img/ });
    const box = await still(frame);
    const before = await placeOf(page, "circle");
    await drag(page, { x: box.x + 120, y: box.y + 14 }, { x: box.x + 320, y: box.y + 34 });
    await eventually(
      () => placeOf(page, "circle"),
      (after) => Math.abs(after.x - before.x - 200) < 8,
      "a member that moves along",
    );
    const place = await at(page, 520, 560);
    await page.mouse.move(place.x, place.y);
    await page.keyboard.press("Escape");
    await untilSelected(page, []);
    await page.keyboard.press("n");
    await page.getByRole("textbox", { name: "Text of the note" }).fill("<b>bold</b> & more");
    await page.keyboard.press("Escape");
    await page.getByText("<b>bold</b> & more").waitFor();
    assert.equal(await page.locator(".note b, .frame img").count(), 0);
    await page.keyboard.press("Control+a");
    await eventually(() => page.locator(".react-flow__node.selected").count(), 4);
    const clip = await copied(page);
    assert.equal(clip.ui.frames[0].title, "<img src=x onerror=alert(1)>");
    assert.equal(clip.ui.notes[0].text, "<b>bold</b> & more");
    // The frame goes, its nodes stay.
    await page.keyboard.press("Escape");
    await untilSelected(page, []);
    await frame.click({ position: { x: 120, y: 12 } });
    await eventually(() => page.locator(".react-flow__node-frame.selected").count(), 1);
    await page.keyboard.press("Delete");
    await frame.waitFor({ state: "detached" });
    await node(page, "circle").waitFor();
  }));

test("menus open with the right button on canvas, node and wire, and name their keys", () =>
  ring(async (page) => {
    const open = async (place, name) => {
      await page.mouse.click(place.x, place.y, { button: "right" });
      const menu = page.getByRole("menu", { name });
      await menu.waitFor();
      return menu;
    };
    const box = await placeOf(page, "skin");
    const menu = await open({ x: box.x + 30, y: box.y + 10 }, "Node menu");
    await untilSelected(page, ["skin"]);
    for (const name of ["Bypass", "Rename", "Duplicate", "Delete", "Replace by…"])
      await menu
        .getByRole("menuitem", { name: new RegExp(`^${name}`) })
        .first()
        .waitFor();
    await menu.getByText("Ctrl+D", { exact: true }).waitFor();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Escape");
    await menu.waitFor({ state: "detached" });
    const canvasMenu = await open(await at(page, 300, 700), "Canvas menu");
    await page.keyboard.press("Escape");
    await canvasMenu.waitFor({ state: "detached" });
    await open({ x: box.x + 30, y: box.y + 10 }, "Node menu");
    await page.getByRole("menuitem", { name: "Replace by…" }).click();
    await page.getByRole("combobox", { name: "Replace by" }).fill("tube");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.skin.type === "tube" && nodes.skin.inputs.shape);
    await settled(page);
  }));

test("a long press opens the menu, and a finger moves the canvas", async () => {
  const page = await openPage(used.browser, used.server.url, { hash: RING, width: 1200, height: 800, touch: true });
  await settled(page);
  await wholeGraph(page);
  await canvasReady(page);
  const session = await page.context().newCDPSession(page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  const place = await at(page, 300, 650);
  await touch("touchStart", [place]);
  await page.getByRole("menu", { name: "Canvas menu" }).waitFor();
  await touch("touchEnd", []);
  await page.getByRole("menuitem", { name: /^Add a node/ }).tap();
  await page.getByRole("dialog", { name: "Add a node" }).waitFor();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog", { name: "Add a node" }).waitFor({ state: "detached" });
  const box = await placeOf(page, "skin");
  await touch("touchStart", [{ x: box.x + 40, y: box.y + 12 }]);
  await page.getByRole("menu", { name: "Node menu" }).waitFor();
  await touch("touchEnd", []);
  await page.keyboard.press("Escape");
  await page.getByRole("menu").waitFor({ state: "detached" });
  // A finger on the free canvas moves it.
  const viewport = async () => (await still(page.locator(".react-flow__viewport"))).transform;
  const before = await viewport();
  await touch("touchStart", [place]);
  for (let step = 1; step <= 6; step++) await touch("touchMove", [{ x: place.x + 12 * step, y: place.y }]);
  await touch("touchEnd", []);
  await eventually(viewport, (after) => after !== before, "a canvas moved with a finger");
  await page.context().close();
});

test("a node is found by name with Ctrl+F and shown; L lays the graph out without overlaps; H collapses", () =>
  ring(async (page) => {
    const place = await at(page, 300, 650);
    await page.mouse.move(place.x, place.y);
    await page.keyboard.press("Control+f");
    await page.getByRole("combobox", { name: "Find a node" }).fill("skin");
    await page.keyboard.press("Enter");
    await untilSelected(page, ["skin"]);
    await page.waitForFunction(() => document.activeElement?.dataset.id === "skin");
    await page.keyboard.press("h");
    await page.locator('[data-id="skin"] .node[data-collapsed="true"]').waitFor();
    // A collapsed node keeps its sockets.
    await output(page, "skin", "mesh").waitFor();
    await page.keyboard.press("h");
    await page.locator('[data-id="skin"] .node[data-collapsed="true"]').waitFor({ state: "detached" });
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Lay out" }).click();
    await said(page, "Laid out");
    await untilApart(page);
    await settled(page);
  }));

test("every node shows what it took or that it was cached, and a broken one says why", () =>
  ring(async (page) => {
    await page.locator(".node-time").first().waitFor();
    await choose(page, "boosted");
    await page.keyboard.press("Delete");
    await page.locator('[data-id="skin"] .node-message').waitFor();
    await page.getByRole("tab", { name: /^Problems/ }).click();
    const problems = page.getByRole("tabpanel", { name: /^Problems/ });
    await page.keyboard.press("Escape");
    await problems.getByRole("button", { name: /shape/ }).first().click();
    await untilSelected(page, ["skin"]);
  }));
