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
const MOST_BYTES = 150_000;

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
    for (const id of chosen.length > 0 ? chosen : known) await render(browser, server.url, id);
  } finally {
    await browser.close();
    await server.stop();
  }
  writeFileSync(galleryFile, galleryText(examples));
}

async function render(browser, url, id) {
  const hash = `?view=picture#example=${encodeURIComponent(id)}`;
  const page = await openPage(browser, url, { hash, theme: "dark", width: WIDTH, height: HEIGHT });
  try {
    await settled(page, 120_000);
    // What the last change asked for is drawn in the next frame.
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const offences = await page.offences();
    if (offences.length > 0) throw new Error(`${id}: ${offences.join("; ")}`);
    const picture = shrink(await page.screenshot());
    writeFileSync(path.join(pictureFolder, `${id}.png`), picture);
    console.log(`${String(picture.length).padStart(8)}  ${id}`);
    if (picture.length > MOST_BYTES) throw new Error(`${id}: more than ${MOST_BYTES} bytes`);
  } finally {
    await page.context().close();
  }
}

await main(process.argv.slice(2));
