// The 3D view: ways to look, the section, gizmos, control geometry, and what it must not waste.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { RING, useServer, withRing } from "./fixture.mjs";
import {
  canvasOf,
  changes,
  covered,
  eventually,
  factsOf,
  openPage,
  picture,
  quiet,
  saved,
  selectNode,
  settled,
  still,
} from "./harness.mjs";

/** A graph that takes the server a moment only, with a slider. */
const SMALL = {
  format: 1,
  meta: { title: "Small" },
  parameters: { reach: { type: "number", default: 1, min: 0, max: 10, step: 0.01, label: "Reach" } },
  nodes: {
    ring: { type: "circle", inputs: { radius: 1 } },
    pair: { type: "point_pair", inputs: { position: [0, 0, 2], direction: [0, 0, 1] } },
    k: { type: "range", inputs: { from: 0, to: { parameter: "reach" }, count: 8 } },
    boosted: {
      type: "boost",
      inputs: { shape: { from: "ring" }, generator: { from: "pair" }, amount: { from: "k" } },
    },
    skin: { type: "surface", inputs: { shape: { from: "boosted" }, segments: 12 } },
    out: { type: "export", inputs: { model: { from: "skin" } } },
  },
};

const used = useServer();
const { server } = used;

const withPage = (options, run) => withRing(used, options, run);

/** The drawing alone, without what lies over it. */
async function drawing(page) {
  await quiet(page);
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save a picture" }).click(),
  ]);
  return readFileSync(await download.path());
}

/** Drags an element by some pixels, in steps, and waits until the answer is shown. */
async function drag(page, element, dx, dy, { release = true } = {}) {
  const box = await still(element);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 8; step++) await page.mouse.move(x + (dx * step) / 8, y + (dy * step) / 8);
  if (!release) return;
  await page.mouse.up();
  await settled(page);
}

test("curvature has a legend, and every way to look draws something else", () =>
  withPage({}, async (page) => {
    const seen = new Set();
    for (const mode of ["Shaded", "Lines", "Wire", "Normals", "Curvature"]) {
      await page.getByRole("radio", { name: mode, exact: true }).click();
      const another = await eventually(
        async () => (await picture(page)).toString("base64"),
        (text) => !seen.has(text),
        `a picture of its own for ${mode}`,
      );
      seen.add(another);
    }
    const legend = page.getByRole("group", { name: "Curvature legend" });
    await legend.getByText(/m⁻²/).first().waitFor();
    await changes(page, "mean curvature", () => legend.getByRole("radio", { name: "Mean" }).click());
    await legend.getByText(/m⁻¹/).first().waitFor();
    await page.reload();
    await settled(page);
    // The choice is remembered.
    await page.getByRole("radio", { name: "Curvature", exact: true, checked: true }).waitFor({ state: "attached" });
  }));

test("the page is there before the 3D view has arrived", async () => {
  const context = await used.browser.newContext();
  const page = await context.newPage();
  let give;
  const held = new Promise((resolve) => (give = resolve));
  await page.route("**/Viewer-*.js", async (route) => {
    await held;
    await route.continue();
  });
  await page.goto(`${server.url}/${RING}`);
  await page.getByRole("button", { name: "Add node" }).waitFor();
  await page.getByRole("group", { name: /, ring$/ }).waitFor();
  assert.equal(await canvasOf(page).count(), 0);
  give();
  await settled(page);
  await context.close();
});

test("a section is placed by hand and by number, along any axis, on either side", () =>
  withPage({}, async (page) => {
    await changes(page, "section", () => page.getByRole("button", { name: "Section", exact: true }).click());
    const panel = page.getByRole("group", { name: "Section" });
    const offset = panel.getByRole("textbox", { name: "Section offset value" });
    const before = Number(await offset.inputValue());
    await changes(page, "dragged", () =>
      drag(page, page.getByRole("button", { name: "Move the section plane" }), 40, 20),
    );
    await eventually(
      async () => Number(await offset.inputValue()),
      (now) => now !== before,
    );
    await changes(page, "other side", () => panel.getByRole("button", { name: "Keep the other side" }).click());
    await changes(page, "axis", () => panel.getByRole("radio", { name: "Z" }).click());
    await changes(page, "slider", () => panel.getByRole("slider", { name: "Section offset" }).press("PageUp"));
    await changes(page, "no section", () => page.getByRole("button", { name: "Section", exact: true }).click());
  }));

