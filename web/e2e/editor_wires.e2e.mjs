// Adding nodes and drawing wires with the mouse: the table of conventions, row by row.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  addNode,
  at,
  choose,
  drag,
  input,
  middle,
  output,
  pane,
  placeOf,
  said,
  undo,
  untilApart,
  untilGraph,
  wire,
  withEditor,
} from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { eventually, settled, still } from "./harness.mjs";

const used = useServer();
const { server } = used;

const empty = (run) => withEditor(used, { isEmpty: true, width: 1500, height: 900 }, run);

test("a node is added by double-click, Space, Shift+A, Tab over the canvas, and a button; the field has the focus", () =>
  empty(async (page) => {
    const search = page.getByRole("dialog", { name: "Add a node" });
    const place = await at(page, 200, 200);
    const opens = async (act) => {
      await act();
      await search.waitFor();
      await page.waitForFunction(() => document.activeElement.getAttribute("role") === "combobox");
      await page.keyboard.press("Escape");
      await search.waitFor({ state: "detached" });
    };
    await page.mouse.move(place.x, place.y);
    await opens(() => page.mouse.dblclick(place.x, place.y));
    await page.evaluate(() => document.activeElement.blur());
    await opens(() => page.keyboard.press("Space"));
    await page.evaluate(() => document.activeElement.blur());
    await opens(() => page.keyboard.press("Shift+A"));
    await page.evaluate(() => document.activeElement.blur());
    await opens(() => page.keyboard.press("Tab"));
    await opens(() => page.getByRole("button", { name: "Add node" }).click());
    // Where something has the focus, Tab moves it on.
    const button = page.getByRole("button", { name: "Add node" });
    await button.focus();
    await page.keyboard.press("Tab");
    await eventually(() => button.evaluate((element) => document.activeElement !== element), true);
    assert.equal(await search.count(), 0);
    assert.equal(await addNode(page, "circle", 200, 200), "circle");
    await untilGraph(page, (graph) => graph.nodes.circle !== undefined);
  }));

test("the search lists families without a text, forgives letters left out, and says what a node does", () =>
  empty(async (page) => {
    const place = await at(page, 300, 120);
    await page.mouse.dblclick(place.x, place.y);
    const list = page.getByRole("listbox");
    const families = await (await fetch(`${server.url}/v1/nodes`)).json().then((json) => json.families);
    for (const family of families) await page.locator(".chooser-heading", { hasText: family.title }).first().waitFor();
    const field = page.getByRole("combobox");
    await field.fill("crclthr");
    const first = () => list.getByRole("option").first().textContent();
    await eventually(first, (text) => /Circle through/.test(text));
    await field.fill("counter-clockwise");
    await eventually(first, (text) => /^Circle/.test(text));
    await page.locator(".chooser-foot", { hasText: "counter-clockwise" }).waitFor();
    await field.fill("zzzz");
    await page.getByText("Nothing is called that here.").waitFor();
  }));

test("typed values make their nodes: a number, a slider with its range, a point", () =>
  empty(async (page) => {
    await addNode(page, "3.2", 160, 120);
    await addNode(page, "0<5<10", 160, 320);
    await addNode(page, "1,2,3", 160, 520);
    const graph = await untilGraph(page, ({ nodes }) => Object.keys(nodes).length === 3);
    const inputs = Object.values(graph.nodes).map((item) => item.inputs);
    assert.ok(inputs.some((item) => item.value === 3.2));
    assert.ok(inputs.some((item) => JSON.stringify(item.position) === "[1,2,3]"));
    const [[name, parameter]] = Object.entries(graph.parameters);
    assert.ok(inputs.some((item) => item.value?.parameter === name));
    assert.deepEqual([parameter.min, parameter.default, parameter.max], [0, 5, 10]);
    await page.getByRole("tab", { name: "Controls" }).click();
    await page.getByRole("slider", { name: parameter.label }).waitFor();
  }));

test("a wire let go on the canvas opens a search for nodes that take it, and the chosen one is wired", () =>
  empty(async (page) => {
    await addNode(page, "circle", 160, 200);
    await drag(page, await middle(output(page, "circle", "circle")), await at(page, 420, 330));
    const search = page.getByRole("dialog", { name: "Add a node" });
    await search.getByText("takes circle").waitFor();
    const { nodes } = await (await fetch(`${server.url}/v1/nodes`)).json();
    const taking = nodes.filter((card) => card.inputs.some((item) => item.types.includes("circle"))).length;
    await eventually(() => search.getByRole("option").count(), taking);
    await page.keyboard.type("surface");
    await page.keyboard.press("Enter");
    await untilGraph(page, (graph) => graph.nodes.surface?.inputs.shape?.from === "circle");
    // The other way: from an input, nodes that feed it.
    await drag(page, await middle(input(page, "circle", "center")), await at(page, 60, 560));
    await search.getByText("gives point").waitFor();
    await page.keyboard.press("Enter");
    await untilGraph(page, (graph) => graph.nodes.circle.inputs.center?.from !== undefined);
  }));

