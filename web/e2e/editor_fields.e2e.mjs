// Values: fields on nodes and in the panel, parameters, problems with their fixes.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, choose, drag, inPanel, node, placeOf, said, undo, untilGraph, wire, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, settled, still, turnWheel } from "./harness.mjs";

const RING = "#example=fig04_boosted_ring";
const used = useServer();

const large = { width: 1500, height: 900 };
const empty = (run) => withEditor(used, { isEmpty: true, ...large }, run);
const ring = (run, options = {}) => withEditor(used, { hash: RING, ...large, ...options }, run);

const radius = (page) => node(page, "circle").getByRole("textbox", { name: "radius of Circle" });

test("a number is dragged and typed on the node; a drag is one step of undo; the wheel never changes it", () =>
  empty(async (page) => {
    await addNode(page, "circle", 300, 260);
    const field = radius(page);
    const box = await still(field);
    const y = box.y + box.height / 2;
    await drag(page, { x: box.x + 20, y }, { x: box.x + 60, y });
    const typed = await eventually(
      () => field.inputValue(),
      (text) => Number(text) > 1,
    );
    await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius === Number(typed));
    await field.hover();
    await turnWheel(page, 300);
    assert.equal(await field.inputValue(), typed);
    await undo(page);
    await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius === undefined);
    await field.click();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("2*pi/3");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => Math.abs(nodes.circle.inputs.radius - (2 * Math.PI) / 3) < 1e-9);
    // A field without unfinished text leaves Ctrl+Z to the graph.
    await page.keyboard.press("Control+z");
    await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius === undefined);
    await field.fill("4");
    await page.keyboard.press("Enter");
    await page.keyboard.press("ArrowUp");
    await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius > 4 && nodes.circle.inputs.radius < 4.2);
    const place = await placeOf(page, "circle");
    await node(page, "circle").getByText("radius").dblclick();
    await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius === undefined);
    await eventually(() => placeOf(page, "circle"), place, "a node where it was");
  }));

test("vectors, choices, switches, colors, texts and lists have their fields in the panel", () =>
  empty(async (page) => {
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await addNode(page, "circle", 300, 160);
    await panel.getByRole("textbox", { name: "normal x of Circle" }).fill("1");
    await page.keyboard.press("Tab");
    await untilGraph(page, ({ nodes }) => JSON.stringify(nodes.circle.inputs.normal) === "[1,0,1]");
    await addNode(page, "boost", 300, 460);
    await panel.getByRole("combobox", { name: "Exponential of Boost" }).selectOption("paper");
    await untilGraph(page, ({ nodes }) => nodes.boost.inputs.rule === "paper");
    await addNode(page, "range", 560, 160);
    await panel.getByRole("checkbox", { name: "closed of Range" }).check();
    await panel.getByRole("textbox", { name: "axis of Range" }).fill("turns");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.range.inputs.closed === true && nodes.range.inputs.axis === "turns");
    await addNode(page, "color", 560, 460);
    await panel.getByLabel("color of Color").fill("#ff0000");
    await untilGraph(page, ({ nodes }) => nodes.color.inputs.color?.[0] === 1 && nodes.color.inputs.color[3] === 1);
    await addNode(page, "list", 110, 700);
    await panel.getByRole("textbox", { name: "items of List" }).fill("1, -1, 2*2");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => JSON.stringify(nodes.list.inputs.items) === "[1,-1,4]");
  }));

test("an input is exposed as a parameter, edited on the form, and concealed again", () =>
  empty(async (page) => {
    await addNode(page, "circle", 300, 160);
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await panel.getByRole("button", { name: "Expose radius as a parameter" }).click();
    const exposed = await untilGraph(page, (graph) => graph.nodes.circle.inputs.radius?.parameter === "radius");
    assert.equal(exposed.parameters.radius.max, 4);
    await page.getByRole("tab", { name: "Controls" }).click();
    await page.getByRole("button", { name: "Settings of Radius" }).click();
    const settings = page.getByRole("group", { name: "Settings of Radius" });
    await settings.getByLabel("Label").fill("Size of it");
    await page.keyboard.press("Enter");
    await page.getByRole("slider", { name: "Size of it" }).waitFor();
    await page.getByRole("group", { name: "Settings of Size of it" }).getByLabel("To").fill("9");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ parameters }) => parameters.radius.max === 9 && parameters.radius.label === "Size of it");
    await page.getByRole("textbox", { name: "Size of it value" }).fill("3");
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Make this value the default" }).click();
    await untilGraph(page, ({ parameters }) => parameters.radius.default === 3);
    await page.getByRole("button", { name: "Remove" }).click();
    await untilGraph(page, (graph) => !graph.parameters.radius && graph.nodes.circle.inputs.radius === 3);
    await undo(page);
    await untilGraph(page, (graph) => graph.nodes.circle.inputs.radius?.parameter === "radius");
    await page.getByRole("tab", { name: "Node" }).click();
    await panel.getByRole("button", { name: "Expose radius as a parameter" }).click();
    await untilGraph(page, (graph) => !graph.parameters.radius && typeof graph.nodes.circle.inputs.radius === "number");
  }));

