// Time, variants and batches: a parameter is played and recorded, values are compared, two parameters make a sheet.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { RING, useServer, withRing } from "./fixture.mjs";
import { canvasOf, changes, eventually, factsOf, openPage, picture, saved, settled } from "./harness.mjs";

const used = useServer();
const withPage = (options, run) => withRing(used, options, run);

const player = (page) => page.getByRole("region", { name: "Player" });

/** Opens the player with this many steps, and waits until all are here. */
async function openPlayer(page, steps) {
  await page.getByRole("button", { name: "Play a parameter" }).click();
  await player(page).getByRole("button", { name: "Pause" }).click();
  await player(page).getByRole("combobox", { name: "Steps" }).selectOption(String(steps));
  await player(page)
    .getByRole("status")
    .filter({ hasText: new RegExp(`${steps} steps$`) })
    .waitFor();
}

test("a parameter is played in the order of its steps, from one batch, and keeps the value it is stopped at", async () => {
  const asked = [];
  await withPage(
    { beforeOpening: (page) => page.on("request", (request) => asked.push(new URL(request.url()).pathname)) },
    async (page) => {
      const before = await picture(page);
      await page.evaluate(() => {
        window.steps = [];
        new MutationObserver(() => {
          const step = /step (\d+) of/.exec(document.querySelector(".player-state")?.textContent ?? "")?.[1];
          if (step !== undefined && window.steps.at(-1) !== step) window.steps.push(step);
        }).observe(document.body, { subtree: true, childList: true, characterData: true });
      });
      await openPlayer(page, 12);
      const evaluations = asked.filter((path) => path.endsWith("/v1/evaluate")).length;
      await player(page).getByRole("radio", { name: "Once" }).click();
      await player(page).getByRole("combobox", { name: "Speed" }).selectOption("30");
      await page.evaluate(() => {
        window.steps = [];
      });
      await player(page).getByRole("button", { name: "Play", exact: true }).click();
      await player(page).getByRole("button", { name: "Play", exact: true }).waitFor();
      await player(page).getByText("step 12 of 12 steps").waitFor();
      const steps = (await page.evaluate(() => window.steps)).map(Number);
      assert.deepEqual(
        steps,
        [...steps].sort((a, b) => a - b),
        "no step is shown before an earlier one",
      );
      assert.equal(asked.filter((path) => path.endsWith("/v1/evaluate")).length, evaluations, "all came in one batch");
      assert.ok(asked.some((path) => path.endsWith("/v1/sweeps")));
      const revision = Number((await factsOf(page)).revision);
      await player(page).getByRole("button", { name: "Close the player" }).click();
      await player(page).waitFor({ state: "detached" });
      await page.waitForFunction((last) => Number(document.documentElement.dataset.revision) > last, revision);
      await settled(page);
      await eventually(
        () => picture(page),
        (now) => !now.equals(before),
      );
      await page.keyboard.press("Control+z");
      await settled(page);
    },
  );
});

test("what is played is saved as a model with an animation, as pictures, and as a video", () =>
  withPage({}, async (page) => {
    await openPlayer(page, 12);
    const save = async (name) => {
      const button = player(page).getByRole("button", { name });
      await eventually(() => button.isEnabled(), true);
      const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
      return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
    };
    const model = await save("Animated GLB");
    assert.match(model.name, /\.glb$/);
    const json = JSON.parse(model.bytes.toString("utf8", 20, 20 + model.bytes.readUInt32LE(12)));
    assert.equal(json.animations[0].channels.length, 12);
    assert.ok(json.animations[0].samplers.every(({ interpolation }) => interpolation === "STEP"));
    const pictures = await save("Pictures (PNG)");
    assert.match(pictures.name, /\.zip$/);
    assert.equal(pictures.bytes.readUInt16LE(pictures.bytes.length - 12), 12, "files in the archive");
    assert.ok(pictures.bytes.includes(Buffer.from([0x89, 0x50, 0x4e, 0x47])));
    const video = await save("Video (WebM)");
    assert.match(video.name, /\.webm$/);
    assert.equal(video.bytes.readUInt32BE(0), 0x1a45dfa3, "the first bytes of a WebM file");
    assert.ok(video.bytes.length > 1000, `${video.bytes.length} bytes`);
  }));

