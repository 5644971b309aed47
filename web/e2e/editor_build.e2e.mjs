// Whole graphs: figure 11 from an empty canvas with the mouse, a smaller one with the keyboard alone.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addNode,
  at,
  canvasReady,
  choose,
  drag,
  input,
  middle,
  node,
  output,
  untilGraph,
  wire,
  withEditor,
} from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { covered, eventually, settled, still } from "./harness.mjs";

const used = useServer();
const { server } = used;

/** Four point pairs at the corners of a square, and which way each looks in the first of the figure's patches. */
const CORNERS = [
  { port: "a", position: [-1, -1, 0], up: 1 },
  { port: "b", position: [1, -1, 0], up: -1 },
  { port: "c", position: [-1, 1, 0], up: -1 },
  { port: "d", position: [1, 1, 0], up: 1 },
];

test("figure 11, a patch of four point pairs, is built from an empty canvas with the mouse", { timeout: 400_000 }, () =>
  withEditor(used, { isEmpty: true, width: 1800, height: 1200 }, async (page) => {
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await addNode(page, "patch", 420, 180);
    for (const [index, { port, position, up }] of CORNERS.entries()) {
      const id = await addNode(page, "point pair", 130, 120 + 215 * index);
      for (const [axis, letter] of ["x", "y", "z"].entries()) {
        const field = panel.getByRole("textbox", { name: `position ${letter} of Point pair` });
        await field.click();
        await page.keyboard.press("Control+a");
        await page.keyboard.type(String(position[axis]));
        await page.keyboard.press("Enter");
      }
      const z = panel.getByRole("textbox", { name: "direction z of Point pair" });
      await z.click();
      await page.keyboard.press("Control+a");
      await page.keyboard.type(String(up));
      await page.keyboard.press("Enter");
      await wire(page, id, "generator", "patch", port);
      await untilGraph(
        page,
        ({ nodes }) => nodes.patch.inputs[port]?.from === id && (nodes[id].inputs.direction?.[2] ?? 1) === up,
      );
    }
    await drag(page, await middle(output(page, "patch", "mesh")), await at(page, 700, 420));
    await page.getByRole("dialog", { name: "Add a node" }).waitFor();
    await page.keyboard.type("export");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.export?.inputs.model !== undefined);
    await choose(page, "patch");
    await panel.getByRole("textbox", { name: "amount of Patch" }).fill("0.4");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.patch.inputs.amount === 0.4);
    await settled(page);
    await covered(page, 0.03);
    // It is the same as the first of the figure's patches.
    const area = async (graph, parameters) => {
      const measured = {
        ...graph,
        nodes: { ...graph.nodes, size: { type: "measure", inputs: { model: { from: "patch" } } } },
      };
      const body = JSON.stringify({ graph: measured, parameters, node: "size", output: "area" });
      const headers = { "content-type": "application/json" };
      return (await (await fetch(`${server.url}/v1/inspect`, { method: "POST", headers, body })).json()).values[0];
    };
    const { examples } = await (await fetch(`${server.url}/v1/examples`)).json();
    const figure = examples.find((example) => example.id === "fig11_patch").graph;
    const graph = structuredClone(page.graph());
    for (const name of ["count_u", "count_v"]) graph.nodes.patch.inputs[name] = figure.nodes.patch.inputs[name];
    const [ours, theirs] = [await area(graph), await area(figure)];
    assert.ok(Math.abs(ours - theirs) < 1e-6 * theirs, `area ${ours}, in the figure ${theirs}`);
  }),
);

