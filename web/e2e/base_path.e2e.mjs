// The whole page below a path, as behind a proxy that serves more than Dini.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { withCleanPage } from "./fixture.mjs";
import { canvasOf, launchBrowser, Server, settled } from "./harness.mjs";

const BASE = "/tools/dini";
const server = new Server(undefined, ["--base-path", BASE]);
const used = { server, browser: undefined };

before(async () => {
  await server.start();
  used.server = { url: `${server.url}${BASE}` };
  used.browser = await launchBrowser();
});
after(async () => {
  await used.browser?.close();
  await server.stop();
});

test("the page, its pictures, its models and the pages about the interface work below a path", {
  skip: !server.isOurs,
}, async () => {
  await withCleanPage(used, { hash: "#example=fig04_boosted_ring" }, async (page) => {
    const requested = [];
    page.on("request", (request) => requested.push(request.url()));
    await page.reload();
    await settled(page);
    await canvasOf(page);
    const own = requested.filter((url) => url.startsWith("http"));
    assert.ok(own.length > 5);
    assert.deepEqual(
      own.filter((url) => !new URL(url).pathname.startsWith(`${BASE}/`)),
      [],
    );
    assert.ok(own.some((url) => url.endsWith(`${BASE}/v1/evaluate`)));
  });
  const page = await used.browser.newPage();
  await page.goto(`${used.server.url}/docs`);
  assert.equal(await page.evaluate(() => document.styleSheets[0].cssRules.length > 0), true);
  await page.goto(new URL(await page.locator('a[href="problems/busy"]').first().getAttribute("href"), page.url()).href);
  assert.equal(await page.locator("h1").textContent(), "busy");
  await page.close();
});
