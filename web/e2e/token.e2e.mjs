// A server that has a token: the page asks for it, and nothing is lost while it does.

import assert from "node:assert/strict";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launchBrowser, openPage, Server, settled } from "./harness.mjs";

const TOKEN = "0123456789abcdef0123456789abcdef";
const examples = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../examples");
const server = new Server(examples, ["--token", TOKEN]);
let browser;
before(async () => {
  await server.start();
  browser = await launchBrowser(["--disable-gpu-compositing"]);
});
after(async () => {
  await browser?.close();
  await server.stop();
});

test("a server with a token is asked for it, once for a tab, and a wrong one is said to be wrong", async () => {
  const page = await openPage(browser, server.url, { expectStatus: 401 });
  const field = page.getByRole("textbox", { name: "Token" });
  await field.waitFor();
  await field.fill("not this one");
  await page.getByRole("button", { name: "Continue" }).click();
  await page.getByRole("alert").filter({ hasText: "That was not the token" }).waitFor();
  await field.fill(TOKEN);
  await page.keyboard.press("Enter");
  await settled(page);
  assert.equal(await page.getByRole("heading", { name: "This server asks for its token" }).count(), 0);
  await page.reload();
  await settled(page);
  assert.equal(await page.getByRole("heading", { name: "This server asks for its token" }).count(), 0);
  assert.deepEqual(await page.offences(), []);
  await page.context().close();
});
