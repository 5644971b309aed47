// Graphs that the server keeps: from and to the editor, their versions, what two people do at once, their addresses.

import assert from "node:assert/strict";
import { test } from "node:test";
import { useServer, withRing } from "./fixture.mjs";
import { eventually, settled } from "./harness.mjs";

const used = useServer();

const withPage = (options, run) => withRing(used, { expectStatus: 412, ...options }, run);

const titleOf = (page) => page.getByRole("textbox", { name: "Title of the graph" });
const titled = (page, title) => eventually(() => titleOf(page).inputValue(), title, "the title");
const dialog = (page, name) => page.getByRole("dialog", { name });
const note = (page, text) => page.getByRole("status").filter({ hasText: text }).waitFor();

async function rename(page, title) {
  await titleOf(page).fill(title);
  await titleOf(page).press("Enter");
}

async function fromMenu(page, item) {
  await page.getByRole("button", { name: "File", exact: true }).click();
  await page.getByRole("menuitem", { name: item }).click();
}

/** Keeps the open graph under a name that is not taken. */
async function keepAs(page, name) {
  await fromMenu(page, "Save to the server…");
  const keep = dialog(page, "Save to the server");
  await keep.getByRole("textbox", { name: "Name" }).fill(name);
  await keep.getByRole("button", { name: "Save" }).click();
  await note(page, `Saved ${name} on the server, version 1`);
}

const kept = async (name) => (await fetch(`${used.server.url}/v1/graphs/${name}`)).json();

test("a graph is saved to the server, listed with its picture, and opened again in each of its versions", () =>
  withPage({}, async (page) => {
    await rename(page, "First title");
    await fromMenu(page, "Save to the server…");
    const keep = dialog(page, "Save to the server");
    const name = keep.getByRole("textbox", { name: "Name" });
    assert.equal(await name.inputValue(), "first-title");
    await name.fill("2 rings");
    await keep.getByText("A name is a letter, followed by").waitFor();
    assert.ok(await keep.getByRole("button", { name: "Save" }).isDisabled());
    await name.fill("versions");
    await name.press("Enter");
    await note(page, "Saved versions on the server, version 1");
    await page.getByText("on the server", { exact: true }).waitFor();
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    await rename(page, "Second title");
    await page.keyboard.press("Control+s");
    await note(page, "Saved versions on the server, version 2");
    assert.ok((await kept("versions")).ui.values.reach > 1, "values are kept beside the defaults");
    // A reload shows it again, and knows what it is.
    await page.reload();
    await settled(page);
    await titled(page, "Second title");
    await page.getByText("on the server", { exact: true }).waitFor();
    await rename(page, "Third title");
    await page.reload();
    await titled(page, "Third title");
    await page.keyboard.press("Control+s");
    await note(page, "Saved versions on the server, version 3");
    await page.getByRole("button", { name: "New graph" }).click();
    await page.getByText("An empty graph").waitFor();
    await fromMenu(page, "Open from the server…");
    const list = dialog(page, "Open from the server");
    const graph = list.getByRole("listitem", { name: "Third title" });
    await graph.locator("img").waitFor();
    await list.getByRole("searchbox", { name: "Find a graph" }).fill("nothing like it");
    await list.getByText("No graph is called like “nothing like it”.").waitFor();
    await list.getByRole("searchbox", { name: "Find a graph" }).fill("versions");
    await graph.getByRole("button", { name: "Versions", exact: true }).click();
    await graph.getByRole("button", { name: "Open version 1 of versions" }).click();
    await titled(page, "First title");
    await fromMenu(page, "Open from the server…");
    await list.getByRole("button", { name: "Open versions", exact: true }).click();
    await titled(page, "Third title");
  }));

