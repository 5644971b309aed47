// Hands on keys and fields, whatever the keyboard: modifiers, input methods, layouts, commas, texts that are no numbers.

import assert from "node:assert/strict";
import { test } from "node:test";
import { addNode, at, choose, drag, inPanel, node, untilGraph, untilSelected, withEditor } from "./editing.mjs";
import { useServer } from "./fixture.mjs";
import { changes, eventually, still } from "./harness.mjs";

const RING = "#example=fig04_boosted_ring";
const used = useServer();
const large = { width: 1500, height: 900 };
const empty = (run) => withEditor(used, { isEmpty: true, ...large }, run);
const ring = (run, options = {}) => withEditor(used, { hash: RING, ...large, ...options }, run);

const field = (page, id, name) => node(page, id).getByRole("textbox", { name: new RegExp(`^${name} of `, "i") });
const panel = (page) => page.getByRole("tabpanel", { name: "Node" });

for (const key of ["Shift", "Control"]) {
  test(`a number is dragged from where it is with ${key} held from the beginning`, () =>
    empty(async (page) => {
      await addNode(page, "circle", 300, 260);
      const radius = field(page, "circle", "radius");
      for (const place of [radius, panel(page).getByRole("textbox", { name: "radius of Circle" })]) {
        const before = Number(await place.inputValue());
        const box = await still(place);
        const start = { x: box.x + 30, y: box.y + box.height / 2 };
        await page.keyboard.down(key);
        await drag(page, start, { x: start.x + 24, y: start.y });
        await page.keyboard.up(key);
        const after = await eventually(
          async () => Number(await place.inputValue()),
          (value) => value !== before,
          "a dragged number",
        );
        // 24 of some hundred pixels of a range of 4, a tenth of that with Shift.
        const most = key === "Shift" ? 0.12 : 1.2;
        assert.ok(after > before && after - before <= most, `${before} became ${after}`);
        await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius === after);
      }
      // No box was drawn on the canvas meanwhile, and the node stayed where it was.
      assert.equal(await page.locator(".react-flow__selection").count(), 0);
      await untilSelected(page, ["circle"]);
    }));
}

/** A key as an input method sends it while it composes, in both ways browsers tell. */
async function pressComposing(page, key) {
  for (const told of [{ isComposing: true }, { keyCode: 229 }]) {
    await page.evaluate(
      ([key, told]) => {
        const event = new KeyboardEvent("keydown", { key, code: key, bubbles: true, cancelable: true, ...told });
        document.activeElement.dispatchEvent(event);
      },
      [key, told],
    );
  }
}

test("Enter and Escape belong to the input method while it composes", () =>
  empty(async (page) => {
    // The search.
    const place = await at(page, 300, 260);
    await page.mouse.dblclick(place.x, place.y);
    const search = page.getByRole("combobox", { name: "Add a node" });
    await search.fill("circle");
    await pressComposing(page, "Enter");
    await pressComposing(page, "Escape");
    await pressComposing(page, "ArrowDown");
    await search.waitFor();
    assert.equal(await page.locator(".react-flow__node").count(), 0);
    assert.equal(await page.getByRole("option").first().getAttribute("aria-selected"), "true");
    await page.keyboard.press("Enter");
    await inPanel(page, "circle");
    // A node's name.
    await choose(page, "circle");
    await page.keyboard.press("F2");
    const name = page.getByRole("textbox", { name: "Name of the node" });
    await name.fill("ring");
    await pressComposing(page, "Enter");
    await pressComposing(page, "Escape");
    assert.equal(await name.inputValue(), "ring");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.ring !== undefined);
    // A frame's title.
    await choose(page, "ring");
    await page.keyboard.press("Control+j");
    const frame = page.getByRole("textbox", { name: "Title of the frame" });
    await frame.fill("曲面");
    await pressComposing(page, "Enter");
    await pressComposing(page, "Escape");
    assert.equal(await frame.inputValue(), "曲面");
    await page.keyboard.press("Enter");
    await page.locator(".frame-title", { hasText: "曲面" }).waitFor();
    // The graph's title.
    const title = page.getByRole("textbox", { name: "Title of the graph" });
    await title.fill("きょく");
    await pressComposing(page, "Enter");
    await pressComposing(page, "Escape");
    assert.equal(await title.evaluate((element) => document.activeElement === element), true);
    assert.equal(await title.inputValue(), "きょく");
    await page.keyboard.press("Enter");
    await eventually(() => page.getByRole("heading", { level: 1 }).textContent(), "きょく");
    // Numbers.
    const radius = field(page, "ring", "radius");
    await radius.click();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("2");
    await pressComposing(page, "Enter");
    await pressComposing(page, "ArrowUp");
    assert.equal(await radius.inputValue(), "2");
    assert.equal(page.graph().nodes.ring.inputs.radius, undefined);
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.ring.inputs.radius === 2);
    // Connecting.
    const out = node(page, "ring").getByRole("button", { name: /^Output Circle of / });
    await out.focus();
    await page.keyboard.press("Enter");
    const list = page.getByRole("combobox", { name: "Connect circle of Circle" });
    await list.waitFor();
    await pressComposing(page, "Enter");
    await list.waitFor();
    await page.keyboard.press("Escape");
    await list.waitFor({ state: "detached" });
  }));

