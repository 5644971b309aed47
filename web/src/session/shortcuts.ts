// The one table of keys: it drives the keyboard, the list behind "?", the hints of menus and buttons, and the test for
// clashes. What each key does is in app/key_actions.ts, and for the model in view3d/view_keys.ts.

import { digitOf, type KeyPress, keyName } from "../model/keys";

/** Where keys are heard: on the whole page, over the graph, or over the model. */
export type Scope = "page" | "graph" | "model";

interface Entry {
  id: string;
  title: string;
  /** As "Mod+Shift+Z": Mod is Ctrl, or Command on a Mac. */
  keys: readonly string[];
  /** Works while a text field without unfinished text has the focus. */
  inFields?: boolean;
}

export interface Shortcut<In extends Scope = Scope> extends Entry {
  id: Ids[In];
  scope: In;
}

const PAGE = [
  { id: "undo", title: "Undo", keys: ["Mod+Z"], inFields: true },
  { id: "redo", title: "Redo", keys: ["Mod+Shift+Z", "Mod+Y"], inFields: true },
  { id: "open-file", title: "Open a file", keys: ["Mod+O"], inFields: true },
  { id: "save", title: "Save", keys: ["Mod+S"], inFields: true },
  { id: "save-as", title: "Save as another file", keys: ["Mod+Shift+S"], inFields: true },
  { id: "help", title: "This list", keys: ["?"] },
] as const satisfies readonly Entry[];

const GRAPH = [
  { id: "add", title: "Add a node", keys: ["Shift+A", "Space", "Tab"] },
  { id: "find", title: "Find a node of this graph", keys: ["Mod+F"] },
  { id: "delete", title: "Delete", keys: ["Delete", "Backspace", "X"] },
  { id: "heal", title: "Delete and join the wires", keys: ["Mod+Delete", "Mod+Backspace"] },
  { id: "copy", title: "Copy", keys: ["Mod+C"] },
  { id: "cut", title: "Cut", keys: ["Mod+X"] },
  { id: "paste", title: "Paste", keys: ["Mod+V"] },
  { id: "paste-wired", title: "Paste with incoming wires", keys: ["Mod+Shift+V"] },
  { id: "duplicate", title: "Duplicate", keys: ["Mod+D"] },
  { id: "select-all", title: "Select all", keys: ["Mod+A"] },
  { id: "bypass", title: "Bypass", keys: ["M"] },
  { id: "preview", title: "Preview in the model", keys: ["V"] },
  { id: "collapse", title: "Collapse", keys: ["H"] },
  { id: "unfold", title: "Show all inputs", keys: ["D"] },
  { id: "rename", title: "Rename", keys: ["F2"] },
  { id: "frame", title: "Frame the selection", keys: ["Mod+J"] },
  { id: "group", title: "Group the selection", keys: ["Mod+G"] },
  { id: "ungroup", title: "Take the group apart", keys: ["Mod+Shift+G"] },
  { id: "enter", title: "Go into the group, or out of it (Tab does too)", keys: ["Mod+Enter"] },
  { id: "note", title: "Add a note", keys: ["N"] },
  { id: "layout", title: "Lay out", keys: ["L"] },
  { id: "fit", title: "Show the selection", keys: ["F"] },
  { id: "fit-all", title: "Show the whole graph", keys: ["Home"] },
  { id: "open", title: "Go into the node: its sockets and fields", keys: ["Enter"] },
  { id: "leave", title: "Leave the node, or clear the selection", keys: ["Escape"] },
  { id: "left", title: "Go to the node on the left", keys: ["ArrowLeft"] },
  { id: "right", title: "Go to the node on the right", keys: ["ArrowRight"] },
  { id: "up", title: "Go to the node above", keys: ["ArrowUp"] },
  { id: "down", title: "Go to the node below", keys: ["ArrowDown"] },
  { id: "move-left", title: "Move left", keys: ["Shift+ArrowLeft"] },
  { id: "move-right", title: "Move right", keys: ["Shift+ArrowRight"] },
  { id: "move-up", title: "Move up", keys: ["Shift+ArrowUp"] },
  { id: "move-down", title: "Move down", keys: ["Shift+ArrowDown"] },
] as const satisfies readonly Entry[];

const MODEL = [
  { id: "model-fill", title: "Fill the view with the selection, or the model", keys: ["F"] },
  { id: "model-home", title: "Opening view", keys: ["Home"] },
  { id: "model-front", title: "From the front", keys: ["1"] },
  { id: "model-right", title: "From the right", keys: ["3"] },
  { id: "model-above", title: "From above", keys: ["7"] },
  { id: "model-perspective", title: "With or without perspective", keys: ["5"] },
  { id: "model-turn", title: "Turn", keys: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"] },
  { id: "model-zoom", title: "Zoom", keys: ["+", "-"] },
] as const satisfies readonly Entry[];

export type PageKey = (typeof PAGE)[number]["id"];
export type GraphKey = (typeof GRAPH)[number]["id"];
export type ModelKey = (typeof MODEL)[number]["id"];
export type ShortcutId = PageKey | GraphKey | ModelKey;

interface Ids {
  page: PageKey;
  graph: GraphKey;
  model: ModelKey;
}

export const SHORTCUTS: readonly Shortcut[] = [
  ...PAGE.map((item) => ({ ...item, scope: "page" as const })),
  ...GRAPH.map((item) => ({ ...item, scope: "graph" as const })),
  ...MODEL.map((item) => ({ ...item, scope: "model" as const })),
];

type Pressed = KeyPress & Pick<KeyboardEvent, "ctrlKey" | "metaKey" | "shiftKey" | "altKey">;

/** The key of an event as the table writes it. */
export function keyOf(event: Pressed): string {
  return withModifiers(event, keyName(event));
}

export function shortcutFor<In extends Scope>(key: string, scope: In): Shortcut<In> | undefined {
  const isMeant = (item: Shortcut): item is Shortcut<In> => item.scope === scope && item.keys.includes(key);
  return SHORTCUTS.find(isMeant);
}

/** The shortcut that an event means: by its key, else by the digit of that key on keyboards where it needs Shift. */
export function shortcutOf<In extends Scope>(event: Pressed, scope: In): Shortcut<In> | undefined {
  const digit = digitOf(event);
  const byDigit = digit === undefined ? undefined : withModifiers({ ...event, key: digit }, digit);
  return shortcutFor(keyOf(event), scope) ?? (byDigit === undefined ? undefined : shortcutFor(byDigit, scope));
}

/** A key of a shortcut, its first unless told, as menus and tooltips show it. */
export function keyText(id: ShortcutId, index = 0): string {
  const key = SHORTCUTS.find((item) => item.id === id)?.keys[index] ?? "";
  return key
    .replace("Mod", /Mac|iP/.test(globalThis.navigator?.platform ?? "") ? "⌘" : "Ctrl")
    .replace(/Arrow(\w+)/, (_, way: string) => ({ Left: "←", Right: "→", Up: "↑", Down: "↓" })[way] ?? way);
}

function withModifiers({ key, ctrlKey, metaKey, altKey, shiftKey }: Pressed, name: string): string {
  // Signs such as "?" are typed with Shift on some keyboards and without on others.
  const isSign = key.length === 1 && key !== " " && key.toLowerCase() === key.toUpperCase();
  const parts = [(ctrlKey || metaKey) && "Mod", altKey && "Alt", shiftKey && !isSign && "Shift", name];
  return parts.filter(Boolean).join("+");
}
