// Large graphs stay usable: 200 nodes with a map, 1000 nodes drawn only where they are seen.

import assert from "node:assert/strict";
import { test } from "node:test";
import { canvasReady, drag, emptyGraph, openEditor, pane, untilGraph } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, still } from "./harness.mjs";

const used = useServer();

/** Chains of transforms side by side, as text on the clipboard. */
function chains(count) {
  const nodes = {};
  const places = {};
  for (let at = 0; at < count; at++) {
    const [chain, step] = [Math.floor(at / 10), at % 10];
    const id = `n${at}`;
    nodes[id] =
      step === 0
        ? { type: "circle", inputs: { radius: 1 + chain } }
        : { type: "translate", inputs: { shape: { from: `n${at - 1}` }, vector: [0, 0, step] } };
    places[id] = { x: 262 * step, y: 190 * chain };
  }
  return JSON.stringify({ format: 1, nodes, ui: { nodes: places } });
}

/** Pastes the chains into an empty graph, and measures what moving a node costs the page. `maps`: how many are shown. */
async function measure(count, maps) {
  const page = await openEditor(used.browser, used.server.url, { width: 1280, height: 800 });
  await emptyGraph(page);
  await canvasReady(page);
  await page.evaluate((text) => navigator.clipboard.writeText(text), chains(count));
  const area = await still(pane(page));
  await page.mouse.move(area.x + 40, area.y + 120);
  const started = Date.now();
  await page.keyboard.press("Control+v");
  await untilGraph(page, ({ nodes }) => Object.keys(nodes).length === count);
  await page.locator(".node").first().waitFor();
  const paste = Date.now() - started;
  await page.keyboard.press("Escape");
  await eventually(() => page.locator(".react-flow__node.selected").count(), 0);
  const box = await still(page.locator('.react-flow__node[data-id="n0"]'));
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  const busy = async () => {
    const { metrics } = await client.send("Performance.getMetrics");
    return 1000 * metrics.find(({ name }) => name === "ScriptDuration").value;
  };
  const before = await busy();
  await drag(page, { x: box.x + 40, y: box.y + 10 }, { x: box.x + 60, y: box.y + 60 }, { steps: 30 });
  const script = ((await busy()) - before) / 30;
  const drawn = await eventually(
    () => page.locator(".react-flow__node").count(),
    (nodes) => nodes > 0 && nodes < 200,
    "only the nodes in sight",
  );
  await eventually(() => page.getByRole("img", { name: "Map of the graph" }).count(), maps, "maps");
  await page.keyboard.press("Control+z");
  await page.mouse.move(area.x + 40, area.y + 120);
  await page.keyboard.press("Home");
  // Whatever the number, Home shows all of them, with titles as large as ever.
  await eventually(
    () => page.locator(".react-flow__node").count(),
    (nodes) => nodes === count,
    "all nodes in sight",
  );
  const letters = () =>
    page
      .locator(".node-title")
      .first()
      .evaluate((title) => {
        const { a } = new DOMMatrix(getComputedStyle(title.closest(".react-flow__viewport")).transform);
        return Math.round(a * Number.parseFloat(getComputedStyle(title).fontSize));
      });
  await eventually(letters, 12, "the size of the titles on the screen");
  // Moved a little, it brings no nodes and takes none away.
  const center = { x: area.x + area.width / 2, y: area.y + area.height / 2 };
  await page.mouse.move(center.x, center.y);
  await page.mouse.down({ button: "middle" });
  await page.mouse.move(center.x + area.width / 4, center.y + area.height / 4, { steps: 4 });
  await page.mouse.up({ button: "middle" });
  const isOutside = (id) =>
    page.locator(`.react-flow__node[data-id="${id}"]`).evaluate((node) => {
      const [at, sight] = [node.getBoundingClientRect(), node.closest(".react-flow").getBoundingClientRect()];
      return at.top > sight.bottom;
    });
  await eventually(() => isOutside(`n${count - 1}`), true, "the last node out of sight");
  assert.equal(await page.locator(".react-flow__node").count(), count);
  await page.keyboard.press("Control+f");
  await page.getByRole("combobox", { name: "Find a node" }).fill(`n${count - 1}`);
  await page.keyboard.press("Enter");
  await page.waitForFunction((id) => document.activeElement?.dataset.id === id, `n${count - 1}`);
  assert.deepEqual(await page.offences(), []);
  await page.context().close();
  console.log(`# ${count} nodes: pasted in ${paste} ms, ${script.toFixed(1)} ms of script a move, ${drawn} drawn`);
}

test("200 nodes have a map, and only those in sight are drawn", { timeout: 400_000 }, () => measure(200, 1));

test(
  "1000 nodes are pasted, moved and found; the map, which would cost more than it helps, is gone",
  { timeout: 400_000 },
  () => measure(1000, 0),
);
