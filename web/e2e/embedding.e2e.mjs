// Stored graphs in pages of other origins: <model-viewer> by the address of a model, and the page for frames.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { balls, closeSites, Site } from "./embedding.mjs";
import { eventually, LONGEST_WAIT, launchBrowser, Server } from "./harness.mjs";

let [server, browser, friend, stranger] = [];

before(async () => {
  [friend, stranger] = [await Site.start(), await Site.start()];
  server = new Server(undefined, ["--allow-origin", friend.origin]);
  assert.ok(server.isOurs, "a server that lets our site in has to be started");
  await server.start();
  await balls(server.url);
  browser = await launchBrowser(["--disable-gpu-compositing"]);
});
after(async () => {
  await browser?.close();
  await server?.stop();
  await closeSites(friend, stranger);
});

/** Opens an address, runs the test in it, and fails if the page reported an error that is not expected. */
async function withPage(address, options, run) {
  const { width = 800, height = 600, theme = "dark", expected = /^$/ } = options;
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: theme });
  context.setDefaultTimeout(LONGEST_WAIT);
  const page = await context.newPage();
  const [errors, foreign] = [[], []];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(error.message));
  const ours = [server.url, friend.origin, stranger.origin];
  page.on("request", (request) => {
    if (!/^(blob|data):/.test(request.url()) && !ours.includes(new URL(request.url()).origin))
      foreign.push(request.url());
  });
  try {
    await page.goto(address);
    await run(page, errors);
    assert.deepEqual(
      errors.filter((text) => !expected.test(text)),
      [],
    );
    assert.deepEqual(foreign, []);
  } finally {
    await context.close();
  }
}

const embedded = (name) => `${server.url}/embed/${name}`;
const frameOf = (page) => page.frameLocator("iframe");
const settled = (place) =>
  place.locator('html[data-state="idle"][data-shown]:not([data-shown="0"])').waitFor({ state: "attached" });
const slider = (place) => place.getByRole("slider", { name: "Reach" });

/** Follows the models that the page's <model-viewer> shows: its width, once it has loaded what it is to show. */
async function widthsOf(page) {
  await page.locator("model-viewer").evaluate((viewer) => {
    const look = () => (window.width = viewer.getDimensions().x.toFixed(3));
    viewer.addEventListener("load", look);
    if (viewer.loaded) look();
  });
  return () => page.evaluate(() => window.width);
}

for (const [path, what] of [
  ["viewer", "model-viewer"],
  ["react", "model-viewer in React"],
]) {
  test(`${what} in a page of an origin that is let in shows a stored graph, and follows a slider`, () =>
    withPage(`${friend.origin}/${path}?dini=${server.url}`, {}, async (page) => {
      const width = await widthsOf(page);
      await eventually(width, "2.000");
      for (const reach of [2, 0.5]) {
        await page.getByRole("slider", { name: "Reach" }).fill(String(reach));
        await eventually(width, (2 * reach).toFixed(3));
      }
    }));
}

test("three.js in a page of an origin that is let in shows a stored graph, and follows a slider", () =>
  withPage(`${friend.origin}/three?dini=${server.url}`, {}, async (page) => {
    const shot = () => page.locator("canvas").screenshot();
    // A picture of nothing takes a fraction of that.
    const first = await eventually(shot, (now) => now.length > 4000, "a model");
    await page.getByRole("slider", { name: "Reach" }).fill("2");
    await eventually(shot, (now) => now.length > 4000 && !now.equals(first), "another model");
  }));

test("model-viewer in a page of another origin is shown nothing", () =>
  withPage(
    `${stranger.origin}/viewer?dini=${server.url}`,
    { expected: /blocked by CORS policy|Failed to load resource|Failed to fetch/ },
    async (page) => {
      const refused = page.waitForEvent("requestfailed", (request) => request.url().includes("/outputs/"));
      await page.reload();
      await refused;
      const viewer = page.locator("model-viewer");
      assert.equal(await viewer.evaluate((element) => element.loaded), false);
    },
  ));