test("standard views and keys act on the pane under the pointer", () =>
  withPage({}, async (page) => {
    for (const view of ["Front", "Right", "Top", "Iso"]) {
      await changes(page, view, () => page.getByRole("button", { name: view, exact: true }).click());
      await covered(page, 0.03);
    }
    await changes(page, "orthographic", () => page.getByRole("button", { name: "Orthographic" }).click());
    await canvasOf(page).hover();
    for (const key of ["1", "3", "7", "5", "Home"]) await changes(page, key, () => page.keyboard.press(key));
    await page.getByRole("region", { name: "Graph" }).hover({ position: { x: 20, y: 200 } });
    const still = await picture(page);
    await page.keyboard.press("1");
    assert.ok((await picture(page)).equals(still), "the pointer is elsewhere");
  }));

test("dragging a gizmo changes the mesh and the document, and one undo returns both", () =>
  withPage({}, async (page) => {
    const before = { drawing: await drawing(page), json: await saved(page) };
    await selectNode(page, "ring");
    const handle = page.getByRole("button", { name: "Change radius of Circle" });
    await handle.waitFor();
    await drag(page, handle, 45, 0);
    const after = await saved(page);
    assert.ok(
      after.nodes.ring.inputs.radius > before.json.nodes.ring.inputs.radius + 0.05,
      JSON.stringify(after.nodes.ring),
    );
    const direction = page.getByRole("button", { name: "Turn normal of Circle" });
    await changes(page, "turned", () => drag(page, direction, 30, 10));
    assert.notDeepEqual((await saved(page)).nodes.ring.inputs.normal, before.json.nodes.ring.inputs.normal);
    await page.keyboard.press("Control+z");
    await settled(page);
    assert.deepEqual((await saved(page)).nodes, after.nodes, "the second drag is one step");
    await page.keyboard.press("Control+z");
    await settled(page);
    assert.deepEqual((await saved(page)).nodes, before.json.nodes, "the first drag is one step");
    const isAsBefore = async () => (await drawing(page)).equals(before.drawing);
    await eventually(isAsBefore, false, "the gizmo in the picture");
    await page.getByRole("button", { name: "Control geometry" }).click();
    await eventually(isAsBefore, true, "the picture from before");
  }));

test("Escape takes a drag back without a trace, Ctrl snaps, and arrow keys nudge", () =>
  withPage({}, async (page) => {
    const before = await saved(page);
    await selectNode(page, "tangent");
    const handle = page.getByRole("button", { name: "Move position of Point pair along Z" });
    await drag(page, handle, 0, -60, { release: false });
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await settled(page);
    assert.deepEqual((await saved(page)).nodes, before.nodes);
    // Nothing is left to undo.
    await eventually(() => page.getByRole("button", { name: /^Undo/ }).isDisabled(), true);
    await page.keyboard.down("Control");
    await drag(page, handle, 3, -57);
    await page.keyboard.up("Control");
    const [x, y, z] = (await saved(page)).nodes.tangent.inputs.position;
    assert.deepEqual([x, y], [0, 0]);
    assert.ok(z > 0 && Math.abs(z * 20 - Math.round(z * 20)) < 1e-9, `${z} is on the grid`);
    await handle.press("ArrowUp");
    await settled(page);
    assert.ok((await saved(page)).nodes.tangent.inputs.position[2] > z);
  }));

const WIRED = structuredClone(SMALL);
WIRED.nodes.middle = { type: "point", inputs: { position: [0.5, 0, 0.25] } };
WIRED.nodes.ring.inputs = { center: { from: "middle" }, radius: 1 };

test("a ring whose center comes over a wire has its handle where the server says", () =>
  withPage({ hash: `#g=${deflateRawSync(JSON.stringify(WIRED)).toString("base64url")}` }, async (page) => {
    await selectNode(page, "ring");
    const handle = page.getByRole("button", { name: "Change radius of Circle" });
    await handle.waitFor();
    assert.equal(await page.getByRole("button", { name: "Move center of Circle", exact: true }).count(), 0);
    await drag(page, handle, 30, 0);
    const { ring } = (await saved(page)).nodes;
    assert.ok(ring.inputs.radius > 1.05, JSON.stringify(ring));
    assert.deepEqual(ring.inputs.center, { from: "middle" });
  }));