test("while a wire is drawn, sockets that do not take it step back, and one that refuses it says why", () =>
  empty(async (page) => {
    await addNode(page, "sphere mesh", 160, 140);
    await addNode(page, "twist", 480, 300);
    const refused = input(page, "twist", "axis");
    await drag(page, await middle(output(page, "sphere_mesh", "mesh")), await middle(refused), {
      hold: async () => {
        await eventually(() => refused.getAttribute("data-fit"), "no");
        await eventually(() => input(page, "twist", "shape").getAttribute("data-fit"), "yes");
        await page.waitForFunction(
          () => Number(getComputedStyle(document.querySelector("[data-fit=no] .mark")).opacity) < 0.35,
        );
      },
    });
    await said(page, "axis needs circle, got mesh.");
    await wire(page, "sphere_mesh", "mesh", "twist", "shape");
    const { nodes } = await untilGraph(page, (graph) => graph.nodes.twist.inputs.shape?.from === "sphere_mesh");
    assert.equal(nodes.twist.inputs.axis, undefined);
  }));

test("a wire that would close a loop is refused", () =>
  empty(async (page) => {
    await addNode(page, "boost", 130, 160);
    await addNode(page, "boost", 480, 160);
    await wire(page, "boost", "shape", "boost_2", "shape");
    await untilGraph(page, (graph) => graph.nodes.boost_2.inputs.shape?.from === "boost");
    await wire(page, "boost_2", "shape", "boost", "shape");
    await said(page, "The wire would close a loop.");
    // What is sent next does not have it.
    await choose(page, "boost_2");
    await page.keyboard.press("m");
    const { nodes } = await untilGraph(page, (graph) => graph.nodes.boost_2.bypass);
    assert.equal(nodes.boost.inputs.shape, undefined);
  }));

test("an input takes one wire, the new one replaces the old in one step of undo", () =>
  empty(async (page) => {
    await addNode(page, "circle", 130, 130);
    await addNode(page, "line", 130, 420);
    await addNode(page, "surface", 520, 300);
    await wire(page, "circle", "circle", "surface", "shape");
    await untilGraph(page, (graph) => graph.nodes.surface.inputs.shape?.from === "circle");
    await wire(page, "line", "circle", "surface", "shape");
    await untilGraph(page, (graph) => graph.nodes.surface.inputs.shape?.from === "line");
    await undo(page);
    await untilGraph(page, (graph) => graph.nodes.surface.inputs.shape?.from === "circle");
  }));

test("an input that takes several keeps each wire", () =>
  empty(async (page) => {
    await addNode(page, "sphere mesh", 130, 130);
    await addNode(page, "torus mesh", 130, 480);
    await addNode(page, "merge", 520, 300);
    await wire(page, "sphere_mesh", "mesh", "merge", "meshes");
    await wire(page, "torus_mesh", "mesh", "merge", "meshes");
    const graph = await untilGraph(page, ({ nodes }) => nodes.merge.inputs.meshes?.length === 2);
    assert.deepEqual(
      graph.nodes.merge.inputs.meshes.map((item) => item.from),
      ["sphere_mesh", "torus_mesh"],
    );
  }));

test("a wire is pulled off its input: to another input, or onto the canvas to take it away", () =>
  empty(async (page) => {
    await addNode(page, "circle", 130, 130);
    await addNode(page, "surface", 520, 130);
    await addNode(page, "tube", 520, 480);
    await wire(page, "circle", "circle", "surface", "shape");
    await untilGraph(page, (graph) => graph.nodes.surface.inputs.shape?.from === "circle");
    await drag(page, await middle(input(page, "surface", "shape")), await middle(input(page, "tube", "shape")));
    await untilGraph(page, ({ nodes }) => nodes.tube.inputs.shape?.from === "circle" && !nodes.surface.inputs.shape);
    await drag(page, await middle(input(page, "tube", "shape")), await at(page, 420, 420));
    await untilGraph(page, (graph) => graph.nodes.tube.inputs.shape === undefined);
    assert.equal(await page.getByRole("dialog").count(), 0, "pulling a wire off opens no search");
    await undo(page);
    await untilGraph(page, (graph) => graph.nodes.tube.inputs.shape?.from === "circle");
  }));

