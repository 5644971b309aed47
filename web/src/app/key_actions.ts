// What the keys of the page and the graph do, by their ids in the table of shortcuts.

import { filesOf } from "../files/Files";
import { goTo, openNode } from "../graph/focus";
import {
  addNoteHere,
  collapse,
  frameSelection,
  layout,
  nudge,
  remove,
  rename,
  selectAll,
  toggleBypass,
  toggleFlag,
  unfoldSelection,
} from "../session/actions";
import { copy, cut, duplicate, pasteClipboard } from "../session/clipboard";
import type { Editor } from "../session/editor";
import { enterOrLeave, groupSelection, ungroupSelection } from "../session/grouping";
import type { GraphKey, PageKey } from "../session/shortcuts";

type Action = (editor: Editor) => void;

const STEP = 24;

export const KEY_ACTIONS: Readonly<Record<PageKey | GraphKey, Action>> = {
  undo: ({ session }) => session.undo(),
  redo: ({ session }) => session.redo(),
  "open-file": ({ session }) => void filesOf(session).ask(),
  save: ({ session }) => void filesOf(session).save(),
  "save-as": ({ session }) => void filesOf(session).save(true),
  help: (editor) => editor.store.set({ help: true }),
  add: (editor) => editor.openSearch(),
  find: (editor) => editor.store.set({ finding: true }),
  delete: (editor) => remove(editor, false),
  heal: (editor) => remove(editor, true),
  copy: (editor) => void copy(editor),
  cut: (editor) => void cut(editor),
  paste: (editor) => void pasteClipboard(editor, false),
  "paste-wired": (editor) => void pasteClipboard(editor, true),
  duplicate,
  "select-all": selectAll,
  bypass: toggleBypass,
  preview: (editor) => toggleFlag(editor, "preview"),
  collapse,
  unfold: unfoldSelection,
  rename,
  frame: frameSelection,
  group: groupSelection,
  ungroup: ungroupSelection,
  enter: enterOrLeave,
  note: addNoteHere,
  layout,
  fit: (editor) => editor.canvas?.fit(editor.session.store.get().selection),
  "fit-all": (editor) => editor.canvas?.fit(),
  open: openNode,
  leave,
  left: (editor) => goTo(editor, -1, 0),
  right: (editor) => goTo(editor, 1, 0),
  up: (editor) => goTo(editor, 0, -1),
  down: (editor) => goTo(editor, 0, 1),
  "move-left": (editor) => nudge(editor, -STEP, 0),
  "move-right": (editor) => nudge(editor, STEP, 0),
  "move-up": (editor) => nudge(editor, 0, -STEP),
  "move-down": (editor) => nudge(editor, 0, STEP),
};

function leave(editor: Editor): void {
  if (editor.closeAll()) return;
  editor.store.set({ wires: new Set() });
  editor.session.select([]);
}