test("two people save one graph: the second sees both, and may copy, take the other's, or replace it", () =>
  withPage({}, async (page) => {
    await rename(page, "Ours");
    await keepAs(page, "together");
    const theirs = { ...(await kept("together")), meta: { title: "Theirs" } };
    const put = (body) =>
      fetch(`${used.server.url}/v1/graphs/together`, {
        method: "PUT",
        headers: { "content-type": "application/json", "if-match": "*" },
        body: JSON.stringify(body),
      });
    assert.equal((await put(theirs)).status, 200);
    await rename(page, "Mine");
    await page.keyboard.press("Control+s");
    const conflict = dialog(page, "The server keeps another “together”");
    await conflict.getByRole("listitem", { name: "Yours" }).getByText("Mine").waitFor();
    await conflict.getByRole("listitem", { name: "The server’s" }).getByText("Theirs").waitFor();
    for (const who of ["Yours", "The server’s"])
      await conflict.getByRole("listitem", { name: who }).locator("img").waitFor();
    assert.equal((await kept("together")).meta.title, "Theirs", "nothing was replaced");
    await conflict.getByRole("button", { name: "Save mine as a copy…" }).click();
    const keep = dialog(page, "Save to the server");
    assert.equal(await keep.getByRole("textbox", { name: "Name" }).inputValue(), "together-2");
    await keep.getByRole("button", { name: "Save" }).click();
    await note(page, "Saved together-2 on the server, version 1");
    assert.equal((await kept("together-2")).meta.title, "Mine");
    assert.equal((await kept("together")).meta.title, "Theirs");

    // Taking the other's keeps one's own as a draft.
    await fromMenu(page, "Open from the server…");
    await dialog(page, "Open from the server").getByRole("button", { name: "Open together", exact: true }).click();
    await titled(page, "Theirs");
    assert.equal((await put({ ...theirs, meta: { title: "Theirs again" } })).status, 200);
    await rename(page, "Mine again");
    await page.keyboard.press("Control+s");
    await conflict.getByRole("button", { name: "Open the server’s" }).click();
    await titled(page, "Theirs again");
    await note(page, "“Mine again” was not saved");
    await page.getByRole("button", { name: "Go back to it" }).click();
    await titled(page, "Mine again");
    await page.keyboard.press("Control+s");
    await conflict.getByRole("button", { name: "Replace it" }).click();
    await note(page, "Saved together on the server, version 4");
    assert.equal((await kept("together")).meta.title, "Mine again");
  }));

test("sharing gives the addresses of a stored graph, and says when they lead nowhere for others", () =>
  withPage({ clipboard: true }, async (page) => {
    await page.getByRole("slider", { name: "Reach", exact: true }).press("PageUp");
    await settled(page);
    const reach = await page.getByRole("textbox", { name: "Reach value", exact: true }).inputValue();
    const share = dialog(page, "Share");
    const openShare = async () => {
      await page.getByRole("button", { name: "Share", exact: true }).click();
      await page.getByRole("menuitem", { name: "Link to this graph…" }).click();
    };
    await openShare();
    await share.getByText(/127\.0\.0\.1:\d+, works on this computer only/).waitFor();
    await share.getByRole("button", { name: "Save to the server…" }).click();
    await dialog(page, "Save to the server").getByRole("textbox", { name: "Name" }).fill("addressed");
    await page.keyboard.press("Enter");
    await note(page, "Saved addressed on the server");
    await openShare();
    const copied = async (title) => {
      await page.evaluate(() => navigator.clipboard.writeText(""));
      await share.getByRole("button", { name: `Copy: ${title}` }).click();
      return eventually(() => page.evaluate(() => navigator.clipboard.readText()), Boolean, "a text on the clipboard");
    };
    const model = await copied("Model");
    assert.equal(new URL(model).searchParams.get("reach"), reach);
    const answer = await fetch(model);
    assert.equal(answer.headers.get("content-type"), "model/gltf-binary");
    const frame = await copied("Frame for a page");
    const source = /^<iframe src="([^"]+)" title="Boosted ring"/.exec(frame)?.[1].replaceAll("&amp;", "&");
    assert.equal(new URL(source).pathname, "/embed/addressed");
    assert.equal(new URL(source).searchParams.get("reach"), reach);
    const address = await copied("Graph in the editor");
    await withPage({ hash: new URL(address).hash }, async (other) => {
      await titled(other, "Boosted ring");
      await other.getByText("on the server", { exact: true }).waitFor();
      await eventually(() => other.getByRole("textbox", { name: "Reach value", exact: true }).inputValue(), reach);
    });
  }));

test("a server that does not answer is said in the list, with a way to try again", () =>
  withPage({ expectOutage: true }, async (page) => {
    await page.route("**/v1/graphs?**", (route) => route.abort("connectionrefused"));
    await fromMenu(page, "Open from the server…");
    const list = dialog(page, "Open from the server");
    await list.getByRole("alert").getByText("The server does not answer.").waitFor();
    await page.unroute("**/v1/graphs?**");
    await list.getByRole("button", { name: "Try again" }).click();
    await list.getByRole("alert").waitFor({ state: "detached" });
  }));

test("a stored graph is deleted in two presses; its versions keep their addresses", () =>
  withPage({}, async (page) => {
    await keepAs(page, "to-go");
    await fromMenu(page, "Open from the server…");
    const list = dialog(page, "Open from the server");
    await list.getByRole("button", { name: "Delete to-go" }).click();
    assert.equal((await kept("to-go")).format, 1, "one press deletes nothing");
    await list.getByRole("button", { name: "Really delete to-go" }).click();
    await list.getByRole("button", { name: "Open to-go" }).waitFor({ state: "detached" });
    assert.equal((await fetch(`${used.server.url}/v1/graphs/to-go`)).status, 404);
    assert.equal((await kept("to-go@1")).format, 1);
  }));
