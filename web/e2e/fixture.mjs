// What the tests of one file share: a server and a browser, and pages in which nothing may happen that must not.

import assert from "node:assert/strict";
import { after, before } from "node:test";
import { launchBrowser, openPage, Server, settled } from "./harness.mjs";

// WebGL is drawn in software all the same; the page around it takes a third of the time when it does not go through
// that too.
const BROWSER_ARGUMENTS = ["--disable-gpu-compositing"];

/** Starts a server and a browser before the tests of the file that calls it, then `prepare`s, and ends them after. */
export function useServer(prepare = () => undefined) {
  const used = { server: new Server(), browser: undefined };
  before(async () => {
    await used.server.start();
    used.browser = await launchBrowser(BROWSER_ARGUMENTS);
    await prepare(used.server);
  });
  after(async () => {
    await used.browser?.close();
    await used.server.stop();
  });
  return used;
}

/** Opens a page, runs the test in it, and fails if an error, a broken policy or a foreign request was seen. */
export async function withCleanPage(used, options, run, open = openPage) {
  const page = await open(used.browser, used.server.url, options);
  try {
    await run(page);
    assert.deepEqual(await page.offences(), []);
  } finally {
    await page.context().close();
  }
}

export const RING = "#example=fig04_boosted_ring";

/** A page that has opened the ring, unless the options say another graph, and is up to date. */
export const withRing = (used, options, run) =>
  withCleanPage(used, { hash: RING, ...options }, async (page) => {
    await settled(page);
    await run(page);
  });