test("a handle follows a finger", () =>
  withPage({ touch: true }, async (page) => {
    const before = await saved(page);
    await selectNode(page, "ring");
    const box = await still(page.getByRole("button", { name: "Change radius of Circle" }));
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const session = await page.context().newCDPSession(page);
    const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    await touch("touchStart", [{ x, y }]);
    for (let step = 1; step <= 6; step++) await touch("touchMove", [{ x: x - 6 * step, y }]);
    await touch("touchEnd", []);
    // What a finger does is told to the page when it has time for it.
    await eventually(
      async () => (await saved(page)).nodes.ring.inputs.radius,
      (radius) => radius < before.nodes.ring.inputs.radius - 0.02,
    );
    await settled(page);
  }));

test("what a selected node makes and takes is drawn over the model, and goes with the selection", () =>
  withPage({}, async (page) => {
    const plain = await picture(page);
    const geometries = Number(await canvasOf(page).getAttribute("data-geometries"));
    await selectNode(page, "boosted");
    await page.waitForFunction(
      (count) => Number(document.querySelector("canvas[role=img]").dataset.geometries) > count,
      geometries,
    );
    await changes(page, "hidden by its button", () => page.getByRole("button", { name: "Control geometry" }).click());
    await page.getByRole("button", { name: "Control geometry" }).click();
    await page.getByRole("region", { name: "Graph" }).click({ position: { x: 12, y: 320 } });
    await page.waitForFunction(
      (count) => Number(document.querySelector("canvas[role=img]").dataset.geometries) <= count,
      geometries,
    );
    await eventually(async () => (await picture(page)).equals(plain), true, "the picture from before");
  }));

test("a picture is saved as it is seen", () =>
  withPage({}, async (page) => {
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save a picture" }).click(),
    ]);
    assert.equal(download.suggestedFilename(), "boosted-ring.png");
    const bytes = readFileSync(await download.path());
    assert.equal(bytes.toString("latin1", 1, 4), "PNG");
    assert.ok(bytes.length > 5000);
  }));

test("the show has the model and its controls only, and Escape ends it", () =>
  withPage({}, async (page) => {
    await page.getByRole("button", { name: "Show", exact: true }).click();
    await page.locator(".graph-pane").waitFor({ state: "hidden" });
    await eventually(
      () => page.getByRole("region", { name: "Model" }).boundingBox(),
      ({ width, height }) => width > 1270 && height > 710,
    );
    const slider = page.getByRole("slider", { name: "Reach", exact: true });
    await changes(page, "controls work", async () => {
      await slider.press("PageUp");
      await settled(page);
    });
    await page.keyboard.press("Escape");
    await page.getByRole("region", { name: "Graph" }).waitFor();
  }));

test("the picture is drawn finely once it rests, and quickly while it moves", () =>
  withPage({}, async (page) => {
    await quiet(page);
    const pixels = () => canvasOf(page).evaluate((canvas) => canvas.width / canvas.clientWidth);
    assert.ok((await pixels()) > 1.5);
    const box = await still(canvasOf(page));
    await canvasOf(page).evaluate((canvas) => {
      window.seen = [];
      const look = () => window.seen.push(canvas.width / canvas.clientWidth);
      new MutationObserver(look).observe(canvas, { attributeFilter: ["data-frames"] });
    });
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 260, box.y + 200, { steps: 12 });
    await page.mouse.up();
    await page.waitForFunction(() => window.seen.includes(1));
    await quiet(page);
    assert.ok((await pixels()) > 1.5, "fine again");
    const frames = await canvasOf(page).getAttribute("data-frames");
    await new Promise((done) => setTimeout(done, 1000));
    assert.equal(await canvasOf(page).getAttribute("data-frames"), frames, "and then nothing is drawn");
  }));

test("a long evaluation says so and can be stopped", () =>
  withPage({}, async (page) => {
    let release;
    const held = new Promise((done) => (release = done));
    await page.route("**/v1/evaluate", async (route) => {
      await held;
      await route.continue().catch(() => undefined);
    });
    const { shown } = await factsOf(page);
    const slider = page.getByRole("slider", { name: "Reach", exact: true });
    await slider.press("PageUp");
    await page.getByText(/^Evaluating… \d+ s$/).waitFor();
    await page.getByRole("button", { name: "Stop", exact: true }).click();
    await page.getByText("The evaluation was stopped.").first().waitFor();
    assert.equal((await factsOf(page)).shown, shown);
    // The last picture stays.
    await covered(page, 0.03);
    release();
    await slider.press("PageUp");
    await settled(page);
  }));

