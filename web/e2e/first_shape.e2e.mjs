// The first shape: what is built is seen at once, without an export, and stays in sight.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, choose, inPanel, node, untilApart, untilGraph, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { canvasOf, covered, eventually, settled, turnWheel } from "./harness.mjs";

const used = useServer();
const SIZE = { width: 1500, height: 900 };

const model = (page) => page.getByRole("region", { name: "Model" });
const triangles = async (page) =>
  Number(/([\d\s ]+) triangles/.exec(await page.getByLabel("Statistics").textContent())[1].replace(/\D/g, ""));
const pill = (page) => model(page).getByRole("button", { name: /^Model is (out of view|cut off)/ });

test("a graph without an export shows its last node solid, or the selected one, and nothing once that is gone", () =>
  withEditor(used, { ...SIZE, isEmpty: true }, async (page) => {
    const ball = await addNode(page, "sphere mesh", 200, 200);
    await settled(page);
    const first = await eventually(
      () => triangles(page),
      (count) => count > 0,
    );
    await covered(page, 0.05);
    assert.equal(await page.locator(".react-flow__node-graph").count(), 1);
    const box = await addNode(page, "box mesh", 200, 480);
    await settled(page);
    await eventually(
      () => triangles(page),
      (count) => count !== first,
    );
    await choose(page, ball);
    await eventually(() => triangles(page), first);
    await choose(page, box);
    await inPanel(page, box);
    await page.keyboard.press("Control+a");
    await page.keyboard.press("Delete");
    await page.getByText("An empty graph").waitFor();
    await model(page).getByText("No node of this graph makes anything to be seen.").waitFor();
  }));

test("an input that lacks its wire offers the likeliest node, and the search for others", () =>
  withEditor(used, { ...SIZE, isEmpty: true }, async (page) => {
    const boost = await addNode(page, "boost", 420, 200);
    const box = node(page, boost);
    await box.getByRole("button", { name: "Add Circle", exact: true }).click();
    await untilGraph(page, ({ nodes }) => nodes[boost].inputs.shape?.from !== undefined);
    await box.getByRole("button", { name: "Add Point pair", exact: true }).click();
    await untilGraph(page, ({ nodes }) => nodes[boost].inputs.generator?.from !== undefined);
    await settled(page);
    await model(page).getByLabel("Statistics").waitFor();
    await untilApart(page);
    const twist = await addNode(page, "twist", 420, 560);
    await node(page, twist).getByRole("button", { name: "Find a node for shape of Twist" }).click();
    const search = page.getByRole("combobox", { name: "Add a node" });
    await search.fill("sphere mesh");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes[twist].inputs.shape?.from === "sphere_mesh");
  }));

test("a model that leaves the view, or grows out of it, is said so, and a press brings it back", () =>
  withEditor(used, { ...SIZE, isEmpty: true }, async (page) => {
    const ball = await addNode(page, "sphere mesh", 200, 200);
    await settled(page);
    await covered(page, 0.05);
    assert.equal(await pill(page).count(), 0);
    const radius = page.getByRole("tabpanel").getByRole("textbox", { name: /^radius/i });
    await inPanel(page, ball);
    await radius.fill("5");
    await radius.press("Enter");
    await pill(page).filter({ hasText: "Model is cut off" }).click();
    await pill(page).waitFor({ state: "detached" });
    // Whoever comes close on purpose is not told.
    const { x, y, width, height } = await canvasOf(page).boundingBox();
    await page.mouse.move(x + 0.6 * width, y + 0.6 * height);
    for (let turn = 0; turn < 6; turn++) await turnWheel(page, -200);
    assert.equal(await pill(page).count(), 0);
    await radius.fill("0.05");
    await radius.press("Enter");
    await settled(page);
    await page.mouse.move(x + 0.9 * width, y + 0.8 * height);
    await page.keyboard.down("Shift");
    await page.mouse.down();
    await page.mouse.move(x + 4, y + 4, { steps: 6 });
    await page.mouse.up();
    await page.keyboard.up("Shift");
    await pill(page).filter({ hasText: "Model is out of view" }).click();
    await pill(page).waitFor({ state: "detached" });
    await covered(page, 0.05);
  }));
