// Makes docs/images/examples/<id>.png of the examples, each in the real page, and docs/gallery.md with all of them.
// Run by scripts/render-examples, which says more.

import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { launchBrowser, openPage, Server, settled } from "../e2e/harness.mjs";
import { galleryFile, galleryText, pictureFolder, readExamples } from "./gallery.mjs";
import { shrink } from "./png.mjs";

const WIDTH = 960;
const HEIGHT = 600;
/** A picture of smooth shapes on a plain ground stays far below this; more of them would weigh on the repository. */
const MOST_BYTES = 200_000;
/** The browser draws on the processor, which may have other work. */
const PATIENCE_MILLISECONDS = 120_000;

async function main(chosen) {
  const examples = readExamples();
  const known = examples.map(({ id }) => id);
  const unknown = chosen.filter((id) => !known.includes(id));
  if (unknown.length > 0) throw new Error(`There is no example ${unknown.join(", ")}; there are ${known.join(", ")}.`);
  mkdirSync(pictureFolder, { recursive: true });
  const server = new Server();
  if (server.isStandIn) throw new Error("The program is not built; scripts/build makes it.");
  await server.start();
  const browser = await launchBrowser();
  try {
    const ids = chosen.length > 0 ? chosen : known;
    const page = await openPage(browser, server.url, { hash: address(ids[0]), width: WIDTH, height: HEIGHT });
    for (const id of ids) await render(page, id);
    const offences = await page.offences();
    if (offences.length > 0) throw new Error(offences.join("; "));
  } finally {
    await browser.close();
    await server.stop();
  }
  writeFileSync(galleryFile, galleryText(examples));
}

function address(id) {
  return `?view=picture#example=${encodeURIComponent(id)}`;
}

async function render(page, id) {
  await page.evaluate((hash) => void (location.hash = hash), new URL(address(id), page.url()).hash);
  await page.waitForFunction((wanted) => document.documentElement.dataset.example === wanted, id);
  await settled(page, PATIENCE_MILLISECONDS);
  // What the last change asked for is drawn in the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const picture = shrink(await page.screenshot({ timeout: PATIENCE_MILLISECONDS }), MOST_BYTES);
  writeFileSync(path.join(pictureFolder, `${id}.png`), picture);
  console.log(`${String(picture.length).padStart(8)}  ${id}`);
}

await main(process.argv.slice(2));