test(
  "a tube around a boosted circle is built, changed and taken apart with the keyboard alone",
  { timeout: 400_000 },
  () =>
    withEditor(used, { asOpened: true, width: 1500, height: 900 }, async (page) => {
      const press = async (...keys) => {
        for (const key of keys) await page.keyboard.press(key);
      };
      const focusOn = (name) =>
        page.waitForFunction((wanted) => document.activeElement?.getAttribute("aria-label")?.startsWith(wanted), name);
      /** Goes on with Tab until what has the focus has this name. */
      const tabTo = async (name, most = 40) => {
        for (let count = 0; count < most; count++) {
          const label = await page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? "");
          if (label.startsWith(name)) return;
          await press("Tab");
        }
        throw new Error(`Tab never came to ${name}`);
      };
      /** Goes into the node that has the focus. */
      const enter = async () => {
        await press("Enter");
        await page.waitForFunction(() => document.activeElement.matches("[data-stop]"));
      };
      const search = async (text, label = "Add a node") => {
        await page.locator(`[role=dialog][aria-label^="${label}"] [role=combobox]:focus`).waitFor();
        await page.keyboard.type(text);
        await press("Enter");
      };
      await tabTo("New graph");
      await press("Enter");
      await page.getByText("An empty graph").waitFor();
      await canvasReady(page);
      // "Add node" is a button like any other.
      for (let count = 0; (await page.evaluate(() => document.activeElement?.textContent)) !== "Add node"; count++) {
        assert.ok(count < 30);
        await press("Tab");
      }
      await press("Enter");
      await search("circle");
      await focusOn("Circle, circle");
      // Into the node, to its output, and on to a new node from there.
      await enter();
      await focusOn("Input Center");
      await tabTo("Output Circle of Circle");
      await press("Enter");
      await search("new node", "Connect");
      await search("boost");
      await untilGraph(page, ({ nodes }) => nodes.boost?.inputs.shape?.from === "circle");
      await focusOn("Boost, boost");
      await enter();
      await tabTo("Input Generator of Boost");
      await press("Enter");
      await search("new node", "Connect");
      await search("point pair");
      await untilGraph(page, ({ nodes }) => nodes.boost.inputs.generator?.from === "point_pair");
      await focusOn("Point pair, point_pair");
      await press("Shift+A");
      await search("tube");
      await focusOn("Tube, tube");
      // A socket that is there is chosen from the list.
      await enter();
      await tabTo("Input Shape of Tube");
      await press("Enter");
      await search("boost", "Connect");
      await untilGraph(page, ({ nodes }) => nodes.tube.inputs.shape?.from === "boost");
      await focusOn("Input Shape of Tube");
      await tabTo("Output Mesh of Tube");
      await press("Enter");
      await search("new node", "Connect");
      await search("export");
      await untilGraph(page, ({ nodes }) => nodes.export?.inputs.model !== undefined);
      await settled(page);
      await covered(page, 0.003);
      // A value, by its field on the node.
      await focusOn("Export, export");
      await press("ArrowLeft");
      await page.waitForFunction(() => {
        const { ariaLabel, ariaRoleDescription } = document.activeElement;
        return ariaRoleDescription === "node" && !ariaLabel.startsWith("Export");
      });
      await press("Control+f");
      await search("tube", "Find a node");
      await focusOn("Tube, tube");
      await enter();
      await tabTo("Radius of Tube");
      await press("Control+a");
      await page.keyboard.type("0.2");
      await press("Enter");
      await untilGraph(page, ({ nodes }) => nodes.tube.inputs.radius === 0.2);
      await press("Escape");
      // Moving, disconnecting and deleting.
      await focusOn("Tube, tube");
      const before = await still(node(page, "tube"));
      await press("Shift+ArrowDown", "Shift+ArrowDown");
      const placeOf = () => node(page, "tube").boundingBox();
      await eventually(placeOf, ({ y }) => y > before.y + 20, "a tube moved down");
      await press("Control+z");
      await eventually(placeOf, ({ y }) => Math.abs(y - before.y) < 1, "a tube back in its place");
      await enter();
      await tabTo("Input Shape of Tube");
      await press("Enter");
      await search("disconnect", "Connect");
      await untilGraph(page, ({ nodes }) => nodes.tube.inputs.shape === undefined);
      await focusOn("Input Shape of Tube");
      await press("Escape");
      await focusOn("Tube, tube");
      await press("Delete");
      await untilGraph(page, ({ nodes }) => !nodes.tube);
      await press("Control+z");
      await press("Control+z");
      await untilGraph(page, ({ nodes }) => nodes.tube?.inputs.shape?.from === "boost");
      await settled(page);
      await input(page, "tube", "shape").waitFor();
    }),
);
