// The pictures of docs/editor.md, made in the real page by doing what the guide tells.

import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import {
  addNode,
  at,
  drag,
  emptyGraph,
  input,
  middle,
  openEditor,
  output,
  untilSelected,
  wire,
} from "../e2e/editing.mjs";
import { settled } from "../e2e/harness.mjs";
import { shrink } from "./png.mjs";

export const editorFolder = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../docs/images/editor");
const MOST_BYTES = 250_000;
const PATIENCE = { timeout: 120_000 };
const SIZE = { width: 1280, height: 760 };

/** One example per family of nodes: what the graphs of the guide are. */
const FAMILIES = {
  transforms: "fig05_twisted_ring",
  generators: "fig10_line_between_pairs",
  fields: "fig12_warped_sphere",
  surfaces: "fig11_patch",
  elements: "fig07_hopf_fibers",
};

/** Makes all pictures; `url` is a running server. */
export async function renderEditor(browser, url) {
  mkdirSync(editorFolder, { recursive: true });
  for (const [name, example] of Object.entries(FAMILIES)) {
    await picture(browser, url, `family-${name}`, { hash: `#example=${example}` });
  }
  await picture(browser, url, "light", { hash: "#example=fig05_twisted_ring", theme: "light" }, (page) =>
    find(page, "tangent"),
  );
  await picture(browser, url, "first-run", { firstRun: true });
  await picture(browser, url, "gizmo", { hash: "#example=fig04_boosted_ring" }, (page) => find(page, "ring"));
  await picture(browser, url, "problem", { hash: "#example=fig04_boosted_ring" }, async (page) => {
    await find(page, "boosted");
    await page.keyboard.press("Delete");
    await page.locator('[data-id="skin"] .node-message').waitFor(PATIENCE);
    await page.getByRole("tab", { name: /^Problems/ }).click();
  });
  await picture(browser, url, "search", { isEmpty: true }, async (page) => {
    await addNode(page, "circle", 170, 180);
    await drag(page, await middle(output(page, "circle", "circle")), await at(page, 350, 300));
    await page.getByRole("combobox", { name: "Add a node" }).fill("su");
  });
  await picture(browser, url, "wiring", { isEmpty: true }, async (page) => {
    await addNode(page, "point pair", 140, 160);
    await addNode(page, "circle", 140, 480);
    await addNode(page, "boost", 470, 300);
    await wire(page, "circle", "circle", "boost", "shape");
    const [from, to] = [
      await middle(output(page, "point_pair", "generator")),
      await middle(input(page, "boost", "generator")),
    ];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 6 });
  });
  await picture(browser, url, "narrow", { hash: "#example=fig04_boosted_ring", width: 480, height: 860 }, (page) =>
    page.getByRole("tablist", { name: "Panes" }).getByRole("tab", { name: "Graph" }).click(),
  );
}

/** Brings a node into sight and selects it, as a person does in a graph that is wider than its pane. */
async function find(page, id) {
  await page.getByRole("button", { name: "Find a node" }).click();
  await page.getByRole("combobox", { name: "Find a node" }).fill(id);
  await page.keyboard.press("Enter");
  await untilSelected(page, [id]);
}

async function picture(browser, url, name, options, prepare) {
  const page = await openEditor(browser, url, { ...SIZE, ...options });
  if (options.isEmpty) await emptyGraph(page);
  else await settled(page, PATIENCE.timeout);
  await prepare?.(page);
  // Control geometry and notices come and go a moment after what they belong to.
  await page.waitForTimeout(1500);
  await page.waitForFunction(
    () => document.querySelector("canvas[role=img]").dataset.still === "true",
    undefined,
    PATIENCE,
  );
  const bytes = shrink(await page.screenshot(PATIENCE), MOST_BYTES);
  writeFileSync(path.join(editorFolder, `${name}.png`), bytes);
  console.log(`${String(bytes.length).padStart(8)}  editor/${name}`);
  const offences = await page.offences();
  if (offences.length > 0) throw new Error(offences.join("; "));
  await page.context().close();
}
