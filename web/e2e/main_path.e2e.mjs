// The main path in a browser: open an example, see it, change it, be told what is wrong, take it away as a file.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { untilApart } from "./editing.mjs";
import { useServer, withCleanPage } from "./fixture.mjs";
import { covered, eventually, factsOf, picture, settled, still, turnWheel } from "./harness.mjs";

const RING = "fig04_boosted_ring";
let ring;
let count;
const used = useServer(async ({ url }) => {
  const { examples } = await (await fetch(`${url}/v1/examples`)).json();
  count = examples.length;
  ring = examples.find((item) => item.id === RING);
});

/** The first number parameter with a range: the one the tests drag and mistype. */
function rangedParameter() {
  const [name, item] = Object.entries(ring.graph.parameters).find(
    ([, one]) => one.type === "number" && one.min !== undefined && one.max !== undefined,
  );
  return { name, label: item.label ?? name, ...item };
}

const withPage = (options, run) => withCleanPage(used, options, run);

test("the page opens with a finished example, and the gallery opens another", () =>
  withPage({}, async (page) => {
    await settled(page);
    await covered(page, 0.05, 0.95);
    await page.getByRole("button", { name: "Examples" }).click();
    const gallery = page.getByRole("navigation", { name: "Examples" });
    await eventually(() => gallery.getByRole("listitem").count(), count);
    // It lies over the page, five beside each other where there is room, and is searched.
    await gallery.getByRole("searchbox", { name: "Find an example" }).fill("no such thing");
    await gallery.getByText("No example says “no such thing”.").waitFor();
    await gallery.getByRole("searchbox", { name: "Find an example" }).fill(ring.title.toLowerCase());
    await gallery.getByRole("button", { name: new RegExp(`^${ring.title}`) }).click();
    await gallery.waitFor({ state: "detached" });
    await page.waitForFunction((id) => location.hash === `#example=${id}`, RING);
    await settled(page);
    await eventually(() => page.getByRole("heading", { level: 1 }).textContent(), ring.title);
    await covered(page, 0.05, 0.95);
  }));

test("the gallery shows a picture of every example", () =>
  withPage({}, async (page) => {
    await settled(page);
    await page.getByRole("button", { name: "Examples" }).click();
    await page.waitForFunction((all) => document.querySelectorAll(".card-picture img").length === all, count);
    await page.waitForFunction(() =>
      [...document.querySelectorAll(".card-picture img")].every((image) => image.complete && image.naturalWidth > 0),
    );
  }));

test("an address opens its example, drawn as a graph of named nodes and sockets", () =>
  withPage({ hash: `#example=${RING}` }, async (page) => {
    await settled(page);
    const graph = page.getByRole("region", { name: "Graph" });
    const nodes = Object.keys(ring.graph.nodes);
    for (const id of nodes) await graph.getByRole("group", { name: new RegExp(`, ${id}$`) }).waitFor();
    await graph
      .getByRole("button", { name: /^Output .* of / })
      .nth(nodes.length - 1)
      .waitFor();
    await graph
      .getByRole("button", { name: /^Input .* of / })
      .first()
      .waitFor();
    await untilApart(page);
  }));

test("dragging a slider ends at its final value in full quality", () =>
  withPage({ hash: `#example=${RING}` }, async (page) => {
    await settled(page);
    const parameter = rangedParameter();
    const slider = page.getByRole("slider", { name: parameter.label, exact: true });
    const box = await still(slider);
    const middle = box.y + box.height / 2;
    const before = Number((await factsOf(page)).revision);
    const pictureBefore = await picture(page);
    await page.mouse.move(box.x + box.width * 0.3, middle);
    await page.mouse.down();
    for (let step = 1; step <= 30; step++) {
      const now = await slider.getAttribute("aria-valuenow");
      await page.mouse.move(box.x + box.width * (0.3 + 0.015 * step), middle);
      // A browser that is behind makes one move out of several.
      await eventually(
        () => slider.getAttribute("aria-valuenow"),
        (value) => value !== now,
        "a slider that moves",
      );
    }
    await page.mouse.up();
    await settled(page);
    const facts = await factsOf(page);
    assert.ok(Number(facts.revision) >= before + 20, `revision ${facts.revision} after ${before}`);
    assert.equal(facts.shown, facts.revision);
    const value = Number(await slider.getAttribute("aria-valuenow"));
    const expected = parameter.min + 0.75 * (parameter.max - parameter.min);
    assert.ok(Math.abs(value - expected) < 0.02 * (parameter.max - parameter.min), `${value}, expected ${expected}`);
    await eventually(
      () => picture(page),
      (after) => !after.equals(pictureBefore),
      "another picture",
    );
  }));

test("a typed formula is a value, and the wheel never changes one", () =>
  withPage({ hash: `#example=${RING}` }, async (page) => {
    await settled(page);
    const parameter = rangedParameter();
    const field = page.getByRole("textbox", { name: `${parameter.label} value` });
    await field.click();
    await field.fill(`(${parameter.min}+${parameter.max})/2`);
    await field.press("Enter");
    await settled(page);
    const middle = String((parameter.min + parameter.max) / 2);
    await eventually(() => field.inputValue(), middle);
    await field.hover();
    await turnWheel(page, 300);
    await page.getByRole("slider", { name: parameter.label, exact: true }).hover();
    await turnWheel(page, 300);
    assert.equal(await field.inputValue(), middle);
    await field.fill("nonsense");
    await field.press("Enter");
    await page.getByRole("alert").filter({ hasText: "is not a number" }).waitFor();
    await page.getByRole("button", { name: `Reset ${parameter.label}` }).click();
    await settled(page);
    await eventually(async () => Number(await field.inputValue()), parameter.default);
    await eventually(() => page.getByRole("alert").count(), 0);
  }));

