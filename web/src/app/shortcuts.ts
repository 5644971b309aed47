// The one table of keys: it drives the keyboard, the list behind "?", the menus' hints and the test for clashes.

import {
  addNoteHere,
  copy,
  cut,
  duplicate,
  frameSelection,
  layout,
  nudge,
  pasteClipboard,
  remove,
  selectAll,
  toggleBypass,
  toggleFlag,
} from "./actions";
import { keyName, type KeyPress } from "../model/keys";
import { VIEW_KEYS } from "../view3d/view_keys";
import { filesOf } from "../files/Files";
import type { Editor } from "./editor";
import { goTo, openNode, rename, unfoldSelection } from "./focus";

/** Where keys are heard: on the whole page, over the graph, or over the model, which hears its own. */
export type Scope = "page" | "graph" | "model";

export interface Shortcut {
  id: string;
  title: string;
  scope: Scope;
  /** As "Mod+Shift+Z": Mod is Ctrl, or Command on a Mac. */
  keys: readonly string[];
  /** Left out where another part of the page hears the key. */
  run?(editor: Editor): void;
  /** Works while a text field without unfinished text has the focus. */
  inFields?: boolean;
}

const STEP = 24;

const GRAPH: readonly Omit<Shortcut, "scope">[] = [
  { id: "add", title: "Add a node", keys: ["Shift+A", "Space", "Tab"], run: (editor) => editor.openSearch() },
  {
    id: "find",
    title: "Find a node of this graph",
    keys: ["Mod+F"],
    run: (editor) => editor.store.set({ finding: true }),
  },
  { id: "delete", title: "Delete", keys: ["Delete", "Backspace", "X"], run: (editor) => remove(editor, false) },
  {
    id: "heal",
    title: "Delete and join the wires",
    keys: ["Mod+Delete", "Mod+Backspace"],
    run: (editor) => remove(editor, true),
  },
  { id: "copy", title: "Copy", keys: ["Mod+C"], run: (editor) => void copy(editor) },
  { id: "cut", title: "Cut", keys: ["Mod+X"], run: (editor) => void cut(editor) },
  { id: "paste", title: "Paste", keys: ["Mod+V"], run: (editor) => void pasteClipboard(editor, false) },
  {
    id: "paste-wired",
    title: "Paste with incoming wires",
    keys: ["Mod+Shift+V"],
    run: (editor) => void pasteClipboard(editor, true),
  },
  { id: "duplicate", title: "Duplicate", keys: ["Mod+D"], run: duplicate },
  { id: "select-all", title: "Select all", keys: ["Mod+A"], run: selectAll },
  { id: "bypass", title: "Bypass", keys: ["M"], run: toggleBypass },
  { id: "preview", title: "Preview in the model", keys: ["V"], run: (editor) => toggleFlag(editor, "preview") },
  { id: "collapse", title: "Collapse", keys: ["H"], run: (editor) => toggleFlag(editor, "collapsed") },
  { id: "unfold", title: "Show all inputs", keys: ["D"], run: unfoldSelection },
  { id: "rename", title: "Rename", keys: ["F2"], run: rename },
  { id: "frame", title: "Frame the selection", keys: ["Mod+J", "Mod+G"], run: frameSelection },
  { id: "note", title: "Add a note", keys: ["N"], run: addNoteHere },
  { id: "layout", title: "Lay out", keys: ["L"], run: layout },
  {
    id: "fit",
    title: "Show the selection",
    keys: ["F"],
    run: (editor) => editor.canvas?.fit(editor.session.store.get().selection),
  },
  { id: "fit-all", title: "Show the whole graph", keys: ["Home"], run: (editor) => editor.canvas?.fit() },
  { id: "open", title: "Go into the node: its sockets and fields", keys: ["Enter"], run: openNode },
  { id: "leave", title: "Leave the node, or clear the selection", keys: ["Escape"], run: leave },
  { id: "left", title: "Go to the node on the left", keys: ["ArrowLeft"], run: (editor) => goTo(editor, -1, 0) },
  { id: "right", title: "Go to the node on the right", keys: ["ArrowRight"], run: (editor) => goTo(editor, 1, 0) },
  { id: "up", title: "Go to the node above", keys: ["ArrowUp"], run: (editor) => goTo(editor, 0, -1) },
  { id: "down", title: "Go to the node below", keys: ["ArrowDown"], run: (editor) => goTo(editor, 0, 1) },
  { id: "move-left", title: "Move left", keys: ["Shift+ArrowLeft"], run: (editor) => nudge(editor, -STEP, 0) },
  { id: "move-right", title: "Move right", keys: ["Shift+ArrowRight"], run: (editor) => nudge(editor, STEP, 0) },
  { id: "move-up", title: "Move up", keys: ["Shift+ArrowUp"], run: (editor) => nudge(editor, 0, -STEP) },
  { id: "move-down", title: "Move down", keys: ["Shift+ArrowDown"], run: (editor) => nudge(editor, 0, STEP) },
];

