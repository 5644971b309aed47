// Who works without a mouse, without seeing, with other colors: names, focus, announcements, contrast, the first run.

import assert from "node:assert/strict";
import { test } from "node:test";
import { at, choose, node, openEditor, pane, said, untilGraph, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, settled } from "./harness.mjs";

const RING = "#example=fig04_boosted_ring";
const used = useServer();

const large = { width: 1500, height: 900 };
const ring = (run, options = {}) => withEditor(used, { hash: RING, ...large, ...options }, run);

test("every control of the editor has a name, also in menus, search and list of keys", () =>
  ring(async (page) => {
    const nameless = () =>
      page.evaluate(() =>
        [...document.querySelectorAll("button, input, select, textarea, [role=button], [role=option], [role=menuitem]")]
          .filter((item) => {
            const label = item.getAttribute("aria-label") || item.textContent.trim() || item.labels?.[0]?.textContent;
            return !label && item.type !== "hidden";
          })
          .map((item) => item.outerHTML.slice(0, 120)),
      );
    await choose(page, "skin");
    await page.keyboard.press("d");
    await node(page, "skin").getByRole("button", { name: "Hide defaults" }).waitFor();
    await eventually(nameless, []);
    const place = await at(page, 300, 700);
    await page.mouse.click(place.x, place.y, { button: "right" });
    await page.getByRole("menu").waitFor();
    await eventually(nameless, []);
    await page.keyboard.press("Escape");
    await page.mouse.dblclick(place.x, place.y);
    await page.getByRole("dialog", { name: "Add a node" }).waitFor();
    await eventually(nameless, []);
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Keys and pointer" }).click();
    await page.getByRole("dialog", { name: "Keys and pointer" }).waitFor();
    await eventually(nameless, []);
  }));

test("nodes and sockets are read as groups and buttons with type and node, and actions are announced", () =>
  ring(async (page) => {
    const group = node(page, "skin");
    await eventually(() => group.getAttribute("aria-roledescription"), "node");
    await group.getByRole("button", { name: "Output mesh of Surface, mesh" }).waitFor();
    await choose(page, "skin");
    await page.keyboard.press("Control+d");
    await said(page, "Added 1 node");
    const live = page.getByRole("status", { name: "Last action" });
    await eventually(() => live.count(), 1);
  }));

test("Tab goes from node to node, the focus is seen, and Escape leads out of a node", () =>
  ring(async (page) => {
    const first = pane(page).locator(".react-flow__node").first();
    await first.focus();
    await page.keyboard.press("Tab");
    const seen = () =>
      page.evaluate(() => {
        const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement.querySelector(".node"));
        return [document.activeElement.className.includes("react-flow__node"), outlineStyle, outlineWidth];
      });
    await eventually(seen, [true, "solid", "2px"]);
    const focusIsOn = (selector) => page.waitForFunction((text) => document.activeElement.matches(text), selector);
    await page.keyboard.press("Enter");
    await focusIsOn("[data-stop]");
    await page.keyboard.press("Escape");
    await focusIsOn(".react-flow__node");
    // The skip over the canvas: Tab leaves it after the last node.
    const nodes = await pane(page).locator(".react-flow__node").count();
    for (let count = 0; count < nodes + 3; count++) await page.keyboard.press("Tab");
    await focusIsOn(":not(.react-flow__node)");
  }));

test("the list of keys comes from the table, opens with ? and closes with Escape", () =>
  ring(async (page) => {
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("?");
    const dialog = page.getByRole("dialog", { name: "Keys and pointer" });
    await dialog.waitFor();
    for (const text of ["Undo", "Duplicate", "Bypass", "Fill the view with the selection, or the model"])
      await dialog.getByText(text, { exact: true }).waitFor();
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
  }));

