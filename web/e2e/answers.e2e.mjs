// A server that hangs, fails or is crowded: it is said, and can be asked again.

import { test } from "node:test";
import { RING, useServer, withCleanPage, withRing } from "./fixture.mjs";
import { settled } from "./harness.mjs";

const used = useServer();

const withPage = (options, run) => withRing(used, options, run);

const status = (page) => page.getByRole("contentinfo", { name: "Status" });
const model = (page) => page.getByRole("region", { name: "Model" });
const move = (page) => page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");

/** Lets requests to an address hang until `free` is called; those that hang stay so. */
async function hang(page, address) {
  let isFree = false;
  await page.route(address, (route) => (isFree ? route.continue() : undefined));
  return () => {
    isFree = true;
  };
}

test("an evaluation that hangs is said so, and asked for again", () =>
  withPage({}, async (page) => {
    const free = await hang(page, "**/v1/evaluate");
    await move(page);
    await model(page)
      .getByText(/^Evaluating… \d+ s$/)
      .waitFor();
    await model(page)
      .getByText(/^No answer for \d s$/)
      .waitFor();
    await status(page).getByText("No answer yet").waitFor();
    free();
    await model(page).getByRole("button", { name: "Try again" }).click();
    await settled(page);
    await status(page).getByText("Up to date").waitFor();
  }));

test("an evaluation that fails for no fault of the graph can be asked for again", () =>
  withPage({ expectStatus: 500 }, async (page) => {
    await page.route("**/v1/evaluate", (route) => route.fulfill({ status: 500, body: "broken" }));
    await move(page);
    await model(page).getByText("The server answered 500").waitFor();
    await status(page).getByText("Out of date").waitFor();
    await page.unroute("**/v1/evaluate");
    await model(page).getByRole("button", { name: "Try again" }).click();
    await settled(page);
    await status(page).getByText("Up to date").waitFor();
  }));

test("a crowded server is not called away", () =>
  withPage({ expectStatus: 503 }, async (page) => {
    await page.route("**/v1/evaluate", (route) => route.fulfill({ status: 503, headers: { "retry-after": "60" } }));
    await page.route("**/healthz", () => undefined);
    await move(page);
    await page.getByText("The server has too much to do.").waitFor();
    await status(page).getByText("Server busy").waitFor();
    await page.unroute("**/v1/evaluate");
    await page.getByRole("button", { name: "Try again" }).click();
    await settled(page);
  }));

test("a list of nodes that never comes is asked for until it comes", () => {
  let opening;
  return withCleanPage(
    used,
    {
      hash: RING,
      beforeOpening: (page) => {
        opening = hang(page, "**/v1/nodes");
      },
    },
    async (page) => {
      await page.getByText("The server does not answer.").waitFor();
      (await opening)();
      await settled(page);
    },
  );
});

test("a measurement of the export that hangs is said so, and asked for again", () =>
  withPage({}, async (page) => {
    const free = await hang(page, "**/v1/evaluate?format=*");
    await page.getByRole("button", { name: "Export", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: "Export" });
    await dialog.getByText("No answer yet.").waitFor();
    free();
    await dialog.getByRole("button", { name: "Try again" }).click();
    await dialog
      .getByRole("status")
      .getByText(/ triangles/)
      .waitFor();
  }));
