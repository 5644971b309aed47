import assert from "node:assert/strict";
import { test } from "node:test";
import { keyOf, SHORTCUTS, shortcutFor, shortcutOf } from "../src/session/shortcuts";

test("no two shortcuts that can be heard together have the same key, and every one has a title", () => {
  for (const a of SHORTCUTS) {
    assert.ok(a.title.length > 2);
    assert.ok(a.keys.length > 0);
    for (const b of SHORTCUTS) {
      const isTogether = a.scope === b.scope || a.scope === "page" || b.scope === "page";
      if (a === b || !isTogether) continue;
      for (const key of a.keys) assert.ok(!b.keys.includes(key), `${key}: ${a.title} and ${b.title}`);
    }
  }
  const ids = SHORTCUTS.map(({ id }) => id);
  assert.equal(new Set(ids).size, ids.length);
});

test("keys are written as the table writes them", () => {
  const plain = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false };
  assert.equal(keyOf({ ...plain, key: "z", ctrlKey: true }), "Mod+Z");
  assert.equal(keyOf({ ...plain, key: "Z", metaKey: true, shiftKey: true }), "Mod+Shift+Z");
  assert.equal(keyOf({ ...plain, key: "?", shiftKey: true }), "?");
  assert.equal(keyOf({ ...plain, key: " " }), "Space");
  assert.equal(keyOf({ ...plain, key: "ArrowLeft", shiftKey: true }), "Shift+ArrowLeft");
  assert.equal(shortcutFor("Mod+Y", "page")?.id, "redo");
  assert.equal(shortcutFor("Mod+Y", "graph"), undefined);
});

test("keys that a browser or a screen reader needs are left alone", () => {
  const taken = ["Mod+T", "Mod+W", "Mod+N", "Mod+L", "Mod+R", "F5", "F6", "F12", "Alt+ArrowLeft", "Shift+Tab"];
  for (const { keys } of SHORTCUTS) for (const key of keys) assert.ok(!taken.includes(key), key);
});

test("on a keyboard of another script a letter is named after its place, and a Latin one means itself", () => {
  const plain = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false };
  const named = (key: string, code: string): string => keyOf({ ...plain, key, code });
  for (const key of ["я", "Я", "ζ", "ז", "ئ", "つ", "ㅋ", "لا"]) assert.equal(named(key, "KeyZ"), "Z", key);
  assert.equal(keyOf({ ...plain, key: "я", code: "KeyZ", ctrlKey: true, shiftKey: true }), "Mod+Shift+Z");
  assert.equal(named("w", "KeyZ"), "W");
  assert.equal(named("é", "Digit2"), "É");
  assert.equal(named("ö", "Semicolon"), "Ö");
  assert.equal(named("Enter", "Enter"), "Enter");
  assert.equal(named("ж", "Semicolon"), "Ж", "a place without a letter lends no name");
});

test("digits are found where they need Shift or another script, and signs that mean something are left alone", () => {
  const plain = { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false };
  const meant = (key: string, code: string): string | undefined => shortcutOf({ ...plain, key, code }, "model")?.id;
  assert.equal(meant("1", "Digit1"), "model-front");
  assert.equal(meant("&", "Digit1"), "model-front");
  assert.equal(meant("è", "Digit7"), "model-above");
  assert.equal(meant("۳", "Digit3"), "model-right");
  assert.equal(meant("+", "Digit1"), "model-zoom");
  assert.equal(meant("&", "KeyK"), undefined);
  assert.equal(shortcutOf({ ...plain, ctrlKey: true, key: "&", code: "Digit1" }, "model"), undefined);
});