test("text and marks keep their contrast in both themes, as drawn", async () => {
  for (const theme of ["dark", "light"]) {
    await ring(
      async (page) => {
        await choose(page, "skin");
        const low = () =>
          page.evaluate(() => {
            const channel = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
            const parse = (text) => (/rgba?\(([^)]+)\)/.exec(text)?.[1] ?? "0,0,0,0").split(/[\s,/]+/).map(Number);
            const luminance = ([r, g, b]) =>
              0.2126 * channel(r / 255) + 0.7152 * channel(g / 255) + 0.0722 * channel(b / 255);
            const groundOf = (element) => {
              for (let item = element; item; item = item.parentElement) {
                const color = parse(getComputedStyle(item).backgroundColor);
                if ((color[3] ?? 1) > 0.95) return color;
              }
              return parse(getComputedStyle(document.body).backgroundColor);
            };
            const names =
              ".node-title, .node-name, .row-name, .node-time, .tab, .parameter-label, .status-bar span, .button, .document-state, " +
              ".inspector-name, .chip, .node-fold, .number-input input, .row-parameter, .unit, .expose";
            return [...document.querySelectorAll(names)]
              .filter((item) => item.offsetParent && !item.disabled && !item.closest("[disabled]"))
              .map((item) => {
                const [a, b] = [luminance(parse(getComputedStyle(item).color)), luminance(groundOf(item))].sort(
                  (x, y) => y - x,
                );
                return { name: item.className, text: item.textContent.slice(0, 20), ratio: (a + 0.05) / (b + 0.05) };
              })
              .filter(({ ratio }) => ratio < 4.5);
          });
        await eventually(low, [], `contrast in the ${theme} theme`);
      },
      { theme },
    );
  }
});

test("forced colors and reduced motion are respected", () =>
  ring(async (page) => {
    await page.emulateMedia({ forcedColors: "active", reducedMotion: "reduce" });
    const style = (selector, name) =>
      page
        .locator(selector)
        .first()
        .evaluate((item, wanted) => getComputedStyle(item)[wanted], name);
    await eventually(() => style(".socket .mark", "forcedColorAdjust"), "none", "types that keep their colors");
    await eventually(
      () => style(".notice", "transitionDuration"),
      (duration) => parseFloat(duration) < 0.001,
    );
    await choose(page, "skin");
    await eventually(() => style('[data-id="skin"] .node', "outlineStyle"), "solid", "a selection without shadows");
  }));

test("someone new sees a finished graph and how to change it, once", async () => {
  const page = await openEditor(used.browser, used.server.url, { firstRun: true, ...large });
  await settled(page);
  const hint = page.getByRole("complementary", { name: "How to begin" });
  await hint.getByText("This is a finished graph. Change it.").waitFor();
  await hint.getByRole("button", { name: "Understood" }).click();
  await hint.waitFor({ state: "detached" });
  await page.reload();
  await settled(page);
  assert.equal(await hint.count(), 0);
  assert.deepEqual(await page.offences(), []);
  await page.context().close();
});

test("an empty canvas says how to begin and offers nodes to begin with", () =>
  withEditor(used, { isEmpty: true, ...large }, async (page) => {
    const choices = page.locator(".empty-choices").getByRole("button");
    await choices.nth(2).waitFor();
    await choices.first().click();
    await untilGraph(page, ({ nodes }) => Object.keys(nodes).length === 1);
    await page.getByText("An empty graph").waitFor({ state: "detached" });
  }));

test("in a narrow window graph and panel are tabs, and a node can be added and changed there", () =>
  withEditor(used, { hash: RING, width: 620, height: 860 }, async (page) => {
    await page.getByRole("tablist", { name: "Panes" }).getByRole("tab", { name: "Graph" }).click();
    const search = page.getByRole("dialog", { name: "Add a node" });
    await page.getByRole("button", { name: "Add node" }).click();
    await search.getByRole("combobox").fill("sphere mesh");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.sphere_mesh);
    await eventually(() => page.evaluate(() => document.documentElement.scrollWidth), 620);
    const place = await at(page, 100, 600);
    await page.mouse.dblclick(place.x, place.y);
    await search.getByRole("combobox").fill("torus mesh");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.torus_mesh);
    await node(page, "torus_mesh").getByRole("textbox", { name: "Large radius of Torus mesh" }).fill("3");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.torus_mesh.inputs.major_radius === 3);
  }));