/** A press of a key as a keyboard of another script sends it. */
async function pressOn(page, key, code, modifiers = 0) {
  const session = await page.context().newCDPSession(page);
  const common = { key, code, modifiers, windowsVirtualKeyCode: code.at(-1).charCodeAt(0) };
  await session.send("Input.dispatchKeyEvent", { type: "rawKeyDown", ...common });
  await session.send("Input.dispatchKeyEvent", { type: "keyUp", ...common });
  await session.detach();
}

const CONTROL = 2;
const SCRIPTS = {
  Cyrillic: { a: "ф", z: "я", h: "р", m: "ь", d: "в", n: "т", c: "с", v: "м" },
  Greek: { a: "α", z: "ζ", h: "η", m: "μ", d: "δ", n: "ν", c: "ψ", v: "ω" },
  Hebrew: { a: "ש", z: "ז", h: "י", m: "צ", d: "ג", n: "מ", c: "ב", v: "ה" },
};

for (const [script, letters] of Object.entries(SCRIPTS)) {
  test(`shortcuts are where they are on a ${script} keyboard`, () =>
    empty(async (page) => {
      const press = (letter, modifiers) => pressOn(page, letters[letter], `Key${letter.toUpperCase()}`, modifiers);
      await addNode(page, "circle", 300, 260);
      await choose(page, "circle");
      await press("m");
      await untilGraph(page, ({ nodes }) => nodes.circle.bypass === true);
      await press("z", CONTROL);
      await untilGraph(page, ({ nodes }) => nodes.circle.bypass === undefined);
      await press("d", CONTROL);
      await untilGraph(page, ({ nodes }) => nodes.circle_2 !== undefined);
      await press("a", CONTROL);
      await untilSelected(page, ["circle", "circle_2"]);
      await press("h");
      await page.locator('[data-id="circle"] .node[data-collapsed="true"]').waitFor();
      await press("c", CONTROL);
      await press("v", CONTROL);
      await untilGraph(page, ({ nodes }) => nodes.circle_3 !== undefined);
    }));
}

test("a letter of the Latin script means itself, wherever it is on the keyboard", () =>
  empty(async (page) => {
    await addNode(page, "circle", 300, 260);
    await choose(page, "circle");
    // On a French keyboard Z is where W is elsewhere; on a Dvorak one the key of X has a Q.
    await page.keyboard.press("m");
    await untilGraph(page, ({ nodes }) => nodes.circle.bypass === true);
    await pressOn(page, "w", "KeyZ", CONTROL);
    await pressOn(page, "q", "KeyX");
    await pressOn(page, "z", "KeyW", CONTROL);
    await untilGraph(page, ({ nodes }) => nodes.circle && nodes.circle.bypass === undefined);
  }));

test("the view's keys are where they are on a French and on a Cyrillic keyboard", () =>
  ring(async (page) => {
    const view = page.getByRole("region", { name: "Model" });
    const box = await view.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    for (const [key, code] of [
      ["а", "KeyF"],
      ["&", "Digit1"],
      ['"', "Digit3"],
      ["è", "Digit7"],
      ["(", "Digit5"],
    ]) {
      await changes(page, key, () => pressOn(page, key, code));
    }
  }));

