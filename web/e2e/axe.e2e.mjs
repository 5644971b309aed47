// axe looks at the main states of the page, in both themes: nothing serious.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { openEditor } from "./editing.mjs";
import { RING, useServer } from "./fixture.mjs";
import { selectNode, settled } from "./harness.mjs";

const used = useServer();
const source = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds that is serious or worse: the rule, and the elements. */
async function findings(page) {
  const results = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return results.violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, help, nodes }) => ({ id, help, nodes: nodes.slice(0, 5).map(({ html }) => html.slice(0, 160)) }));
}

/** The main states, and the way to each from a ring that is open. */
const STATES = {
  "the editor": async () => undefined,
  "a selected node": (page) => selectNode(page, "skin"),
  "the search for a node": async (page) => {
    await page.getByRole("button", { name: "Add node" }).click();
    await page.getByRole("dialog", { name: "Add a node" }).waitFor();
  },
  "the examples": async (page) => {
    await page.getByRole("button", { name: "Examples" }).click();
    await page.getByRole("dialog", { name: "Examples" }).getByRole("listitem").first().waitFor();
  },
  "the export": async (page) => {
    await page.getByRole("button", { name: "Export", exact: true }).click();
    await page.getByRole("dialog", { name: "Export" }).getByText("no point off by more than").waitFor();
  },
  "the list of keys": async (page) => {
    await page.getByRole("button", { name: "Keys and pointer" }).click();
    await page.getByRole("dialog").waitFor();
  },
  "the player and variants": async (page) => {
    await page.getByRole("button", { name: "Keep as a variant" }).click();
    await page.getByRole("button", { name: "Play a parameter" }).click();
    await page.getByRole("button", { name: "Pause" }).click();
  },
  "the contact sheet": async (page) => {
    await page.getByRole("button", { name: "Contact sheet" }).click();
    await page.getByText("12 of 12 pictures").waitFor();
  },
  "curvature with its legend": (page) => page.getByRole("radio", { name: "Curvature" }).click(),
  "a problem": async (page) => {
    const field = page.getByRole("textbox", { name: / value$/ }).first();
    await field.fill("1e9");
    await field.press("Enter");
    await page.getByRole("tab", { name: /Problems/ }).click();
  },
};

for (const theme of ["dark", "light"]) {
  for (const [name, reach] of Object.entries(STATES)) {
    test(`${name} has nothing serious to hear from axe, ${theme}`, async () => {
      const page = await openEditor(used.browser, used.server.url, { hash: RING, theme, width: 1440, height: 900 });
      try {
        await settled(page);
        await page.evaluate(source);
        await reach(page);
        assert.deepEqual(await findings(page), []);
      } finally {
        await page.context().close();
      }
    });
  }
}
