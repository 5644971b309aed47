// Groups, as a person makes, enters, copies, saves and takes them apart; what is drawn stays the same.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { choose, emptyGraph, node, said, undo, untilGraph, untilSelected, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, settled } from "./harness.mjs";

const used = useServer();
const { server } = used;

const SIZE = { hash: "#example=fig04_boosted_ring", width: 1800, height: 1200 };

/** The bytes that a graph makes. */
async function bytesOf(graph) {
  const headers = { "content-type": "application/json" };
  const answer = await fetch(`${server.url}/v1/evaluate`, { method: "POST", headers, body: JSON.stringify({ graph }) });
  assert.equal(answer.status, 200, await answer.clone().text());
  return Buffer.from(await answer.arrayBuffer());
}

const groupPath = (page) => page.getByRole("navigation", { name: "Groups around the canvas" });

/** Selects nodes, the canvas under the pointer. */
async function chooseAll(page, ids) {
  for (const [index, id] of ids.entries()) await choose(page, id, index > 0 ? ["Shift"] : []);
}

test("nodes become a group, a group in a group, and the graph again, with the same bytes", { timeout: 300_000 }, () =>
  withEditor(used, SIZE, async (page) => {
    const first = structuredClone(await untilGraph(page, ({ nodes }) => nodes !== undefined));
    const model = await bytesOf(first);
    const [one, two] = chosenOf(first);
    await chooseAll(page, [one, two]);
    await page.keyboard.press("Control+g");
    await said(page, "Grouped 2 nodes");
    const grouped = await untilGraph(page, ({ groups }) => groups?.group !== undefined);
    assert.equal(grouped.format, 2);
    assert.deepEqual(Object.keys(grouped.groups.group.nodes).sort(), [one, two].sort());
    await settled(page);
    assert.deepEqual(await sizes(await bytesOf(grouped)), await sizes(model));

    // A group of the group.
    await page.keyboard.press("Control+g");
    const nested = await untilGraph(page, ({ groups }) => groups?.group2 !== undefined);
    assert.equal(nested.groups.group2.nodes.group.type, "group/group");
    assert.deepEqual(await sizes(await bytesOf(nested)), await sizes(model));
    await untilSelected(page, ["group2"]);

    // In, and in again, by Tab; out by the path.
    await page.keyboard.press("Tab");
    await groupPath(page).waitFor();
    await node(page, "group").waitFor();
    await choose(page, "group");
    await page.keyboard.press("Tab");
    await node(page, one).waitFor();
    assert.equal(await groupPath(page).getByRole("button").count(), 2);
    await groupPath(page).getByRole("textbox", { name: "Name of the group" }).fill("Innermost");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ groups }) => groups.group.label === "Innermost");
    await groupPath(page).getByRole("button").first().click();
    await groupPath(page).waitFor({ state: "detached" });
    await untilSelected(page, ["group2"]);

    await page.keyboard.press("Control+Shift+g");
    await untilGraph(page, ({ groups }) => groups.group2 === undefined && groups.group !== undefined);
    await page.keyboard.press("Control+Shift+g");
    const flat = await untilGraph(page, ({ groups }) => groups !== undefined && Object.keys(groups).length === 0);
    assert.ok(model.equals(await bytesOf(flat)), "taken apart it makes the very bytes that it made first");
    for (let step = 0; step < 5; step++) await undo(page);
    const undone = await untilGraph(page, ({ groups }) => groups === undefined);
    assert.deepEqual(undone.nodes, first.nodes);
  }),
);

/** Two nodes that are wired to each other, neither of which makes the file. */
function chosenOf({ nodes }) {
  for (const [id, { type, inputs }] of Object.entries(nodes)) {
    if (type === "export") continue;
    for (const value of Object.values(inputs ?? {})) {
      const from = typeof value?.from === "string" ? value.from.split(".")[0] : undefined;
      if (from !== undefined) return [from, id];
    }
  }
  throw new Error("no wire");
}

