// Texts of a graph from elsewhere are shown as texts, wherever the page shows them: they run nothing, load nothing and
// become no elements.

import assert from "node:assert/strict";
import { test } from "node:test";
import { useServer, withCleanPage } from "./fixture.mjs";
import { eventually, settled } from "./harness.mjs";

const used = useServer();

const HOSTILE = [
  "<img src=x onerror=window.ran=1>",
  "<svg onload=window.ran=1>",
  '"><script>window.ran=1</script>',
  "javascript:window.ran=1",
  "\u202egnp.exe\u2066\u2069",
].join(" ");

/** A graph that says this wherever a graph may say something, and fails with it. */
const graphWith = (text) => ({
  format: 1,
  meta: { title: text, description: text, figure: text, author: text },
  parameters: {
    size: { type: "number", default: 1, min: 0, max: 2, label: text, description: text, unit: text },
    kind: { type: "choice", default: text, choices: [text, "other"], label: `${text} kind` },
  },
  nodes: {
    ball: { type: "sphere_mesh", inputs: { radius: { parameter: "size" } } },
    limit: { type: "check", inputs: { value: { parameter: "size" }, maximum: 0, message: text } },
    out: { type: "export", inputs: { model: { from: "ball" } } },
  },
  ui: { frames: [{ title: text, x: 0, y: 0, width: 400, height: 300, nodes: ["ball"] }] },
});

async function openFile(page, name, text) {
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.keyboard.press("Control+o")]);
  await chooser.setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
}

/** Opens the file in a page, lets `look` see it, and fails if anything of it was more than a text. */
const opened = (name, text, look) =>
  withCleanPage(used, { width: 1500, height: 900 }, async (page) => {
    const dialogs = [];
    page.on("dialog", (dialog) => {
      dialogs.push(dialog.message());
      return dialog.dismiss();
    });
    await settled(page);
    await openFile(page, name, text);
    await look(page);
    assert.deepEqual(dialogs, []);
    assert.equal(await page.evaluate(() => window.ran), undefined);
    const elements = 'img[src="x"], svg[onload], [onerror], a[href^="javascript:"], script:not([src])';
    assert.equal(await page.locator(elements).count(), 0, "elements made of texts");
  });

test("markup, addresses of scripts and marks of direction in a graph are shown as they are", () =>
  opened("graph.json", JSON.stringify(graphWith(HOSTILE)), async (page) => {
    await eventually(() => page.getByRole("textbox", { name: "Title of the graph" }).inputValue(), HOSTILE);
    await page.getByRole("tab", { name: /^Problems/ }).click();
    await page.getByRole("listitem").filter({ hasText: "<img src=x onerror=window.ran=1>" }).first().waitFor();
    await page.getByRole("tab", { name: "Controls" }).click();
    await page.getByText("<svg onload=window.ran=1>").first().waitFor();
  }));

test("a file with such a name and no graph in it is told of, its name as it is", () =>
  opened("<img src=x onerror=window.ran=1>.json", `{"${HOSTILE.replaceAll('"', "")}`, async (page) => {
    await page
      .getByText(/<img src=x onerror=window\.ran=1>/)
      .first()
      .waitFor();
  }));

test("a title of a megabyte leaves the page alive", () => {
  const graph = graphWith("size");
  graph.meta.title = "<b>".repeat(333_000);
  return opened("graph.json", JSON.stringify(graph), async (page) => {
    const title = page.getByRole("textbox", { name: "Title of the graph" });
    await eventually(async () => (await title.inputValue()).startsWith("<b><b>"), true);
    await title.fill("short");
    await title.press("Enter");
    await eventually(() => page.getByRole("heading", { level: 1 }).textContent(), "short");
  });
});
