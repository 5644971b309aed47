// Dialogs over dialogs: the token is asked for wherever it is wanted, and the focus comes back.

import assert from "node:assert/strict";
import { test } from "node:test";
import { useServer, withCleanPage } from "./fixture.mjs";
import { eventually, settled } from "./harness.mjs";

const used = useServer();
const TOKEN = "right";

test("the token is asked for over a dialog that is open, which goes on with it", () =>
  withCleanPage(used, { expectStatus: 401 }, async (page) => {
    await settled(page);
    await page.route("**/v1/graphs?**", async (route) => {
      const isGiven = (await route.request().headerValue("authorization")) === `Bearer ${TOKEN}`;
      const json = isGiven ? { graphs: [], next: "" } : { title: "Unauthorized" };
      await route.fulfill({ status: isGiven ? 200 : 401, json });
    });
    await page.getByRole("button", { name: "File" }).click();
    await page.getByRole("menuitem", { name: "Open from the server…" }).click();
    const field = page.getByRole("textbox", { name: "Token" });
    await field.waitFor();
    await eventually(() => field.evaluate((item) => item === document.activeElement), true, "the focus in the field");
    await page.keyboard.press("Escape");
    assert.equal(await field.count(), 1, "nothing works without it");
    await page.keyboard.type(TOKEN);
    await page.keyboard.press("Enter");
    await field.waitFor({ state: "detached" });
    const list = page.getByRole("dialog", { name: "Open from the server" });
    await list.getByText("The server keeps no graphs yet.").waitFor();
    const isIn = () => list.evaluate((item) => item.contains(document.activeElement));
    await eventually(isIn, true, "the focus in the dialog below");
  }));
