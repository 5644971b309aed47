// Colors and labels of nodes, and frames that show their heads only.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, choose, node, output, pane, said, undo, untilGraph, wire, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, still } from "./harness.mjs";

const used = useServer();
const EMPTY = { isEmpty: true, width: 1600, height: 900 };

test("a node is given a color and a label, which change neither its id nor its wires", () =>
  withEditor(used, EMPTY, async (page) => {
    const ring = await addNode(page, "circle", 160, 200);
    const skin = await addNode(page, "tube", 520, 200);
    await wire(page, ring, "circle", skin, "shape");
    await untilGraph(page, ({ nodes }) => nodes[skin].inputs.shape?.from === ring);
    await choose(page, ring);
    const box = await still(node(page, ring));
    await page.mouse.click(box.x + 40, box.y + 12, { button: "right" });
    await page.getByRole("menuitem", { name: "Another color" }).click();
    await said(page, "Colored blue");
    await pane(page).locator(`[data-id="${ring}"] .node[data-color="blue"]`).waitFor();
    await choose(page, ring);
    await page.keyboard.press("F2");
    await page.getByRole("textbox", { name: "Name of the node" }).fill("The ring of the base, 1 m wide");
    await page.keyboard.press("Enter");
    await said(page, `its name stays ${ring}`);
    await node(page, ring).getByText("The ring of the base, 1 m wide").waitFor();
    // The next evaluation has the notes with it.
    await addNode(page, "sphere", 160, 620);
    const sent = await untilGraph(page, ({ ui }) => ui.nodes[ring]?.label !== undefined);
    assert.equal(sent.ui.nodes[ring].color, "blue");
    assert.deepEqual(sent.nodes[skin].inputs.shape, { from: ring });
  }));

test("a collapsed frame stands for its nodes, keeps their wires, and opens for whoever looks for one of them", () =>
  withEditor(used, EMPTY, async (page) => {
    const ring = await addNode(page, "circle", 160, 200);
    const skin = await addNode(page, "tube", 620, 200);
    await wire(page, ring, "circle", skin, "shape");
    await choose(page, ring);
    await page.keyboard.press("Control+j");
    await page.getByRole("textbox", { name: "Title of the frame" }).fill("Base");
    await page.keyboard.press("Enter");
    const edge = pane(page).locator(".react-flow__edge");
    await eventually(() => edge.count(), 1);
    await pane(page).getByRole("button", { name: "Nodes of Base" }).click();
    await said(page, "Collapsed Base: 1 node");
    await node(page, ring).waitFor({ state: "detached" });
    await eventually(() => edge.count(), 1, "the wire ends at the frame");
    await output(page, skin, "mesh").waitFor();
    await page.keyboard.press("Control+f");
    await page.getByRole("combobox", { name: "Find a node" }).fill(ring);
    await page.keyboard.press("Enter");
    await node(page, ring).waitFor();
    await undo(page);
    await node(page, ring).waitFor({ state: "detached" });
  }));
