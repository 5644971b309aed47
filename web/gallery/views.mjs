// Makes docs/images/view/<name>.png: the 3D view and the files of the page, for the guide and to be looked at.
//
//   node web/gallery/views.mjs          all, with the program of scripts/build (or DINI_PROGRAM)
//   node web/gallery/views.mjs NAME...  these only

import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { launchBrowser, openPage, Server, selectNode, settled } from "../e2e/harness.mjs";
import { shrink } from "./png.mjs";

const folder = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../docs/images/view");
const WIDE = { width: 1440, height: 860 };
const MOST_BYTES = 400_000;

/** A graph of every kind of generator, all previewed. */
const pair = (x, split, y) => ({
  ...{ type: "point_pair", inputs: { position: [x, 0, 0], direction: [0, 0, 1], split } },
  place: { x: 0, y, preview: true },
});
const KINDS = graphOf("Point pairs: null, real and imaginary", {
  null_pair: pair(-2.6, 0, 0),
  real_pair: pair(0, 0.5, 150),
  imaginary_pair: pair(2.6, -0.5, 310),
  ring: { type: "circle", inputs: { center: [0, 3, 0], radius: 0.8 }, place: { x: 260, y: 0, preview: true } },
  dots: {
    ...{ type: "sample", inputs: { shape: { from: "ring" }, count: 9 } },
    place: { x: 520, y: 60, preview: true },
  },
  axis: { type: "line", inputs: { point: [2.6, 3, 0] }, place: { x: 260, y: 230 } },
  turn: { type: "rotation", inputs: { axis: { from: "axis" } }, place: { x: 520, y: 260, preview: true } },
  source: { type: "flat_point", inputs: { position: [-2.6, 3, 0] }, place: { x: 260, y: 370, preview: true } },
  ball: { type: "sphere_mesh", inputs: { radius: 0.25 }, place: { x: 520, y: 400 } },
  out: { type: "export", inputs: { model: { from: "ball" } }, place: { x: 780, y: 400 } },
});

const click = (page, role, name) => page.getByRole(role, { name, exact: true }).click();

const PICTURES = {
  pairs: [
    { hash: link(KINDS), ...WIDE },
    async (page) => {
      await selectNode(page, "real_pair");
      await click(page, "button", "Iso");
      await page.waitForTimeout(600);
      await click(page, "button", "Frame");
    },
  ],
  section: [
    { hash: "#example=fig04_boosted_ring", ...WIDE },
    async (page) => {
      await click(page, "radio", "Lines");
      await click(page, "button", "Section");
    },
  ],
  curvature: [{ hash: "#example=exact_dini", theme: "light", ...WIDE }, (page) => click(page, "radio", "Curvature")],
  wire: [
    { hash: "#example=fig15_curvature_patch", ...WIDE },
    async (page) => {
      await click(page, "radio", "Wire");
      await click(page, "button", "Orthographic");
    },
  ],
  show: [{ hash: "#example=fig11_patch", ...WIDE }, (page) => click(page, "button", "Show")],
  exporting: [
    { hash: "#example=fig05_twisted_ring", theme: "light", ...WIDE },
    async (page) => {
      await click(page, "button", "Export");
      await page.getByText("no point off by more than").waitFor();
    },
  ],
};

function graphOf(title, nodes) {
  const entries = Object.entries(nodes);
  return {
    ...{ format: 1, meta: { title } },
    nodes: Object.fromEntries(entries.map(([id, { type, inputs }]) => [id, { type, inputs }])),
    ui: { nodes: Object.fromEntries(entries.map(([id, { place }]) => [id, place])) },
  };
}

function link(graph) {
  return `#g=${deflateRawSync(JSON.stringify(graph)).toString("base64url")}`;
}

async function main(chosen) {
  const names = chosen.length > 0 ? chosen : Object.keys(PICTURES);
  mkdirSync(folder, { recursive: true });
  const server = new Server();
  await server.start();
  const browser = await launchBrowser();
  try {
    for (const name of names) {
      const [options, prepare] = PICTURES[name] ?? [];
      if (!prepare) throw new Error(`There is no ${name}; there are ${Object.keys(PICTURES).join(", ")}.`);
      const page = await openPage(browser, server.url, options);
      await settled(page, 120_000);
      await prepare(page);
      // Pointers leave no mark, and what was asked for last is drawn.
      await page.mouse.move(5, options.height - 5);
      await page.waitForTimeout(1000);
      const offences = await page.offences();
      if (offences.length > 0) throw new Error(offences.join("; "));
      const picture = shrink(await page.screenshot(), MOST_BYTES);
      writeFileSync(path.join(folder, `${name}.png`), picture);
      console.log(`${String(picture.length).padStart(8)}  ${name}`);
      await page.context().close();
    }
  } finally {
    await browser.close();
    await server.stop();
  }
}

await main(process.argv.slice(2));
