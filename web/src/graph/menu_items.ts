// What the context menus offer, by what was pressed. Each item names its shortcut, which runs the same action.

import { setInput } from "../model/edit";
import { disconnect } from "../model/edit_wires";
import { groupNamed } from "../model/scope";
import { frameKey } from "../model/ui";
import {
  addNoteHere,
  frameSelection,
  layout,
  recolor,
  remove,
  rename,
  selectAll,
  toggleBypass,
  toggleFlag,
  toggleFrame,
  unfoldSelection,
} from "../session/actions";
import { copy, cut, duplicate, pasteClipboard } from "../session/clipboard";
import type { Editor, Menu } from "../session/editor";
import { enter, groupSelection, leave, saveGroup, toggleGroupOutputs, ungroupSelection } from "../session/grouping";
import type { MenuItem } from "../widgets/Menu";

/** What the menus are called, for those who hear the page. */
export const MENU_LABELS = { canvas: "Canvas menu", node: "Node menu", wire: "Wire menu", area: "Area menu" } as const;

export function menuItems(editor: Editor, { target, screen }: Menu): MenuItem[] {
  switch (target.kind) {
    case "node":
      return nodeItems(editor, target.id, screen);
    case "wire": {
      const { wire } = target;
      return [
        { title: "Insert here…", run: () => editor.openSearch({ screen, wire }) },
        {
          title: "Disconnect",
          run: () => {
            editor.session.edit("Disconnect", disconnect(wire));
            editor.say(`Disconnected ${wire.input} of ${wire.to}`);
          },
        },
      ];
    }
    case "area":
      return [
        { title: "Rename", shortcut: "rename", run: () => rename(editor) },
        ...frameItems(editor, target.key),
        { title: "Delete", shortcut: "delete", run: () => remove(editor, false) },
      ];
    default:
      return canvasItems(editor, screen);
  }
}

function nodeItems(editor: Editor, id: string, screen: { x: number; y: number }): MenuItem[] {
  const { document } = editor.session.store.get();
  const node = document?.nodes.get(id);
  const links = [...(node?.inputs ?? [])].filter(([, sources]) => sources.some((source) => source.kind === "link"));
  return [
    { title: node?.bypass ? "Use again" : "Bypass", shortcut: "bypass", run: () => toggleBypass(editor) },
    {
      title: document?.previews.has(id) ? "Stop the preview" : "Preview in the model",
      shortcut: "preview",
      run: () => toggleFlag(editor, "preview"),
    },
    { title: "Rename", shortcut: "rename", run: () => rename(editor) },
    { title: "Replace by…", run: () => editor.openSearch({ screen, replaced: id }) },
    {
      title: "Disconnect all inputs",
      isDisabled: links.length === 0,
      run: () =>
        editor.session.edit("Disconnect", (present) =>
          links.reduce((changed, [name]) => setInput(id, name, undefined)(changed), present),
        ),
    },
    { title: "Show all inputs", shortcut: "unfold", run: () => unfoldSelection(editor), isNewGroup: true },
    {
      title: document?.collapsed.has(id) ? "Expand" : "Collapse",
      shortcut: "collapse",
      run: () => toggleFlag(editor, "collapsed"),
    },
    { title: "Another color", run: () => recolor(editor) },
    { title: "Frame the selection", shortcut: "frame", run: () => frameSelection(editor) },
    ...groupItems(editor, id),
    { title: "Copy", shortcut: "copy", run: () => void copy(editor), isNewGroup: true },
    { title: "Cut", shortcut: "cut", run: () => void cut(editor) },
    { title: "Duplicate", shortcut: "duplicate", run: () => duplicate(editor) },
    { title: "Delete and join the wires", shortcut: "heal", run: () => remove(editor, true), isNewGroup: true },
    { title: "Delete", shortcut: "delete", run: () => remove(editor, false) },
  ];
}

function frameItems(editor: Editor, key: string): MenuItem[] {
  const frame = editor.session.store.get().document?.frames.find(({ id }) => frameKey(id) === key);
  if (!frame) return [];
  const title = frame.collapsed ? "Expand" : "Collapse";
  return [{ title, shortcut: "collapse", run: () => toggleFrame(editor, frame.id) }];
}

function groupItems(editor: Editor, id: string): MenuItem[] {
  const { document } = editor.session.store.get();
  const isGroup = groupNamed(document?.nodes.get(id)?.type ?? "") !== undefined;
  const items: MenuItem[] = [
    { title: "Group the selection", shortcut: "group", run: () => groupSelection(editor), isNewGroup: true },
  ];
  if (isGroup) {
    items.push(
      { title: "Go into the group", shortcut: "enter", run: () => enter(editor, id) },
      { title: "Take the group apart", shortcut: "ungroup", run: () => ungroupSelection(editor) },
      { title: "Save the group to a file", run: () => saveGroup(editor, id) },
    );
  }
  if (document && document.inside.length > 0) {
    items.push(
      { title: "Outputs of the group, or not", run: () => toggleGroupOutputs(editor) },
      { title: "Leave the group", run: () => leave(editor) },
    );
  }
  return items;
}

function canvasItems(editor: Editor, screen: { x: number; y: number }): MenuItem[] {
  const { leftPans, times } = editor.store.get();
  return [
    { title: "Add a node…", shortcut: "add", run: () => editor.openSearch({ screen }) },
    { title: "Add a note", shortcut: "note", run: () => addNoteHere(editor) },
    { title: "Paste", shortcut: "paste", run: () => void pasteClipboard(editor, false), isNewGroup: true },
    { title: "Paste with incoming wires", shortcut: "paste-wired", run: () => void pasteClipboard(editor, true) },
    { title: "Select all", shortcut: "select-all", run: () => selectAll(editor) },
    { title: "Lay out", shortcut: "layout", run: () => layout(editor), isNewGroup: true },
    { title: "Show the whole graph", shortcut: "fit-all", run: () => editor.canvas?.fit() },
    { title: "Find a node…", shortcut: "find", run: () => editor.store.set({ finding: true }) },
    {
      title: leftPans ? "Left drag draws a box" : "Left drag moves the canvas",
      run: () => editor.setLeftPans(!leftPans),
      isNewGroup: true,
    },
    { title: times ? "Hide times" : "Show times", run: () => editor.setTimes(!times) },
  ];
}