test("present values are seen beside those of a variant, and as the distance between the two", () =>
  withPage({ width: 1440, height: 900 }, async (page) => {
    await page.getByRole("button", { name: "Keep as a variant" }).click();
    await page.getByRole("slider").first().press("End");
    await settled(page);
    const before = await picture(page);
    const eye = () => canvasOf(page).getAttribute("data-eye");
    const place = await eye();
    await page.getByRole("button", { name: "Compare with Variant 1" }).click();
    const bar = page.getByRole("region", { name: "Comparison" });
    await bar.getByText("Compared with Variant 1").waitFor();
    await eventually(
      () => picture(page),
      (now) => !now.equals(before),
      "two models",
    );
    await changes(page, "the distance", () => bar.getByRole("radio", { name: "Distance" }).click());
    const scale = await eventually(
      () => bar.locator(".compare-scale").textContent(),
      (text) => /\d\s(m|mm|µm)$/.test(text),
    );
    assert.ok(!scale.startsWith("0 0"), scale);
    await bar.getByRole("button", { name: "End the comparison" }).click();
    await bar.waitFor({ state: "detached" });
    await eventually(eye, place, "the place of before");
    assert.equal(await page.locator(".compare-names").count(), 0);
  }));

test("a comparison that another document ends leaves nothing of its place to the next one", () =>
  withPage({ width: 1440, height: 900 }, async (page) => {
    const eye = () => canvasOf(page).getAttribute("data-eye");
    const bar = page.getByRole("region", { name: "Comparison" });
    const compare = async () => {
      await page.getByRole("button", { name: "Keep as a variant" }).click();
      await page.getByRole("button", { name: "Compare with Variant 1" }).click();
      await bar.getByText("Compared with Variant 1").waitFor();
    };
    await compare();
    await page.getByRole("button", { name: "Examples" }).click();
    const examples = page.getByRole("dialog", { name: "Examples" });
    await examples
      .getByRole("button", { name: /Hopf fibers/ })
      .first()
      .click();
    await bar.waitFor({ state: "detached" });
    await settled(page);
    const place = await eye();
    await compare();
    await bar.getByRole("button", { name: "End the comparison" }).click();
    await bar.waitFor({ state: "detached" });
    await eventually(eye, place, "the place of before");
  }));

test("a sheet of two parameters comes from one batch, and a press on a picture takes its values", () =>
  withPage({ width: 1440, height: 900 }, async (page) => {
    const batches = [];
    page.on("request", (request) => {
      if (request.url().endsWith("/v1/sweeps")) batches.push(JSON.parse(request.postData()));
    });
    await page.getByRole("button", { name: "Contact sheet" }).click();
    const sheet = page.getByRole("dialog", { name: "Contact sheet" });
    await sheet.getByText("12 of 12 pictures").waitFor();
    assert.equal(batches.length, 1);
    const [[name, values]] = Object.entries(batches[0].grid);
    assert.equal(values.length, 4);
    assert.equal(await sheet.locator(".sheet-picture img").count(), 12);
    await sheet.getByRole("listitem").last().getByRole("button").click();
    await sheet.waitFor({ state: "detached" });
    await settled(page);
    const document = await saved(page);
    assert.equal(document.ui.values[name], values.at(-1));
  }));

test("what cannot be made says so in its place of the sheet, and the rest is there", async () => {
  const page = await openPage(used.browser, used.server.url, { hash: RING, width: 1440, height: 900 });
  await settled(page);
  await page.route("**/v1/sweeps", async (route) => {
    const lines = (await (await route.fetch()).text()).split("\n");
    const line = JSON.parse(lines[1]);
    delete line.model;
    lines[1] = JSON.stringify({
      ...line,
      status: "failed",
      errors: [{ code: "degenerate", detail: "It is too thin." }],
    });
    await route.fulfill({ body: lines.join("\n"), contentType: "application/x-ndjson" });
  });
  await page.getByRole("button", { name: "Contact sheet" }).click();
  const sheet = page.getByRole("dialog", { name: "Contact sheet" });
  await sheet.getByText("12 of 12 pictures").waitFor();
  const failed = sheet.getByRole("button", { disabled: true });
  assert.equal(await failed.count(), 1);
  // It is read where it stands, also by who has no pointer.
  await failed.getByText("It is too thin.").waitFor();
  await failed.press("Enter");
  assert.equal(await sheet.count(), 1, "nothing is taken from it");
  await page.context().close();
});