/** What is counted does not depend on how many pixels are drawn. */
const SMALL_WINDOW = { width: 960, height: 540 };

test("nothing is drawn while nothing changes, and 500 updates leave nothing behind", { timeout: 600_000 }, () =>
  withPage(
    { ...SMALL_WINDOW, count: true, hash: `#g=${deflateRawSync(JSON.stringify(SMALL)).toString("base64url")}` },
    async (page) => {
      await selectNode(page, "boosted");
      await page.getByRole("radio", { name: "Lines" }).click();
      await page.getByRole("tab", { name: "Controls" }).click();
      const slider = page.getByRole("slider", { name: "Reach", exact: true });
      // In the page, because a call from outside takes longer than an update.
      const update = async (times) => {
        await slider.evaluate(async (element, steps) => {
          const facts = document.documentElement.dataset;
          for (let step = 0; step < steps; step++) {
            const key = step % 2 ? "ArrowLeft" : "ArrowRight";
            element.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
            do await new Promise((done) => requestAnimationFrame(done));
            while (facts.revision !== facts.shown);
          }
        }, times);
        await settled(page);
        await quiet(page);
      };
      const facts = () =>
        page.evaluate(() => ({
          ...document.querySelector("canvas[role=img]").dataset,
          ...window.counted,
          revision: document.documentElement.dataset.revision,
        }));
      await update(10);
      const first = await facts();
      await update(500);
      const last = await facts();
      assert.equal(Number(last.revision) - Number(first.revision), 500);
      assert.ok(Number(last.frames) - Number(first.frames) >= 500, "every update was drawn");
      assert.equal(last.geometries, first.geometries, "geometries");
      assert.equal(last.textures, first.textures, "textures");
      assert.equal(last.workers, 1, "workers");
      assert.ok(last.listeners <= first.listeners + 5, `listeners: ${first.listeners}, then ${last.listeners}`);
      await new Promise((done) => setTimeout(done, 1000));
      assert.equal((await facts()).frames, last.frames, "no frame without a reason");
    },
  ),
);

/** A page in which the decoder may complain, and nothing else. */
async function withBroken(run) {
  const hash = `#g=${deflateRawSync(JSON.stringify(SMALL)).toString("base64url")}`;
  const page = await openPage(used.browser, server.url, { hash });
  try {
    await run(page);
    const offences = (await page.offences()).filter((text) => !text.includes("THREE.DRACOLoader"));
    assert.deepEqual(offences, []);
  } finally {
    await page.context().close();
  }
}

test("a model that cannot be read says so and keeps the last one, and the next one is shown", () =>
  withBroken(async (page) => {
    await settled(page);
    const slider = page.getByRole("slider", { name: "Reach", exact: true });
    const { shown } = await factsOf(page);
    for (const damage of [
      // Behind the header and the description lies the compressed data.
      (bytes, at) =>
        bytes.fill(7, at + 12 + 8 + bytes.readUInt32LE(at + 12) + 8 + 16, at + bytes.readUInt32LE(at + 8) - 16),
      (bytes, at) => bytes.fill(0x20, at + 24, at + 200),
      (bytes, at) => bytes.writeUInt32LE(1, at + 4),
    ]) {
      await page.route("**/v1/evaluate", async (route) => {
        const response = await route.fetch();
        const body = await response.body();
        const at = body.indexOf("glTF");
        if (at >= 0) damage(body, at);
        await route.fulfill({ response, body });
      });
      const { revision } = await factsOf(page);
      await slider.press("ArrowRight");
      const facts = await eventually(
        () => factsOf(page),
        (now) => Number(now.revision) > Number(revision) && now.state === "error",
      );
      assert.equal(facts.shown, shown, "the last model stays");
      await page.locator(".view-problem", { hasText: "The model cannot be read" }).waitFor();
      await page.unroute("**/v1/evaluate");
    }
    await slider.press("ArrowRight");
    await settled(page);
    await page.locator(".view-problem").waitFor({ state: "detached" });
  }));

test("while the hand rests on the label of a parameter, the model has the colors of its motion", () =>
  withPage({}, async (page) => {
    await changes(page, "the hand on a label", () => page.locator(".parameter-label").first().hover());
    assert.equal(await canvasOf(page).getAttribute("data-sensitivity"), "true");
    await changes(page, "the hand gone", () => page.getByRole("button", { name: "Front", exact: true }).hover());
    await page.locator("canvas:not([data-sensitivity='true'])").first().waitFor();
  }));
