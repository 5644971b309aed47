// Work is never lost without a word: storage that fails, reloads, what is pasted.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { choose, said, untilGraph, untilSelected, withEditor } from "./editing.mjs";
import { RING, useServer, withCleanPage, withRing } from "./fixture.mjs";
import { canvasOf, eventually, factsOf, openPage, saved, settled } from "./harness.mjs";

const used = useServer();

const withPage = (options, run) => withRing(used, options, run);

/** A page whose browser fails to store drafts as the script says. */
const withFailing = (script, run) =>
  withCleanPage(used, { hash: RING }, run, async (browser, url, options) => {
    const page = await openPage(browser, url, options);
    await page.addInitScript(script);
    await page.reload();
    await settled(page);
    return page;
  });

const full = () => {
  IDBObjectStore.prototype.put = () => {
    throw new DOMException("full", "QuotaExceededError");
  };
};
const forbidden = () => {
  for (const name of ["indexedDB", "localStorage", "sessionStorage"]) {
    Object.defineProperty(window, name, {
      get() {
        throw new DOMException("forbidden", "SecurityError");
      },
    });
  }
};
const failing = () => {
  IDBFactory.prototype.open = () => {
    const request = new EventTarget();
    setTimeout(() => request.onerror?.(new Event("error")));
    return request;
  };
};
const silent = () => {
  IDBFactory.prototype.open = () => new EventTarget();
};

const titleOf = (page) => page.getByRole("textbox", { name: "Title of the graph" });
const titled = (page, title) => eventually(() => titleOf(page).inputValue(), title, "the title");
const warning = (page) => page.getByRole("alert").filter({ hasText: "the browser stores no draft" });

async function rename(page, title) {
  await titleOf(page).fill(title);
  await titleOf(page).press("Enter");
}

/** Tries to leave the page and stays. Answers whether the page asked. */
async function asksBeforeLeaving(page) {
  let isAsked = false;
  const listener = async (dialog) => {
    isAsked = dialog.type() === "beforeunload";
    await dialog.dismiss();
  };
  page.on("dialog", listener);
  await page.evaluate(() => setTimeout(() => (location.href = "/healthz")));
  await eventually(() => isAsked, true, "a question before leaving");
  page.off("dialog", listener);
}

for (const [what, script, reason] of [
  ["that is full", full, "its storage is full"],
  ["that forbids storage", forbidden, "it does not allow storage"],
  ["whose storage cannot be opened", failing, "its storage fails"],
  ["whose storage never answers", silent, "its storage does not answer"],
]) {
  test(`a browser ${what} is named with the first change, and the page asks before it is left`, () =>
    withFailing(script, async (page) => {
      assert.equal(await warning(page).count(), 0, "nothing is at risk yet");
      await rename(page, "Fragile");
      await warning(page).filter({ hasText: reason }).waitFor();
      await asksBeforeLeaving(page);
      await titled(page, "Fragile");
      // Another document does not push it out.
      await page.getByRole("button", { name: "New graph" }).click();
      await page.getByText("An empty graph").waitFor();
      await page.getByRole("alert").filter({ hasText: "“Fragile” was not saved" }).waitFor();
      await asksBeforeLeaving(page);
      await page.getByRole("alert").getByRole("button", { name: "Recover…" }).click();
      await page
        .getByRole("dialog", { name: "Recover" })
        .getByRole("button", { name: "Open the draft Fragile" })
        .click();
      await titled(page, "Fragile");
      await rename(page, "Saved now");
      await warning(page).waitFor();
    }));
}

test("a saved graph is at no risk, also where the browser stores nothing", () =>
  withFailing(full, async (page) => {
    await rename(page, "Kept");
    await warning(page).waitFor();
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("alert").getByRole("button", { name: "Save" }).click(),
    ]);
    assert.equal(JSON.parse(readFileSync(await download.path(), "utf8")).meta.title, "Kept");
    await warning(page).waitFor({ state: "detached" });
    page.on("dialog", () => assert.fail("nothing would be lost"));
    await page.reload();
    await titled(page, "Kept");
  }));

