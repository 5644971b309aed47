// Hands for the editor's tests: they add, connect and read graphs as a person does, by role and label.

import { withCleanPage } from "./fixture.mjs";
import { openPage, settled, wholeGraph } from "./harness.mjs";

/** A page whose clipboard may be used, and that keeps the graph it sent last: `page.graph()`. */
export async function openEditor(browser, url, options = {}) {
  const page = await openPage(browser, url, options);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"], { origin: new URL(url).origin });
  let sent;
  page.on("request", (request) => {
    if (/\/v1\/(validate|evaluate)$/.test(request.url()) && request.method() === "POST")
      sent = JSON.parse(request.postData() ?? "{}").graph ?? sent;
  });
  page.graph = () => sent;
  return page;
}

/** Runs a test in the editor of a clean page. */
export function withEditor(used, options, run) {
  const start = async (page) => {
    if (options.isEmpty) await emptyGraph(page);
    else {
      await settled(page);
      await wholeGraph(page);
    }
    await run(page);
  };
  return withCleanPage(used, options, start, openEditor);
}

export async function emptyGraph(page) {
  await page.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
  await page.getByRole("button", { name: "New graph" }).click();
  await page.getByText("An empty graph").waitFor();
}

/** Waits until the graph that was sent last fulfils the test. */
export async function untilGraph(page, test, what = test.toString()) {
  const limit = Date.now() + 15_000;
  const holds = () => {
    try {
      return test(page.graph());
    } catch {
      // What is looked at is not there yet.
      return false;
    }
  };
  while (!holds()) {
    if (Date.now() > limit) throw new Error(`The graph never came to be: ${what}\n${JSON.stringify(page.graph())}`);
    await page.waitForTimeout(25);
  }
  return page.graph();
}

export const pane = (page) => page.getByRole("region", { name: "Graph" });

/** A point of the canvas, from its corner. */
export async function at(page, x, y) {
  const box = await pane(page).boundingBox();
  return { x: box.x + x, y: box.y + y };
}

/** Adds a node by double-click and search. Answers its name. */
export async function addNode(page, text, x, y) {
  const place = await at(page, x, y);
  await page.mouse.dblclick(place.x, place.y);
  await page.getByRole("combobox", { name: "Add a node" }).fill(text);
  await page.keyboard.press("Enter");
  await page.getByRole("dialog", { name: "Add a node" }).waitFor({ state: "detached" });
  return selectedNode(page);
}

/** The name of the selected node, as the panel says it. */
export async function selectedNode(page) {
  const button = page.getByRole("button", { name: /^Rename / });
  await button.waitFor();
  return (await button.getAttribute("aria-label")).slice("Rename ".length);
}

export const node = (page, id) => pane(page).getByRole("group", { name: new RegExp(`, ${id}$`) });
export const input = (page, id, name) => node(page, id).getByRole("button", { name: new RegExp(`^Input ${name} of `) });
export const output = (page, id, name) =>
  node(page, id).getByRole("button", { name: new RegExp(`^Output ${name} of `) });

/** The middle of what a locator finds. */
export async function middle(locator) {
  await locator.waitFor();
  const box = await locator.boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Presses the left button at one place and lets it go at another. */
export async function drag(page, from, to, { steps = 8, hold } = {}) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 4, from.y + 2);
  await page.mouse.move(to.x, to.y, { steps });
  if (hold) await hold();
  await page.mouse.up();
}

/** Draws a wire from an output to an input. */
export async function wire(page, from, out, to, into) {
  await drag(page, await middle(output(page, from, out)), await middle(input(page, to, into)));
}

export async function undo(page) {
  await page.getByRole("button", { name: "Undo" }).click();
}

/** Selects one node by pressing on its title. */
export async function choose(page, id, modifiers = []) {
  const box = await node(page, id).boundingBox();
  for (const key of modifiers) await page.keyboard.down(key);
  await page.mouse.click(box.x + 40, box.y + 12);
  for (const key of modifiers) await page.keyboard.up(key);
}

export const said = (page, text) =>
  page.getByRole("status", { name: "Last action" }).filter({ hasText: text }).waitFor({ timeout: 5000 });