/** What a model has besides the names of its parts, which are paths of nodes. */
async function sizes(model) {
  const length = model.readUInt32LE(12);
  const json = JSON.parse(model.subarray(20, 20 + length).toString());
  return json.accessors.map(({ count, min, max }) => ({ count, min, max }));
}

test(
  "an edit in a group changes every instance, and problems in it are shown at the instance",
  { timeout: 300_000 },
  () =>
    withEditor(used, SIZE, async (page) => {
      const first = structuredClone(await untilGraph(page, ({ nodes }) => nodes !== undefined));
      const [one, two] = chosenOf(first);
      await chooseAll(page, [one, two]);
      await page.keyboard.press("Control+g");
      await untilGraph(page, ({ groups }) => groups?.group !== undefined);
      await page.keyboard.press("Control+d");
      await untilGraph(
        page,
        ({ nodes }) => nodes.group2?.type === "group/group" || nodes.group_2?.type === "group/group",
      );
      await choose(page, "group");
      await page.keyboard.press("Tab");
      await node(page, one).waitFor();
      await choose(page, one);
      await page.keyboard.press("m");
      const bypassed = await untilGraph(page, ({ groups }) => groups.group.nodes[one].bypass === true);
      assert.equal(Object.values(bypassed.nodes).filter(({ type }) => type === "group/group").length, 2);
      await groupPath(page).getByRole("button").first().click();
      await eventually(
        () => node(page, "group").locator(".node").getAttribute("data-tone"),
        (tone) => tone === "error" || tone === "warning",
        "the mark of the problem in the group",
      );
      await page.getByRole("tab", { name: /^Problems/ }).click();
      await page
        .getByRole("button")
        .filter({ hasText: `group/${one}` })
        .first()
        .click();
      await groupPath(page).waitFor();
      await untilSelected(page, [one]);
    }),
);

test("a group is saved to a file and comes back from it into another graph", { timeout: 300_000 }, () =>
  withEditor(used, SIZE, async (page) => {
    const first = structuredClone(await untilGraph(page, ({ nodes }) => nodes !== undefined));
    await chooseAll(page, chosenOf(first));
    await page.keyboard.press("Control+g");
    const { groups } = await untilGraph(page, (graph) => graph.groups?.group !== undefined);
    const box = await node(page, "group").boundingBox();
    await page.mouse.click(box.x + 40, box.y + 12, { button: "right" });
    const download = page.waitForEvent("download");
    await page.getByRole("menuitem", { name: "Save the group to a file" }).click();
    const file = await (await download).path();
    const saved = JSON.parse(await readFile(file, "utf8"));
    assert.deepEqual(saved.groups, groups);
    assert.deepEqual(saved.nodes, {});

    await emptyGraph(page);
    const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.keyboard.press("Control+o")]);
    const buffer = Buffer.from(JSON.stringify(saved));
    await chooser.setFiles({ name: "group.group.json", mimeType: "application/json", buffer });
    await node(page, "group").waitFor();
    const taken = await untilGraph(page, ({ nodes }) => Object.keys(nodes).length === 1);
    assert.equal(taken.nodes.group.type, "group/group");
    assert.deepEqual(taken.groups, groups);
  }),
);

test("a group is entered, gone through and left with the keyboard alone", { timeout: 300_000 }, () =>
  withEditor(used, SIZE, async (page) => {
    const [one, two] = chosenOf(await untilGraph(page, ({ nodes }) => nodes !== undefined));
    await chooseAll(page, [one, two]);
    await page.keyboard.press("Control+g");
    await untilSelected(page, ["group"]);
    // From here on the pointer says nothing.
    await page.mouse.move(2, 2);
    const focused = (name) => page.waitForFunction((id) => document.activeElement?.dataset.id === id, name);
    await node(page, "group").focus();
    await page.keyboard.press("Tab");
    await groupPath(page).waitFor();
    await page.waitForFunction(() => document.activeElement?.matches(".graph-pane"));
    await page.keyboard.press("ArrowRight");
    await focused(one);
    await page.keyboard.press("Tab");
    await groupPath(page).waitFor({ state: "detached" });
    await untilSelected(page, ["group"]);
    await focused("group");
  }),
);