test("after saving, a reload shows the same graph with its values, its camera and its file's name", () =>
  withPage({}, async (page) => {
    const reach = () => page.getByRole("textbox", { name: "Reach value", exact: true }).inputValue();
    const before = await reach();
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    const changed = await eventually(reach, (text) => text !== before);
    await rename(page, "Mine");
    const json = await saved(page);
    assert.ok(json.meta.camera, "the document has a camera");
    await page.getByText("saved", { exact: true }).waitFor();
    await page.reload();
    await settled(page);
    await titled(page, "Mine");
    assert.equal(await reach(), changed);
    await page.getByText("saved", { exact: true }).waitFor();
    const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+s")]);
    assert.equal(download.suggestedFilename(), "mine.json");
    assert.deepEqual(JSON.parse(readFileSync(await download.path(), "utf8")), json);
    // The default is still there to go back to, after reopening too.
    await page.getByRole("button", { name: "Reset Reach" }).click();
    await eventually(reach, before);
  }));

test("a graph that was opened, or begun, is there after a reload without having been changed", () =>
  withPage({}, async (page) => {
    const json = await saved(page);
    const text = JSON.stringify({ ...json, meta: { ...json.meta, title: "Opened" } });
    const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.keyboard.press("Control+o")]);
    await chooser.setFiles({ name: "opened.json", mimeType: "application/json", buffer: Buffer.from(text) });
    await titled(page, "Opened");
    await page.reload();
    await titled(page, "Opened");
    await page.getByRole("button", { name: "New graph" }).click();
    await page.getByText("An empty graph").waitFor();
    await page.reload();
    await page.getByText("An empty graph").waitFor();
    // Whoever asks for something else gets that.
    await page.goto(`${used.server.url}/?other${RING}`);
    await settled(page);
    await eventually(async () => (await factsOf(page)).example, "fig04_boosted_ring");
  }));

test("a shared link stays in the address and survives a reload, until the graph is changed", () =>
  withPage({}, async (page) => {
    const slider = page.getByRole("slider", { name: "Reach", exact: true });
    const reach = (from) => from.getByRole("textbox", { name: "Reach value", exact: true }).inputValue();
    await slider.press("PageUp");
    await rename(page, "Linked");
    await settled(page);
    const value = await reach(page);
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("menuitem", { name: "Link to this graph…" }).click();
    const link = page.getByRole("dialog", { name: "Share" }).getByRole("textbox", { name: "Link" });
    const hash = new URL(
      await eventually(
        () => link.inputValue(),
        (text) => text.includes("#g="),
      ),
    ).hash;
    await withPage({ hash }, async (other) => {
      for (let round = 0; round < 2; round++) {
        await titled(other, "Linked");
        assert.equal(new URL(other.url()).hash, hash);
        assert.equal(await reach(other), value);
        await other.reload();
        await settled(other);
      }
      await other.getByRole("button", { name: "Reset Reach" }).click();
      await eventually(() => new URL(other.url()).hash, "");
      await other.getByText("edited", { exact: true }).waitFor();
      await eventually(() => reach(other), "1");
      // Not even a change of the last moment is lost.
      await rename(other, "Changed");
      await other.reload();
      await settled(other);
      await titled(other, "Changed");
      assert.equal(await reach(other), "1");
    });
  }));