test("an address with a version may be kept for ever, one without is asked about", async () => {
  const address = (name) => `${server.url}/v1/graphs/${name}/outputs/out.glb?reach=1`;
  const versioned = await fetch(address("ring@1"));
  assert.equal(versioned.headers.get("cache-control"), "public, max-age=31536000, immutable");
  const current = await fetch(address("ring"));
  assert.equal(current.headers.get("cache-control"), "no-cache");
  const etag = current.headers.get("etag");
  assert.match(etag, /^"/);
  assert.equal((await fetch(address("ring"), { headers: { "if-none-match": etag } })).status, 304);
});

test("a frame in a page of an origin that is let in shows the model, and follows its slider", () =>
  withPage(`${friend.origin}/frame?dini=${server.url}`, {}, async (page) => {
    const frame = frameOf(page);
    await settled(frame);
    assert.equal(await slider(frame).getAttribute("aria-valuenow"), "1.5");
    const canvas = frame.getByRole("img", { name: /^The model/ });
    const before = await canvas.screenshot();
    const asked = [];
    page.on("request", (request) => asked.push(request.url()));
    const box = await slider(frame).boundingBox();
    await page.mouse.move(box.x + box.width * 0.75, box.y + 10);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.3, box.y + 10, { steps: 8 });
    await page.mouse.up();
    const value = Number(await slider(frame).getAttribute("aria-valuenow"));
    assert.ok(value > 0.4 && value < 0.9, `${value}`);
    await eventually(() => asked.at(-1), `${server.url}/v1/graphs/ring@1/outputs/out.glb?reach=${value}`);
    await settled(frame);
    await eventually(
      () => canvas.screenshot(),
      (now) => !now.equals(before),
      "another picture",
    );
  }));

test("a frame in a page of another origin stays empty", () =>
  withPage(`${stranger.origin}/frame?dini=${server.url}`, { expected: /frame-ancestors/ }, async (page, errors) => {
    await eventually(() => errors.some((text) => text.includes("frame-ancestors")), true);
    assert.equal(await frameOf(page).locator("#root").count(), 0);
  }));

test("a frame in a page that is isolated from other origins shows the model too", () =>
  withPage(`${friend.origin}/isolated?dini=${server.url}`, {}, async (page) => {
    assert.equal(await page.evaluate(() => window.crossOriginIsolated), true);
    await settled(frameOf(page));
  }));

test("the smallest frame shows model and sliders, and everything in it is reached with the keys", () =>
  withPage(embedded("ring"), { width: 320, height: 240 }, async (page) => {
    await settled(page);
    const [model, controls] = [
      page.getByRole("region", { name: "Model" }),
      page.getByRole("region", { name: "Controls" }),
    ];
    const [above, below] = [await model.boundingBox(), await controls.boundingBox()];
    assert.ok(above.height > 110 && below.y + below.height <= 240, JSON.stringify([above, below]));
    await slider(page).focus();
    for (let press = 0; press < 3; press++) await page.keyboard.press("PageUp");
    assert.equal(await slider(page).getAttribute("aria-valuenow"), "1.3");
    await page.getByRole("button", { name: "Reset" }).press("Enter");
    assert.equal(await slider(page).getAttribute("aria-valuenow"), "1");
    await page.getByRole("button", { name: "Controls" }).press("Enter");
    await controls.waitFor({ state: "detached" });
    await settled(page);
  }));

test("what cannot be shown is said in words", async () => {
  const failed = /Failed to load resource: the server responded with a status of (404|422)/;
  for (const [address, words] of [
    ["nothing", /There is no graph 'nothing' here/],
    ["ring@7", /There is no graph 'ring@7' here/],
    ["ring?raech=2", /no parameter “raech”; it has reach/],
    ["ring?reach=wide", /“wide” is no number for “reach”/],
    ["ring?reach=99", /reach.*2/],
    ["ring?output=side", /no output “side”; it has out/],
    ["broken", /radius/],
  ]) {
    await withPage(embedded(address), { expected: failed }, (page) =>
      page.getByRole("status").filter({ hasText: words }).waitFor(),
    );
  }
});

test("a slider that leads to a mistake says so, and goes on from there", () =>
  withPage(embedded("fragile"), { expected: /status of 422/ }, async (page) => {
    await settled(page);
    await slider(page).press("End");
    const status = page.getByRole("status");
    await status.waitFor();
    await slider(page).press("Home");
    await status.waitFor({ state: "detached" });
    await settled(page);
  }));

test("an address chooses output, theme and version", () =>
  withPage(embedded("ring@1?output=out&theme=light"), {}, async (page) => {
    await settled(page);
    assert.equal(await page.locator("html").getAttribute("data-theme"), "light");
    await eventually(() => page.title(), "A ball");
  }));

test("a server that comes back is asked again", async () => {
  const data = mkdtempSync(path.join(tmpdir(), "dini-embedding-"));
  const other = new Server(undefined, [], data);
  try {
    await other.start();
    await balls(other.url);
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.goto(`${other.url}/embed/ring`);
    await settled(page);
    await other.stop();
    await slider(page).press("End");
    await page
      .getByRole("status")
      .filter({ hasText: /cannot be reached/ })
      .waitFor();
    await other.start();
    await page.getByRole("status").waitFor({ state: "detached" });
    await settled(page);
    await context.close();
  } finally {
    await other.stop();
    rmSync(data, { recursive: true, force: true });
  }
});
