// Checks: a model never goes because one cannot run or fails, and what is wrong is said.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, choose, inPanel, node, wire, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, factsOf, openPage, settled } from "./harness.mjs";

const RING = "#example=fig04_boosted_ring";
const used = useServer();
const ring = (run) => withEditor(used, { hash: RING, width: 1500, height: 900 }, run);

/** Answers as a server does for which a check without a value fails the whole evaluation. */
async function refuseUnwiredChecks(page) {
  await page.route("**/v1/evaluate", async (route) => {
    const { graph } = route.request().postDataJSON();
    const broken = Object.entries(graph.nodes).filter(
      ([, { type, inputs }]) => type === "check" && inputs.value === undefined,
    );
    if (broken.length === 0) return route.continue();
    const errors = broken.map(([id]) => ({
      code: "check-failed",
      node: id,
      detail: `${id} cannot run: it has no value.`,
    }));
    const body = {
      type: "/problems/check-failed",
      title: "A check failed",
      status: 422,
      detail: "",
      errors,
      blocked: [],
    };
    return route.fulfill({ status: 422, contentType: "application/problem+json", body: JSON.stringify(body) });
  });
}

const message = (page, id) => node(page, id).locator(".node-message");
const problems = (page) => page.getByRole("tabpanel", { name: /^Problems/ }).getByRole("listitem");

test("adding a check leaves the model as it is and alive, and says what the check needs", () =>
  ring(async (page) => {
    await refuseUnwiredChecks(page);
    const id = await addNode(page, "check", 300, 520);
    await message(page, id).filter({ hasText: "value" }).waitFor();
    await settled(page);
    const { revision } = await factsOf(page);
    assert.equal(await page.locator('.view-pane[data-stale="true"]').count(), 0, "nothing is out of date");
    await page.getByRole("tab", { name: "Controls" }).click();
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    await eventually(async () => Number((await factsOf(page)).shown) > Number(revision), true, "another model");
    await settled(page);
    await page.getByRole("tab", { name: /^Problems/ }).click();
    // One problem of one node is one entry.
    await eventually(() => problems(page).count(), 1);
    await problems(page).filter({ hasText: "Check (check)" }).waitFor();
  }));

test("a check that fails is red and listed, and the model goes on", () =>
  ring(async (page) => {
    const id = await addNode(page, "check", 300, 520);
    await addNode(page, "number", 120, 620);
    await wire(page, "number", "value", id, "value");
    await choose(page, id);
    await inPanel(page, id);
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await panel.getByRole("textbox", { name: "minimum of Check" }).fill("5");
    await page.keyboard.press("Enter");
    await page.locator(`[data-id="${id}"] .node[data-tone="error"] .node-message`).waitFor();
    await settled(page);
    assert.equal(await page.locator('.view-pane[data-stale="true"]').count(), 0, "nothing is out of date");
    await page.getByRole("tab", { name: /^Problems/ }).click();
    await eventually(() => problems(page).count(), 1);
    // It is the check alone that keeps its node from being red.
    await choose(page, "number");
    await inPanel(page, "number");
    await panel.getByRole("textbox", { name: "value of Number" }).fill("7");
    await page.keyboard.press("Enter");
    await page.locator(`[data-id="${id}"] .node[data-tone="error"]`).waitFor({ state: "detached" });
    await settled(page);
  }));

test("a graph whose check cannot run opens with its model", () =>
  ring(async (page) => {
    const graph = page.graph();
    const broken = { ...graph, nodes: { ...graph.nodes, guard: { type: "check", inputs: {} } } };
    const other = await openPage(used.browser, used.server.url, {});
    try {
      await settled(other);
      await refuseUnwiredChecks(other);
      const [chooser] = await Promise.all([other.waitForEvent("filechooser"), other.keyboard.press("Control+o")]);
      const buffer = Buffer.from(JSON.stringify(broken));
      await chooser.setFiles({ name: "broken.json", mimeType: "application/json", buffer });
      await message(other, "guard").waitFor();
      await settled(other);
      await other.getByLabel("Statistics").waitFor();
    } finally {
      await other.context().close();
    }
  }));