test("what is pasted brings the parameters that drive it, with their values, and tells of cut wires", () =>
  withEditor(used, { hash: RING, width: 1500, height: 900 }, async (page) => {
    await page.getByRole("textbox", { name: "Reach value", exact: true }).fill("1.75");
    await page.keyboard.press("Enter");
    await settled(page);
    const before = page.graph();
    const [driven] = Object.entries(before.nodes).find(([, item]) => JSON.stringify(item).includes('"reach"'));
    const wired = Object.entries(before.nodes).find(([, item]) => JSON.stringify(item).includes('"from":'));
    const links = JSON.stringify(wired[1]).match(/"from":"/g).length;
    await choose(page, driven);
    await choose(page, wired[0], ["Shift"]);
    await page.keyboard.press("Control+c");
    await said(page, "Copied 2 nodes");
    await page.getByRole("button", { name: "New graph" }).click();
    await page.getByText("An empty graph").waitFor();
    await page.mouse.move(300, 300);
    await page.keyboard.press("Control+v");
    await said(page, "with the parameter Reach");
    const among = wired[0] === driven ? 0 : JSON.stringify(wired[1]).split(`"from":"${driven}"`).length - 1;
    if (links > among) await said(page, `${links - among} incoming wire`);
    const after = await untilGraph(page, ({ nodes }) => nodes[driven] !== undefined);
    assert.deepEqual(after.nodes[driven], before.nodes[driven]);
    assert.deepEqual(after.parameters.reach, before.parameters.reach, "the default is what it was");
    const value = page.getByRole("textbox", { name: "Reach value", exact: true });
    await page.getByRole("tab", { name: "Controls" }).click();
    await eventually(() => value.inputValue(), "1.75");
    // All of it is one step.
    await page.getByRole("button", { name: "Undo" }).click();
    await untilGraph(page, ({ nodes, parameters }) => Object.keys({ ...nodes, ...parameters }).length === 0);
    // A parameter of the same name that is another one is left alone.
    await page.evaluate(() =>
      navigator.clipboard.writeText(
        JSON.stringify({
          format: 1,
          parameters: { reach: { type: "number", default: 9 } },
          nodes: { n: { type: "number", inputs: { value: { parameter: "reach" } } } },
        }),
      ),
    );
    await page.mouse.move(300, 300);
    await page.keyboard.press("Control+v");
    await untilGraph(page, ({ nodes }) => nodes.n !== undefined);
    await page.evaluate(() =>
      navigator.clipboard.writeText(
        JSON.stringify({
          format: 1,
          parameters: { reach: { type: "number", default: 5, max: 6 } },
          nodes: { m: { type: "number", inputs: { value: { parameter: "reach" } } } },
        }),
      ),
    );
    await page.keyboard.press("Control+v");
    const both = await untilGraph(page, ({ nodes }) => nodes.m !== undefined);
    assert.equal(both.parameters[both.nodes.n.inputs.value.parameter].default, 9);
    assert.equal(both.parameters[both.nodes.m.inputs.value.parameter].default, 5);
    await page.evaluate(() =>
      navigator.clipboard.writeText(
        JSON.stringify({ format: 1, nodes: { k: { type: "number", inputs: { value: { parameter: "nowhere" } } } } }),
      ),
    );
    await page.keyboard.press("Control+v");
    await said(page, "value of k lost the parameter nowhere, which this graph does not have");
  }));

test("a reload looks from where the camera stood, at what was selected, and Home still leads to the graph's own view", () =>
  withEditor(used, { hash: RING, width: 1500, height: 900 }, async (page) => {
    await choose(page, "ring");
    const eye = () => canvasOf(page).getAttribute("data-eye");
    const home = await eye();
    await canvasOf(page).press("ArrowLeft");
    const turned = await eventually(eye, (place) => place !== home);
    await page.reload();
    await settled(page);
    await untilSelected(page, ["ring"]);
    await eventually(eye, turned, "the place of the camera before the reload");
    await page.getByRole("button", { name: "Home view" }).click();
    await eventually(eye, home, "the graph's own view");
  }));

test("another graph over unsaved work says where that is, and leads back to it", () =>
  withPage({}, async (page) => {
    await rename(page, "Left behind");
    await page.getByRole("button", { name: "New graph" }).click();
    const note = page.getByRole("status").filter({ hasText: "“Left behind” was not saved" });
    await note.getByRole("button", { name: "Go back to it" }).click();
    await titled(page, "Left behind");
    // What is as it was opened is not lost, and nothing is said of it.
    await page.getByRole("button", { name: "New graph" }).click();
    await page.getByText("An empty graph").waitFor();
    await page.getByRole("button", { name: "File", exact: true }).click();
    await page.getByRole("menuitem", { name: "Recover…" }).click();
    const draft = page.getByRole("dialog", { name: "Recover" }).getByRole("listitem", { name: "Left behind" });
    await draft.locator("img").waitFor();
    await draft.getByRole("button", { name: "Delete the draft Left behind" }).waitFor();
    await draft.getByRole("button", { name: "Open the draft Left behind" }).click();
    await titled(page, "Left behind");
  }));