test("a comma means the same in fields, lists and the search", () =>
  empty(async (page) => {
    await addNode(page, "list", 300, 200);
    const items = panel(page).getByRole("textbox", { name: "items of List" });
    for (const [text, values] of [
      ["1,5; 2,5", [1.5, 2.5]],
      ["1, 2, 3", [1, 2, 3]],
      ["1,2,3", [1, 2, 3]],
      ["1,5", [1.5]],
      ["1.5,2.5", [1.5, 2.5]],
      ["-1,5;2*0,5", [-1.5, 1]],
    ]) {
      await items.fill(text);
      await page.keyboard.press("Enter");
      await untilGraph(page, ({ nodes }) => JSON.stringify(nodes.list.inputs.items) === JSON.stringify(values));
    }
    await items.fill("(0,5; 1; 2) (1,0,0)");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => JSON.stringify(nodes.list.inputs.items) === "[[0.5,1,2],[1,0,0]]");
    await addNode(page, "circle", 300, 500);
    const radius = panel(page).getByRole("textbox", { name: "radius of Circle" });
    await radius.fill("1,5");
    await page.keyboard.press("Enter");
    await untilGraph(page, ({ nodes }) => nodes.circle.inputs.radius === 1.5);
    await radius.fill("1,5; 2");
    await page.keyboard.press("Enter");
    await page.getByRole("alert").filter({ hasText: "“1,5; 2”" }).waitFor();
    assert.equal(page.graph().nodes.circle.inputs.radius, 1.5);
    const place = await at(page, 600, 300);
    const found = async (text) => {
      await page.mouse.dblclick(place.x, place.y);
      await page.getByRole("combobox", { name: "Add a node" }).fill(text);
      const first = await page.getByRole("option").first().textContent();
      await page.keyboard.press("Escape");
      return first;
    };
    assert.match(await found("1,5"), /^Number 1\.5/);
    assert.match(await found("1,2,3"), /^(Point|Vector) \(1, 2, 3\)/);
    assert.match(await found("0,5; 1; 1,5"), /^(Point|Vector) \(0\.5, 1, 1\.5\)/);
    assert.match(await found("0<1,5<10"), /^Number 1\.5, slider 0 to 10/);
  }));

test("what is no number says so in a sentence at its own field, on the node and in the panel", () =>
  empty(async (page) => {
    await addNode(page, "circle", 300, 200);
    await page.getByRole("button", { name: /^Hide defaults/ }).waitFor();
    const on = { node: node(page, "circle"), panel: panel(page) };
    for (const where of [on.node, on.panel]) {
      const x = where.getByRole("textbox", { name: "center x of Circle" });
      const others = ["center y of Circle", "center z of Circle", "normal x of Circle", "radius of Circle"];
      await x.fill("wide");
      await page.keyboard.press("Tab");
      const sentence = where.getByRole("alert");
      await sentence.filter({ hasText: /^“wide” is not a number or a formula such as 2\*pi\/3\.$/ }).waitFor();
      assert.equal(await sentence.count(), 1);
      assert.equal(await x.getAttribute("aria-invalid"), "true");
      const described = await x.getAttribute("aria-describedby");
      assert.ok(described.split(" ").includes(await sentence.getAttribute("id")), "the sentence is the field's");
      for (const name of others) {
        const other = where.getByRole("textbox", { name });
        assert.notEqual(await other.getAttribute("aria-invalid"), "true", name);
      }
      assert.equal(await where.locator(".number-input[data-invalid=true]").count(), 1);
      // What stands in the graph is as it was, and a number mends it.
      assert.equal(page.graph().nodes.circle.inputs.center, undefined);
      await x.fill("0,5");
      await page.keyboard.press("Enter");
      await untilGraph(page, ({ nodes }) => JSON.stringify(nodes.circle.inputs.center) === "[0.5,0,0]");
      await sentence.waitFor({ state: "detached" });
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Undo" }).click();
      await untilGraph(page, ({ nodes }) => nodes.circle.inputs.center === undefined);
    }
    // A list, and a parameter of the form.
    await addNode(page, "list", 300, 600);
    const items = on.panel.getByRole("textbox", { name: "items of List" });
    await items.fill("1; two");
    await page.keyboard.press("Enter");
    await on.panel.getByRole("alert").filter({ hasText: "“1; two” is no list of numbers" }).waitFor();
    assert.equal(await items.inputValue(), "1; two", "what was typed is there to be mended");
  }));
