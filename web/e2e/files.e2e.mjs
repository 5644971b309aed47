// Files: saving and opening, drafts, links, dropping, importing.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { RING, useServer, withCleanPage, withRing } from "./fixture.mjs";
import { eventually, factsOf, saved, settled } from "./harness.mjs";

const OBJ = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const used = useServer();
const { server } = used;

const withPage = (options, run) => withRing(used, options, run);

/** Waits until the graph has this title. */
const titled = (page, title) => eventually(() => titleOf(page).inputValue(), title, "the title");
const titleOf = (page) => page.getByRole("textbox", { name: "Title of the graph" });

async function rename(page, title) {
  await titleOf(page).fill(title);
  await titleOf(page).press("Enter");
}

async function openFile(page, name, text) {
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.keyboard.press("Control+o")]);
  await chooser.setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
}

/** Drops a file on the page as a file manager would. */
async function drop(page, name, bytes) {
  await page.evaluate(
    ({ name, data }) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0))], name));
      for (const type of ["dragenter", "dragover", "drop"]) {
        document.body.dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
      }
    },
    { name, data: Buffer.from(bytes).toString("base64") },
  );
}

const note = (page, text) => page.getByRole("status").filter({ hasText: text }).waitFor();

/** The drafts as the browser keeps them. */
const draftsOf = (page) =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const request = indexedDB.open("dini", 1);
        request.onsuccess = () => {
          const all = request.result.transaction("drafts").objectStore("drafts").getAll();
          all.onsuccess = () => {
            request.result.close();
            done(all.result);
          };
        };
      }),
  );

/** Waits until a draft with this title is kept. */
async function draftTitled(page, title) {
  const find = async () => (await draftsOf(page)).find((one) => one.title === title);
  return eventually(find, Boolean, `a draft ${title}`);
}

/** Waits until there is no draft. */
const noDrafts = (page) => eventually(async () => (await draftsOf(page)).map((one) => one.title), [], "the drafts");

/** Deletes a draft from the list of them. */
async function forget(page, title) {
  await page.getByRole("button", { name: "File", exact: true }).click();
  await page.getByRole("menuitem", { name: "Recover…" }).click();
  const dialog = page.getByRole("dialog", { name: "Recover" });
  await dialog
    .getByRole("button", { name: `Delete the draft ${title}` })
    .first()
    .click();
  await dialog.getByRole("button", { name: "Close" }).first().click();
  await dialog.waitFor({ state: "detached" });
}

test("what is saved, opened and saved again is the same, and keeps its file's name", () =>
  withPage({}, async (page) => {
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    await rename(page, "Mine & <b>yours</b>");
    await settled(page);
    const triangles = () => page.getByLabel("Statistics").getByText("triangles").textContent();
    const before = await triangles();
    const first = await saved(page);
    assert.equal(first.meta.title, "Mine & <b>yours</b>");
    assert.equal(first.parameters.reach.default, 1, "the default stays");
    assert.ok(first.ui.values.reach > 1, "the slider's value is beside it");
    const given = { ...first, meta: { ...first.meta, title: "Given" } };
    await openFile(page, "my graph.json", JSON.stringify(given));
    await page.waitForFunction(() => document.title.startsWith("Given"));
    await settled(page);
    await eventually(triangles, before);
    const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
    assert.equal(download.suggestedFilename(), "my graph.json");
    assert.deepEqual(JSON.parse(readFileSync(await download.path(), "utf8")), given);
    // The address does not name an example any more.
    await eventually(() => new URL(page.url()).hash, "");
    assert.equal(await page.locator("b").count(), 0, "markup is shown as text");
  }));

test("what was not saved is open again after a reload, is listed, and goes when it is saved", () =>
  withPage({}, async (page) => {
    await rename(page, "Unsaved work");
    await draftTitled(page, "Unsaved work");
    // Also after a second reload.
    for (let round = 0; round < 2; round++) {
      await Promise.all([note(page, "“Unsaved work” is open again"), page.reload()]);
      await settled(page);
      await titled(page, "Unsaved work");
      await eventually(async () => (await draftTitled(page, "Unsaved work")).address, "");
    }
    await rename(page, "More work");
    const draft = await draftTitled(page, "More work");
    const same = async () => (await draftsOf(page)).filter((one) => one.id === draft.id).length;
    await eventually(same, 1);
    // Another document takes its place; the draft is still there.
    await page.getByRole("button", { name: "File", exact: true }).click();
    await page.getByRole("menuitem", { name: "New" }).click();
    await page.waitForFunction(() => document.title !== "More work · Dini");
    await page.getByRole("button", { name: "File", exact: true }).click();
    await page.getByRole("menuitem", { name: "Recover…" }).click();
    const dialog = page.getByRole("dialog", { name: "Recover" });
    await dialog.getByRole("button", { name: "Open the draft More work" }).click();
    await settled(page);
    await titled(page, "More work");
    await rename(page, "Saved work");
    await draftTitled(page, "Saved work");
    await saved(page);
    await noDrafts(page);
  }));

