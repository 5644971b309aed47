// Makes docs/images/examples/<id>.png of the examples, each in the real page, docs/gallery.md with all of them, and
// docs/images/page.png of the page itself.
// Run by scripts/render-examples, which says more.

import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { launchBrowser, openPage, Server, settled } from "../e2e/harness.mjs";
import { galleryFile, galleryText, pageFile, pictureFolder, readExamples } from "./gallery.mjs";
import { shrink } from "./png.mjs";

const WIDTH = 960;
const HEIGHT = 600;
/** A picture of smooth shapes on a plain ground stays far below this; more of them would weigh on the repository. */
const MOST_BYTES = 320_000;
const PAGE_NAME = "page";
/** What the picture of the whole page shows. */
const PAGE = { example: "fig05_twisted_ring", width: 1440, height: 860, most: 600_000 };
/** The browser draws on the processor, which may have other work. */
const PATIENCE_MILLISECONDS = 120_000;
const MOST_ATTEMPTS = 10;

async function main(chosen) {
  const examples = readExamples();
  const known = examples.map(({ id }) => id);
  const unknown = chosen.filter((id) => id !== PAGE_NAME && !known.includes(id));
  if (unknown.length > 0) throw new Error(`There is no example ${unknown.join(", ")}; there are ${known.join(", ")}.`);
  mkdirSync(pictureFolder, { recursive: true });
  const server = new Server();
  if (server.isStandIn) throw new Error("The program is not built; scripts/build makes it.");
  await server.start();
  const browser = await launchBrowser();
  try {
    const ids = (chosen.length > 0 ? chosen : known).filter((id) => id !== PAGE_NAME);
    if (ids.length > 0) await renderExamples(browser, server.url, ids);
    // The server has read the new pictures only when it starts again.
    await server.stop();
    await server.start();
    if (chosen.length === 0 || chosen.includes(PAGE_NAME)) await renderPage(browser, server.url);
  } finally {
    await browser.close();
    await server.stop();
  }
  writeFileSync(galleryFile, galleryText(examples));
}

async function renderExamples(browser, url, ids) {
  const page = await openPage(browser, url, { hash: address(ids[0]), width: WIDTH, height: HEIGHT });
  for (const id of ids) await render(page, id);
  await assertClean(page);
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

async function render(page, id) {
  await page.evaluate((hash) => void (location.hash = hash), new URL(address(id), page.url()).hash);
  await page.waitForFunction((wanted) => document.documentElement.dataset.example === wanted, id);
  await settledInTheEnd(page);
  // What the last change asked for is drawn in the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const picture = shrink(await page.screenshot({ timeout: PATIENCE_MILLISECONDS }), MOST_BYTES);
  writeFileSync(path.join(pictureFolder, `${id}.png`), picture);
  console.log(`${String(picture.length).padStart(8)}  ${id}`);
}

await main(process.argv.slice(2));