const PAGE: readonly Omit<Shortcut, "scope">[] = [
  { id: "undo", title: "Undo", keys: ["Mod+Z"], run: ({ session }) => session.undo(), inFields: true },
  { id: "redo", title: "Redo", keys: ["Mod+Shift+Z", "Mod+Y"], run: ({ session }) => session.redo(), inFields: true },
  { id: "open-file", title: "Open a file", keys: ["Mod+O"], run: ({ session }) => void filesOf(session).ask(), inFields: true },
  { id: "save", title: "Save", keys: ["Mod+S"], run: ({ session }) => void filesOf(session).save(), inFields: true },
  {
    id: "save-as",
    title: "Save as another file",
    keys: ["Mod+Shift+S"],
    run: ({ session }) => void filesOf(session).save(true),
    inFields: true,
  },
  { id: "help", title: "This list", keys: ["?"], run: (editor) => editor.store.set({ help: true }) },
];

const MODEL: readonly Omit<Shortcut, "scope">[] = [
  ...VIEW_KEYS.map(({ key, text }) => ({
    id: `model-${key}`,
    title: text,
    keys: [key],
  })),
  { id: "model-turn", title: "Turn", keys: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"] },
  { id: "model-zoom", title: "Zoom", keys: ["+", "-"] },
];

export const SHORTCUTS: readonly Shortcut[] = [
  ...PAGE.map((item) => ({ ...item, scope: "page" as const })),
  ...GRAPH.map((item) => ({ ...item, scope: "graph" as const })),
  ...MODEL.map((item) => ({ ...item, scope: "model" as const })),
];

type Pressed = KeyPress & Pick<KeyboardEvent, "ctrlKey" | "metaKey" | "shiftKey" | "altKey">;

/** The key of an event as the table writes it. */
export function keyOf(event: Pressed): string {
  const name = keyName(event);
  // Signs such as "?" are typed with Shift on some keyboards and without on others.
  const isSign = event.key.length === 1 && event.key !== " " && event.key.toLowerCase() === event.key.toUpperCase();
  const parts = [
    (event.ctrlKey || event.metaKey) && "Mod",
    event.altKey && "Alt",
    event.shiftKey && !isSign && "Shift",
    name,
  ];
  return parts.filter(Boolean).join("+");
}

export function shortcutFor(key: string, scope: Scope): Shortcut | undefined {
  return SHORTCUTS.find((item) => item.scope === scope && item.keys.includes(key));
}

/** The first key of a shortcut as menus and tooltips show it. */
export function keyText(id: string, index = 0): string {
  const key = SHORTCUTS.find((item) => item.id === id)?.keys[index] ?? "";
  return key
    .replace("Mod", /Mac|iP/.test(globalThis.navigator?.platform ?? "") ? "⌘" : "Ctrl")
    .replace(/Arrow(\w+)/, (_, way: string) => ({ Left: "←", Right: "→", Up: "↑", Down: "↓" })[way] ?? way);
}

function leave(editor: Editor): void {
  if (editor.closeAll()) return;
  editor.store.set({ wires: new Set() });
  editor.session.select([]);
}