test("a slider's value is kept over a reload, and its draft goes when the slider is back", () =>
  withPage({}, async (page) => {
    const slider = page.getByRole("slider", { name: "Reach", exact: true });
    const value = () => page.getByRole("textbox", { name: "Reach value", exact: true }).inputValue();
    const before = await value();
    await slider.press("PageUp");
    await page.getByText("edited", { exact: true }).waitFor();
    await draftTitled(page, "Boosted ring");
    const changed = await eventually(value, (text) => text !== before);
    await Promise.all([note(page, "“Boosted ring” is open again"), page.reload()]);
    await settled(page);
    await eventually(value, changed);
    await page.goto(`${server.url}/?again${RING}`);
    await settled(page);
    // The example itself is as it was.
    await eventually(value, before);
    for (const draft of await draftsOf(page)) await forget(page, draft.title);
    await slider.press("PageUp");
    await draftTitled(page, "Boosted ring");
    await slider.press("PageDown");
    await page.getByText("example", { exact: true }).waitFor();
    await noDrafts(page);
  }));

test("a draft never takes the place of an example that is asked for", () =>
  withPage({}, async (page) => {
    await rename(page, "Not this");
    await draftTitled(page, "Not this");
    await page.goto(`${server.url}/?fresh#example=fig02_boosted_circle`);
    await settled(page);
    await eventually(async () => (await factsOf(page)).example, "fig02_boosted_circle");
  }));

test("dropped graphs open, and what cannot be opened says why and changes nothing", () =>
  withPage({}, async (page) => {
    const graph = JSON.parse(
      readFileSync(new URL("../../examples/fig02_boosted_circle.json", import.meta.url), "utf8"),
    );
    graph.meta.title = "Dropped";
    await drop(page, "dropped.json", JSON.stringify(graph));
    await page.waitForFunction(() => document.documentElement.dataset.example === "");
    await settled(page);
    await titled(page, "Dropped");
    for (const [name, text, message] of [
      ["a.json", "{", "it is not JSON"],
      ["b.json", "[]", "a JSON object was expected"],
      ["c.json", '{"format":99,"nodes":{}}', "format 99"],
      ["d.json", '{"hello":1}', "no format number"],
      ["e.glb", "no model", "This is no GLB file"],
    ]) {
      await drop(page, name, text);
      await note(page, message);
    }
    assert.equal(await titleOf(page).inputValue(), "Dropped");
  }));

test("a byte order mark before a graph is no part of it, wherever the graph comes from", () =>
  withPage({ clipboard: true }, async (page) => {
    const mark = "\uFEFF";
    const graph = JSON.parse(
      readFileSync(new URL("../../examples/fig02_boosted_circle.json", import.meta.url), "utf8"),
    );
    const text = (title) => mark + JSON.stringify({ ...graph, meta: { ...graph.meta, title } });
    await openFile(page, "opened.json", text("Opened"));
    await titled(page, "Opened");
    await drop(page, "dropped.json", text("Dropped"));
    await titled(page, "Dropped");
    const packed = deflateRawSync(text("Linked")).toString("base64url");
    await withPage({ hash: `#g=${packed}` }, (other) => titled(other, "Linked"));
    await page.getByRole("button", { name: "New graph" }).click();
    await page.getByText("An empty graph").waitFor();
    await page.evaluate((copied) => navigator.clipboard.writeText(copied), text("Copied"));
    await page.getByRole("button", { name: "Edit", exact: true }).click();
    await page.getByRole("menuitem", { name: /^Paste Ctrl/ }).click();
    const pasted = () =>
      page.locator(".react-flow__node-graph").evaluateAll((list) => list.map((item) => item.dataset.id));
    await eventually(pasted, (ids) => ids.length === Object.keys(graph.nodes).length);
    await drop(page, "wide.json", Buffer.from(mark + JSON.stringify(graph), "utf16le"));
    await note(page, "wide.json is no graph: it is not text in UTF-8");
  }));

test("a model of ours opens its graph, or says that it holds only a hash", () =>
  withPage({}, async (page) => {
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    await settled(page);
    const json = await saved(page);
    await page.getByRole("button", { name: "Export", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: "Export" });
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      dialog.getByRole("button", { name: /^Download boosted-ring.glb/ }).click(),
    ]);
    const model = readFileSync(await download.path());
    await page.getByRole("button", { name: "New graph" }).click();
    await page.waitForFunction(() => !document.title.startsWith("Boosted ring"));
    await drop(page, "boosted-ring.glb", model);
    await page.waitForFunction(() => document.title.startsWith("Boosted ring"));
    await settled(page);
    assert.deepEqual(await saved(page), json);
    const sample = readFileSync(new URL("../test/data/sample.glb", import.meta.url));
    await drop(page, "sample.glb", sample);
    await note(page, "names its graph only by its hash");
  }));