test("a value out of range is refused next to its field, and the last picture stays", () =>
  withPage({ hash: `#example=${RING}` }, async (page) => {
    await settled(page);
    const parameter = rangedParameter();
    const { shown } = await factsOf(page);
    const field = page.getByRole("textbox", { name: `${parameter.label} value` });
    await field.click();
    await field.fill(String(parameter.max + 5));
    await field.press("Enter");
    const alert = page.locator(`[data-parameter="${parameter.name}"]`).getByRole("alert");
    await alert.getByText(String(parameter.max + 5)).waitFor();
    await eventually(() => field.getAttribute("aria-invalid"), "true");
    const described = async () => (await field.getAttribute("aria-describedby")).split(" ");
    const id = await alert.getAttribute("id");
    await eventually(described, (names) => names.includes(id));
    await page.waitForFunction(() => document.documentElement.dataset.state === "error");
    assert.equal((await factsOf(page)).shown, shown);
    const stale = () => page.getByRole("region", { name: "Model" }).getAttribute("data-stale");
    await eventually(stale, "true");
    await covered(page, 0.04);
    await page.getByRole("tab", { name: /Problems/ }).click();
    await page
      .getByRole("tabpanel", { name: /Problems/ })
      .getByText(String(parameter.max + 5))
      .waitFor();
    await page.getByRole("tab", { name: "Controls" }).click();
    await page.getByRole("slider", { name: parameter.label, exact: true }).press("Home");
    await settled(page);
    await eventually(() => alert.count(), 0);
    await eventually(stale, "false");
  }));

test("the export says what it makes before it is downloaded, as a GLB in full quality", () =>
  withPage({ hash: `#example=${RING}` }, async (page) => {
    await settled(page);
    await page.getByRole("button", { name: "Export", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: "Export" });
    const result = dialog.getByRole("status").filter({ hasText: /kB · .* triangles · no point off by more than/ });
    await result.waitFor();
    const before = await result.textContent();
    // How exact it is, in millimeters and not in bits: the coarsest.
    const precision = dialog.getByRole("combobox", { name: "Position precision" });
    const choices = precision.locator("option");
    await eventually(
      () => choices.first().textContent(),
      (text) => /^within [\d.]+\s(mm|m)$/.test(text),
    );
    assert.match(await precision.locator("option:checked").textContent(), /^within .*, the usual$/);
    await precision.selectOption({ index: 0 });
    await page.waitForFunction((text) => {
      const now = document.querySelector(".export-result")?.textContent ?? "";
      return now !== text && now.includes("triangles");
    }, before);
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      dialog.getByRole("button", { name: /^Download boosted-ring.glb/ }).click(),
    ]);
    assert.match(download.suggestedFilename(), /^[a-z0-9-]+\.glb$/);
    const bytes = readFileSync(await download.path());
    assert.equal(bytes.toString("latin1", 0, 4), "glTF");
    assert.equal(bytes.readUInt32LE(8), bytes.length);
    await dialog.waitFor({ state: "detached" });
    assert.equal((await factsOf(page)).revision, "1", "the graph is as it was");
  }));

test("the export writes the formats that the server lists, and the graph", () =>
  withPage({ hash: `#example=${RING}` }, async (page) => {
    await settled(page);
    await page.getByRole("button", { name: "Export", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: "Export" });
    const format = dialog.getByRole("combobox", { name: "Format" });
    const formats = await format.locator("option").evaluateAll((options) => options.map(({ value }) => value));
    assert.deepEqual(formats, ["glb", "gltf", "obj", "stl", "ply", "3mf", "svg", "json"]);
    await format.selectOption("stl");
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      dialog.getByRole("button", { name: "Download boosted-ring.stl" }).click(),
    ]);
    const model = readFileSync(await download.path());
    assert.equal(model.length, 84 + 50 * model.readUInt32LE(80));
  }));

test("the export tells whether a model can be printed, part by part, and again of another quality", () =>
  withPage({ hash: "#example=object_ring" }, async (page) => {
    await settled(page);
    await page.getByRole("button", { name: "Export", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: "Export" });
    const check = dialog.getByRole("region", { name: "Check for printing" });
    await check.getByRole("button", { name: "Check for printing" }).click();
    await check.getByText("It is closed and meets itself nowhere.").waitFor();
    const cells = await check.getByRole("row", { name: /^gold/ }).getByRole("cell").allTextContents();
    assert.deepEqual(cells.slice(0, 3), ["closed", "1", "nowhere"]);
    assert.match(cells.slice(3).join(", "), /^\d+\u202fmm, [\d.]+\u202fm³$/);
    await dialog.getByRole("combobox", { name: "Quality" }).selectOption("draft");
    await check.getByRole("button", { name: "Check for printing" }).waitFor();
  }));

test("the export says that an open surface cannot be printed", () =>
  withPage({ hash: "#example=fig11_patch" }, async (page) => {
    await settled(page);
    await page.getByRole("button", { name: "Export", exact: true }).click();
    const check = page.getByRole("region", { name: "Check for printing" });
    await check.getByRole("button", { name: "Check for printing" }).click();
    await check.getByText("What is open cannot be printed.").waitFor();
    await check
      .getByRole("cell", { name: /^open, 1 border/ })
      .first()
      .waitFor();
  }));