test("a node is renamed, and every wire and the picture follow", () =>
  ring(async (page) => {
    const box = await still(node(page, "skin"));
    await page.mouse.dblclick(box.x + 30, box.y + 10);
    await page.getByRole("textbox", { name: "Name of the node" }).fill("hide");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.hide && !nodes.skin && JSON.stringify(nodes).includes('"hide'));
    await settled(page);
    await choose(page, "hide");
    await page.keyboard.press("F2");
    await page.getByRole("textbox", { name: "Name of the node" }).fill("9 lives of a hide");
    await page.keyboard.press("Enter");
    await said(page, "its name stays hide");
    await node(page, "hide").getByText("9 lives of a hide").waitFor();
  }));

test("a value out of range is a problem with a fix, which is applied and can be undone", () =>
  ring(async (page) => {
    const id = Object.entries(page.graph().nodes).find(([, item]) => typeof item.inputs.count === "number")[0];
    await choose(page, id);
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await panel.getByRole("textbox", { name: /^Count of / }).fill("0");
    await page.keyboard.press("Enter");
    await page.locator(`[data-id="${id}"] .node[data-tone="error"] .node-message`).waitFor();
    await page.getByRole("tab", { name: /^Problems/ }).click();
    await page.getByRole("button", { name: "Apply fix" }).first().click();
    const fixed = await untilGraph(page, ({ nodes }) => nodes[id].inputs.count !== 0);
    assert.ok(fixed.nodes[id].inputs.count >= 1);
    await page.locator(`[data-id="${id}"] .node[data-tone="error"]`).waitFor({ state: "detached" });
    await undo(page);
    await untilGraph(page, ({ nodes }) => nodes[id].inputs.count === 0);
  }));

test("a broken graph keeps the last picture, marked as out of date", () =>
  ring(async (page) => {
    await choose(page, "skin");
    await page.keyboard.press("Delete");
    await page.locator('.view-pane[data-stale="true"]').waitFor();
    await page.getByText("Out of date").first().waitFor();
    await page.keyboard.press("Control+z");
    await settled(page);
    await page.locator('.view-pane[data-stale="false"]').waitFor();
  }));

test("an edited example is marked as edited, and its title can be typed", () =>
  ring(async (page) => {
    await page.getByText("example", { exact: true }).waitFor();
    const title = page.getByRole("textbox", { name: "Title of the graph" });
    await title.fill("<script>alert(1)</script>");
    await page.keyboard.press("Enter");
    await page.getByText("edited", { exact: true }).waitFor();
    await eventually(() => page.getByRole("heading", { level: 1 }).textContent(), "<script>alert(1)</script>");
    await undo(page);
    await page.getByText("example", { exact: true }).waitFor();
  }));

test("a slider of the form changes only its own row of the page", () =>
  ring(async (page) => {
    await page.evaluate(() => {
      window.changed = new Set();
      new MutationObserver((records) => {
        for (const record of records) {
          const owner = (record.target.nodeType === 1 ? record.target : record.target.parentElement)?.closest(
            ".parameter, .node, .react-flow__edge, .status-bar, .statistics, .view-pane, .edit-buttons, html",
          );
          if (owner) window.changed.add(owner.dataset.parameter ?? owner.className ?? "");
        }
      }).observe(document.body, { subtree: true, childList: true, characterData: true, attributes: true });
    });
    const slider = page.getByRole("slider").first();
    const box = await still(slider);
    await drag(page, { x: box.x + 30, y: box.y + 8 }, { x: box.x + 90, y: box.y + 8 });
    await page.waitForFunction(() => window.changed.size > 0);
    await settled(page);
    const changed = await page.evaluate(() => [...window.changed]);
    assert.ok(!changed.some((name) => /react-flow__edge/.test(name)), `wires were drawn again: ${changed.join(" | ")}`);
  }));

test("a wire between families is refused by the server with its axes, on the node and in the list", () =>
  empty(async (page) => {
    await addNode(page, "range", 150, 160);
    await addNode(page, "range", 150, 480);
    await addNode(page, "expression", 520, 260);
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await panel.getByRole("textbox", { name: "formula of Expression" }).fill("x + y");
    await page.keyboard.press("Enter");
    for (const [id, count] of [
      ["range", "5"],
      ["range_2", "7"],
    ]) {
      await choose(page, id);
      await inPanel(page, id);
      await panel.getByRole("textbox", { name: "axis of Range" }).fill("k");
      await page.keyboard.press("Enter");
      await panel.getByRole("textbox", { name: "count of Range" }).fill(count);
      await page.keyboard.press("Enter");
    }
    await wire(page, "range", "values", "expression", "x");
    await wire(page, "range_2", "values", "expression", "y");
    await page.locator('[data-id="expression"] .node-message', { hasText: "axis k" }).waitFor();
  }));