test("a dropped mesh is sent to the server and becomes a node that is seen", () =>
  withPage({ clipboard: true }, async (page) => {
    const before = await saved(page);
    await drop(page, "tetrahedron.obj", OBJ);
    await note(page, "Imported tetrahedron.obj");
    await settled(page);
    const after = await saved(page);
    const [id] = Object.keys(after.nodes).filter((name) => !(name in before.nodes));
    assert.ok(
      Object.values(after.nodes[id].inputs).some((value) => /^[0-9a-f]{64}$/.test(value)),
      JSON.stringify(after.nodes[id]),
    );
    assert.equal(after.ui.nodes[id].preview, true);
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("menuitem", { name: "Copy as dini eval" }).click();
    await note(page, "Copied");
    const command = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(command, /^dini eval \S+ --asset tetrahedron=tetrahedron\.obj -o boosted-ring\.glb/);
    await drop(page, "broken.obj", "v 1 2\nf 1 2 3\n");
    await note(page, "broken.obj was not imported");
  }));

test("a mesh dropped on an empty graph is shown at once", () =>
  withPage({}, async (page) => {
    await page.getByRole("button", { name: "New graph" }).click();
    await drop(page, "tetrahedron.obj", OBJ);
    await note(page, "Imported tetrahedron.obj");
    await settled(page);
    await eventually(
      () => page.getByLabel("Statistics").textContent(),
      (text) => /^4 triangles/.test(text),
    );
  }));

test("a link opens what was shared, and hostile links open nothing", () =>
  withPage({}, async (page) => {
    await rename(page, "Shared ⚙ ring");
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    await settled(page);
    const json = await saved(page);
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("menuitem", { name: "Link to this graph…" }).click();
    const share = page.getByRole("dialog", { name: "Share" });
    const link = await eventually(
      () => share.getByRole("textbox", { name: "Link" }).inputValue(),
      (text) => text.length < 8000 && new URL(text).hash.startsWith("#g="),
    );
    await share.getByRole("button", { name: "Close" }).click();
    await withPage({ hash: new URL(link).hash }, async (other) => {
      await titled(other, "Shared ⚙ ring");
      assert.deepEqual(await saved(other), json);
    });
    for (const packed of ["AAAA", "%22", deflateRawSync(Buffer.alloc(3e7)).toString("base64url")]) {
      await withCleanPage(used, { hash: `#g=${packed}` }, async (other) => {
        await note(other, /link/);
        await settled(other);
        await eventually(
          () => factsOf(other),
          ({ example }) => example !== "",
        );
      });
    }
  }));

test("a graph too large for a link is offered as a file", () =>
  withPage({}, async (page) => {
    const graph = await saved(page);
    // Text that does not shrink.
    graph.meta.description = Array.from({ length: 1500 }, (_, at) => Math.sin(at).toString(36).slice(3)).join("");
    await openFile(page, "large.json", JSON.stringify(graph));
    await page.waitForFunction(() => document.documentElement.dataset.example === "");
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("menuitem", { name: "Link to this graph…" }).click();
    const dialog = page.getByRole("dialog", { name: "Share" });
    await dialog.getByText("too large for a link").waitFor();
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      dialog.getByRole("button", { name: "Save as a file" }).click(),
    ]);
    assert.equal(download.suggestedFilename(), "large.json");
  }));

test("an edited graph is copied as commands that hold it", () =>
  withPage({ clipboard: true }, async (page) => {
    const copied = async (name) => {
      await page.evaluate(() => navigator.clipboard.writeText(""));
      await page.getByRole("button", { name: "Share", exact: true }).click();
      await page.getByRole("menuitem", { name }).click();
      await note(page, "Copied");
      return eventually(() => page.evaluate(() => navigator.clipboard.readText()), Boolean, "a text on the clipboard");
    };
    assert.match(
      await copied("Copy as dini eval"),
      /^dini eval examples\/fig04_boosted_ring\.json -o boosted-ring\.glb$/,
    );
    await rename(page, "It's mine");
    const command = await copied("Copy as dini eval");
    assert.match(command, /^dini eval - -o it-s-mine\.glb <<'GRAPH'\n\{.*\}\nGRAPH$/);
    assert.equal(JSON.parse(command.split("\n")[1]).meta.title, "It's mine");
    const curl = await copied("Copy as curl");
    assert.ok(curl.startsWith(`curl -sf ${server.url}/v1/evaluate`) && curl.includes("It'\\''s mine"));
  }));
