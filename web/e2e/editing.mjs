// Hands for the editor's tests: they add, connect and read graphs as a person does, by role and label.

import { withCleanPage } from "./fixture.mjs";
import { eventually, openPage, settled, still, wholeGraph } from "./harness.mjs";

/** A page whose clipboard may be used, and that keeps the graph it sent last: `page.graph()`. */
export async function openEditor(browser, url, options = {}) {
  let sent;
  // The page sends its graph as soon as it is there, so whoever listens later may have missed it.
  const beforeOpening = (page) =>
    page.on("request", (request) => {
      if (/\/v1\/(validate|evaluate)$/.test(request.url()) && request.method() === "POST")
        sent = JSON.parse(request.postData() ?? "{}").graph ?? sent;
    });
  const page = await openPage(browser, url, { ...options, beforeOpening });
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"], { origin: new URL(url).origin });
  page.graph = () => sent;
  return page;
}

/** Runs a test in the editor of a clean page: in an empty graph, with the whole graph in sight, or `asOpened`. */
export function withEditor(used, options, run) {
  const start = async (page) => {
    if (options.isEmpty) await emptyGraph(page);
    else {
      await settled(page);
      if (!options.asOpened) await wholeGraph(page);
    }
    // In a narrow window the canvas is behind a tab.
    if (await pane(page).isVisible()) await canvasReady(page);
    await run(page);
  };
  return withCleanPage(used, options, start, openEditor);
}

export async function emptyGraph(page) {
  await page.getByRole("heading", { level: 1 }).waitFor({ state: "attached" });
  await page.getByRole("button", { name: "New graph" }).click();
  await page.getByText("An empty graph").waitFor();
}

/** Waits until the canvas answers to the hand, and every node of it is drawn and stands still. */
export async function canvasReady(page) {
  await page.locator('.graph-pane[data-ready="true"]').waitFor({ state: "attached" });
  await page.waitForFunction(() =>
    [...document.querySelectorAll(".react-flow__node")].every((item) => item.style.visibility !== "hidden"),
  );
  await still(pane(page).locator(".react-flow__viewport"));
}

/** Waits until the graph that was sent last fulfils the test. */
export function untilGraph(page, test) {
  return eventually(() => page.graph(), test, "the graph that was sent");
}

export const pane = (page) => page.getByRole("region", { name: "Graph" });

/** A point of the canvas, from its corner. */
export async function at(page, x, y) {
  const box = await pane(page).boundingBox();
  return { x: box.x + x, y: box.y + y };
}

/** Waits until no node lies over another. */
export function untilApart(page) {
  const overlaps = () =>
    pane(page)
      .locator(".node")
      .evaluateAll((list) => {
        const boxes = list.map((item) => item.getBoundingClientRect());
        const isClear = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
        return boxes.flatMap((a) => boxes.filter((b) => a !== b && !isClear(a, b)));
      });
  return eventually(overlaps, [], "nodes that lie apart");
}

/** Adds a node by double-click and search. Answers its name. */
export async function addNode(page, text, x, y) {
  const place = await at(page, x, y);
  const before = await nodeNames(page);
  await page.mouse.dblclick(place.x, place.y);
  await page.getByRole("combobox", { name: "Add a node" }).fill(text);
  await page.keyboard.press("Enter");
  await page.getByRole("dialog", { name: "Add a node" }).waitFor({ state: "detached" });
  const names = await eventually(
    async () => (await nodeNames(page)).filter((name) => !before.includes(name)),
    (added) => added.length === 1,
    `a node for ${text}`,
  );
  await inPanel(page, names[0]);
  await still(node(page, names[0]));
  return names[0];
}

const nodeNames = (page) =>
  page.locator(".react-flow__node-graph").evaluateAll((list) => list.map((item) => item.dataset.id));

/** Waits until the panel shows the inputs of this node. */
export const inPanel = (page, id) => page.getByRole("button", { name: `Rename ${id}`, exact: true }).waitFor();

export const node = (page, id) => pane(page).getByRole("group", { name: new RegExp(`, ${id}$`) });
/** A socket by the name that documents have for it; what people read is its title. */
const socket = (page, id, side, name) =>
  node(page, id)
    .getByRole("button", { name: new RegExp(`^${side} .* of `) })
    .and(page.locator(`[data-handleid="${name}"]`));
export const input = (page, id, name) => socket(page, id, "Input", name);
export const output = (page, id, name) => socket(page, id, "Output", name);

/** Where a node stands. How tall it is may still change: its problems come from the server. */
export async function placeOf(page, id) {
  const { x, y } = await still(node(page, id));
  return { x, y };
}

/** The middle of what a locator finds, once that stands still. */
export async function middle(locator) {
  const { x, y, width, height } = await still(locator);
  return { x: x + width / 2, y: y + height / 2 };
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

/** The names of the selected nodes, in order. */
export const selection = (page) =>
  pane(page)
    .locator(".react-flow__node.selected")
    .evaluateAll((list) => list.map((item) => item.dataset.id).sort());

/** Waits until these nodes are selected, and no others. */
export const untilSelected = (page, ids) => eventually(() => selection(page), ids, "the selection");

/** Selects a node by pressing on its title: it alone, or one more with Shift. */
export async function choose(page, id, modifiers = []) {
  const box = await still(node(page, id));
  const others = modifiers.length > 0 ? await selection(page) : [];
  for (const key of modifiers) await page.keyboard.down(key);
  await page.mouse.click(box.x + 40, box.y + 12);
  for (const key of modifiers) await page.keyboard.up(key);
  await untilSelected(page, [...others, id].sort());
}

/** Waits until this was said. */
export const said = (page, text) =>
  page.getByRole("status", { name: "Last action" }).filter({ hasText: text }).waitFor();
