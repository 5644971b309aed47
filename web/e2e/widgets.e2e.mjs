// Menus, dialogs, tabs and tips: what hands without a pointer and people who hear the page rely on.

import assert from "node:assert/strict";
import { test } from "node:test";
import { choose, node, untilGraph, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually } from "./harness.mjs";

const used = useServer();
const ring = (run) => withEditor(used, { hash: "#example=fig04_boosted_ring", width: 1500, height: 900 }, run);

const hasFocus = (locator) => eventually(() => locator.evaluate((element) => element === document.activeElement), true);

test("a menu opens, goes round and acts with the keys, and gives the focus back", () =>
  ring(async (page) => {
    const button = page.getByRole("button", { name: "Edit", exact: true });
    await button.focus();
    await page.keyboard.press("Enter");
    const menu = page.getByRole("menu", { name: "Edit" });
    await menu.waitFor();
    // Nothing is selected, so the first that can be chosen is Paste.
    await hasFocus(menu.getByRole("menuitem", { name: /^Paste Ctrl/ }));
    await page.keyboard.press("End");
    await hasFocus(menu.getByRole("menuitem", { name: /^Lay out/ }));
    await page.keyboard.press("ArrowDown");
    await hasFocus(menu.getByRole("menuitem", { name: /^Paste Ctrl/ }));
    await page.keyboard.press("s");
    await hasFocus(menu.getByRole("menuitem", { name: /^Select all/ }));
    await page.keyboard.press("Escape");
    await menu.waitFor({ state: "detached" });
    await hasFocus(button);
    await page.keyboard.press("Enter");
    await hasFocus(menu.getByRole("menuitem", { name: /^Paste Ctrl/ }));
    await page.keyboard.press("s");
    await hasFocus(menu.getByRole("menuitem", { name: /^Select all/ }));
    await page.keyboard.press("Enter");
    await menu.waitFor({ state: "detached" });
    await page.locator(".react-flow__node.selected").nth(8).waitFor();
  }));

test("what a menu opens has the focus, and not the place of the menu", () =>
  ring(async (page) => {
    await choose(page, "skin");
    const box = await node(page, "skin").boundingBox();
    await page.mouse.click(box.x + 40, box.y + 12, { button: "right" });
    await page
      .getByRole("menu", { name: "Node menu" })
      .getByRole("menuitem", { name: /^Rename/ })
      .click();
    const name = page.getByRole("textbox", { name: "Name of the node" });
    await hasFocus(name);
    await page.keyboard.type("hide");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.hide !== undefined && nodes.skin === undefined);
  }));

test("a dialog keeps the focus, hides the page from those who hear it, and gives the focus back", () =>
  ring(async (page) => {
    const button = page.getByRole("button", { name: "Export", exact: true });
    await button.focus();
    await page.keyboard.press("Enter");
    const dialog = page.getByRole("dialog", { name: "Export" });
    await dialog.waitFor();
    for (let press = 0; press < 20; press++) {
      await page.keyboard.press("Tab");
      const isInside = await dialog.evaluate((element) => element.contains(document.activeElement));
      assert.ok(isInside, `after ${press + 1} presses of Tab`);
    }
    assert.equal(await page.getByRole("button", { name: "Undo" }).count(), 0, "the page behind is out of reach");
    await page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
    await hasFocus(button);
    await page.getByRole("button", { name: "Undo" }).waitFor();
  }));

test("arrow keys go from tab to tab, and round", () =>
  ring(async (page) => {
    const tab = (name) => page.getByRole("tab", { name });
    await tab("Controls").focus();
    for (const name of ["Node", /^Problems/, "Controls"]) {
      await page.keyboard.press("ArrowRight");
      await hasFocus(tab(name));
      assert.equal(await tab(name).getAttribute("aria-selected"), "true");
      await page.getByRole("tabpanel", { name }).waitFor();
    }
  }));

test("a tip comes with the focus, names the key, and goes with Escape", () =>
  ring(async (page) => {
    await page.getByRole("button", { name: "Find a node" }).focus();
    const tip = page.getByRole("tooltip");
    await tip.filter({ hasText: "Lay the graph out" }).waitFor({ state: "detached" });
    await page.keyboard.press("Tab");
    await tip.filter({ hasText: "Lay the graph outL" }).waitFor();
    const described = await page.getByRole("button", { name: "Lay out" }).getAttribute("aria-describedby");
    assert.equal(described, await tip.getAttribute("id"));
    await page.keyboard.press("Escape");
    await tip.waitFor({ state: "detached" });
  }));

test("one of several is chosen with the arrow keys", () =>
  ring(async (page) => {
    const shading = page.getByRole("radiogroup", { name: "Shading" });
    await shading.getByRole("radio", { name: "Shaded" }).focus();
    await page.keyboard.down("ArrowRight");
    await eventually(() => shading.getByRole("radio", { name: "Lines" }).isChecked(), true);
    await page.keyboard.up("ArrowRight");
  }));