test("a node is put into a wire by dropping it there, or from the wire's menu", () =>
  empty(async (page) => {
    await addNode(page, "circle", 120, 160);
    await addNode(page, "surface", 620, 160);
    await wire(page, "circle", "circle", "surface", "shape");
    await untilGraph(page, ({ nodes }) => nodes.surface.inputs.shape?.from === "circle");
    await addNode(page, "boost", 380, 560);
    const place = await placeOf(page, "boost");
    const [from, to] = [await middle(output(page, "circle", "circle")), await middle(input(page, "surface", "shape"))];
    const target = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
    await drag(page, { x: place.x + 60, y: place.y + 14 }, { x: target.x - 45, y: target.y - 60 });
    await untilGraph(
      page,
      ({ nodes }) => nodes.boost.inputs.shape?.from === "circle" && nodes.surface.inputs.shape?.from === "boost",
    );
    await undo(page);
    await untilGraph(page, ({ nodes }) => nodes.surface.inputs.shape?.from === "circle" && !nodes.boost.inputs.shape);
    await eventually(() => placeOf(page, "boost"), place, "a node back in its place");
    await page.mouse.click(target.x, target.y, { button: "right" });
    await page.getByRole("menuitem", { name: "Insert here…" }).click();
    await page.getByRole("combobox", { name: "Insert a node" }).fill("twist");
    await page.keyboard.press("Enter");
    await untilGraph(
      page,
      ({ nodes }) => nodes.twist?.inputs.shape?.from === "circle" && nodes.surface.inputs.shape?.from === "twist",
    );
    // What is behind it makes room: it stands between the two, and none lies over another.
    const places = await Promise.all(["circle", "twist", "surface"].map((id) => placeOf(page, id)));
    assert.ok(places[0].x < places[1].x && places[1].x < places[2].x, JSON.stringify(places));
    await untilApart(page);
  }));

test("Delete removes a node, Ctrl+Delete joins what it stood between", () =>
  empty(async (page) => {
    await addNode(page, "circle", 120, 160);
    await addNode(page, "boost", 370, 160);
    await addNode(page, "surface", 640, 160);
    await wire(page, "circle", "circle", "boost", "shape");
    await wire(page, "boost", "shape", "surface", "shape");
    await untilGraph(page, ({ nodes }) => nodes.boost.inputs.shape && nodes.surface.inputs.shape);
    await choose(page, "boost");
    await page.keyboard.press("Control+Delete");
    await untilGraph(page, ({ nodes }) => !nodes.boost && nodes.surface.inputs.shape?.from === "circle");
    await undo(page);
    await untilGraph(page, ({ nodes }) => nodes.surface.inputs.shape?.from === "boost");
    await choose(page, "boost");
    await page.keyboard.press("Delete");
    await untilGraph(page, ({ nodes }) => !nodes.boost && nodes.surface.inputs.shape === undefined);
  }));

test("a wire says what it carries under the pointer: type, axes and count", () =>
  withEditor(used, { hash: "#example=fig04_boosted_ring", width: 1500, height: 900 }, async (page) => {
    await untilGraph(page, (sent) => sent !== undefined);
    const { nodes } = page.graph();
    const report = await (
      await fetch(`${server.url}/v1/validate`, {
        method: "POST",
        headers: { "content-type": "application/json" },
        body: JSON.stringify({ graph: page.graph() }),
      })
    ).json();
    const [name, value] = Object.entries(report.wires).find(
      ([key, item]) => item.axes.length === 1 && JSON.stringify(nodes).includes(`"from":"${key.split(".")[0]}"`),
    );
    const path = pane(page)
      .locator(`.react-flow__edge[aria-label*=" from ${name.split(".")[0]} "] .react-flow__edge-interaction`)
      .first();
    await still(pane(page).locator(".react-flow__viewport"));
    const point = await path.evaluate((element) => {
      const { x, y } = element.getPointAtLength(element.getTotalLength() / 2);
      const moved = new DOMPoint(x, y).matrixTransform(element.getScreenCTM());
      return { x: moved.x, y: moved.y };
    });
    await page.mouse.move(point.x, point.y);
    const [axis] = value.axes;
    await page.getByText(`${value.type} over ${axis.name}: ${axis.size}`).waitFor();
    await settled(page);
  }));

test("a socket under the pointer says its type, its value and how far it reaches", () =>
  withEditor(used, { hash: "#example=fig04_boosted_ring", width: 1500, height: 900 }, async (page) => {
    const socket = pane(page).getByRole("button", { name: /^Output Mesh of / });
    const place = await middle(socket.first());
    await page.mouse.move(place.x, place.y);
    const tip = page.getByRole("tooltip");
    await tip.getByText(/^Mesh: mesh$/).waitFor();
    await tip.getByText(/\d+ vertices, .* triangles/).waitFor();
  }));
