// Makes docs/images/examples/<id>.png of the examples and docs/images/nodes/<id>.png of those of one node each, all in
// the real page, docs/gallery.md, and docs/images/page.png of the page itself.
// Run by scripts/render-examples, which says more.

import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { launchBrowser, openPage, Server, settled } from "../e2e/harness.mjs";
import { renderEditor } from "./editor.mjs";
import { assetFolder, examples, galleryFile, galleryText, nodeExamples, pageFile, readExamples } from "./gallery.mjs";
import { shrink } from "./png.mjs";

const PAGE_NAME = "page";
const EDITOR_NAME = "editor";
/** What the picture of the whole page shows. */
const PAGE = { example: "fig04_boosted_ring", width: 1440, height: 860, most: 600_000 };
/** The browser draws on the processor, which may have other work. */
const PATIENCE_MILLISECONDS = 120_000;
const MOST_ATTEMPTS = 10;

async function main(chosen) {
  const isWanted = (name) => chosen.length === 0 || chosen.includes(name);
  const all = [examples, nodeExamples].map((set) => ({ set, ids: readExamples(set.graphs).map(({ id }) => id) }));
  const known = [...all.flatMap(({ set, ids }) => ids.map((id) => set.prefix + id)), "nodes", PAGE_NAME, EDITOR_NAME];
  const unknown = chosen.filter((name) => !known.includes(name));
  if (unknown.length > 0) throw new Error(`There is no ${unknown.join(", ")}; there are ${known.join(", ")}.`);
  const browser = await launchBrowser();
  try {
    for (const { set, ids } of all) {
      const isWhole = set === nodeExamples && isWanted("nodes");
      const wanted = ids.filter((id) => isWhole || isWanted(set.prefix + id));
      if (wanted.length > 0) await renderAll(browser, set, wanted);
    }
    // After the others, since the page shows their pictures.
    if (isWanted(PAGE_NAME)) await served(examples.graphs, (url) => renderPage(browser, url));
    if (isWanted(EDITOR_NAME)) await served(examples.graphs, (url) => renderEditor(browser, url));
  } finally {
    await browser.close();
  }
  writeFileSync(galleryFile, galleryText(readExamples()));
}

/** Runs `work` with the address of a server of the graphs in a folder and of the mesh files that they name. */
async function served(graphs, work) {
  const isUsual = graphs === examples.graphs;
  const folder = isUsual ? graphs : mkdtempSync(path.join(tmpdir(), "dini-gallery-"));
  const server = new Server(folder);
  try {
    if (!isUsual) {
      cpSync(graphs, folder, { recursive: true });
      cpSync(assetFolder, path.join(folder, "assets"), { recursive: true });
    }
    await server.start();
    await work(server.url);
  } finally {
    await server.stop();
    if (!isUsual) rmSync(folder, { recursive: true, force: true });
  }
}

async function renderAll(browser, set, ids) {
  mkdirSync(set.pictures, { recursive: true });
  await served(set.graphs, async (url) => {
    const page = await openPage(browser, url, { hash: address(ids[0]), width: set.width, height: set.height });
    for (const id of ids) await render(page, set, id);
    await assertClean(page);
  });
}

async function renderPage(browser, url) {
  const { example, width, height, most } = PAGE;
  const page = await openPage(browser, url, { hash: `#example=${example}`, width, height });
  await settledInTheEnd(page);
  await page.waitForFunction(
    () => [...document.querySelectorAll(".card-picture")].every((card) => card.querySelector("img")?.complete),
    undefined,
    { timeout: PATIENCE_MILLISECONDS },
  );
  writeFileSync(pageFile, shrink(await page.screenshot({ timeout: PATIENCE_MILLISECONDS }), most));
  await assertClean(page);
}

/** Like settled, on a machine with other work too, where the server may refuse an evaluation for its deadline. */
async function settledInTheEnd(page) {
  for (let attempt = 1; attempt < MOST_ATTEMPTS; attempt++) {
    await page.waitForFunction(() => document.documentElement.dataset.state !== "busy", undefined, {
      timeout: PATIENCE_MILLISECONDS,
    });
    if ((await page.evaluate(() => document.documentElement.dataset.state)) === "idle") break;
    await page.reload();
  }
  await settled(page, PATIENCE_MILLISECONDS);
}

/** Throws when something went wrong in the page that a picture may not show. */
async function assertClean(page) {
  const offences = await page.offences();
  if (offences.length > 0) throw new Error(offences.join("; "));
}

function address(id) {
  return `?view=picture#example=${encodeURIComponent(id)}`;
}

async function render(page, set, id) {
  await page.evaluate(
    (hash) => {
      location.hash = hash;
    },
    new URL(address(id), page.url()).hash,
  );
  await page.waitForFunction((wanted) => document.documentElement.dataset.example === wanted, id);
  await settledInTheEnd(page);
  // What the last change asked for is drawn in the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const picture = shrink(await page.screenshot({ timeout: PATIENCE_MILLISECONDS }), set.most);
  writeFileSync(path.join(set.pictures, `${id}.png`), picture);
  console.log(`${String(picture.length).padStart(8)}  ${set.prefix}${id}`);
}

await main(process.argv.slice(2));
