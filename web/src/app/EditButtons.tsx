import type { ReactElement } from "react";
import { addNoteHere, frameSelection, layout, remove, selectAll, toggleBypass, toggleFlag } from "../session/actions";
import { align, distribute } from "../session/arrange";
import { copy, cut, duplicate, pasteClipboard } from "../session/clipboard";
import { keyText } from "../session/shortcuts";
import { IconButton } from "../widgets/Button";
import { useCurrent, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { DropMenu } from "../widgets/Menu";
import { Tip } from "../widgets/Tip";

/** Undo, redo, the Edit menu and the way to a new node. */
export function EditButtons(): ReactElement {
  const editor = useEditor();
  const { session } = editor;
  const undoLabel = useCurrent((state) => state.undoLabel);
  const redoLabel = useCurrent((state) => state.redoLabel);
  const isOpen = useCurrent((state) => state.document !== null);
  return (
    <div className="edit-buttons" role="group" aria-label="Edit">
      <IconButton
        label="Undo"
        icon="undo"
        hint={undoLabel === undefined ? "Nothing to undo" : `Undo: ${undoLabel}`}
        shortcut="undo"
        disabled={undoLabel === undefined}
        onClick={() => session.undo()}
      />
      <IconButton
        label="Redo"
        icon="redo"
        hint={redoLabel === undefined ? "Nothing to redo" : `Redo: ${redoLabel}`}
        shortcut="redo"
        disabled={redoLabel === undefined}
        onClick={() => session.redo()}
      />
      <EditMenu />
      <Tip text="Add a node" keys={keyText("add")}>
        <button
          type="button"
          className="button add-button"
          disabled={!isOpen}
          onClick={(event) => {
            const box = event.currentTarget.getBoundingClientRect();
            const place = editor.canvas?.placeAt(editor.canvas.pointer());
            editor.openSearch({ screen: { x: box.left, y: box.bottom + 6 }, ...(place && { place }) });
          }}
        >
          <Icon name="add" />
          <span>Add node</span>
        </button>
      </Tip>
    </div>
  );
}

/** The actions on the selection, for hands without keys. */
function EditMenu(): ReactElement {
  const editor = useEditor();
  const hasNodes = useCurrent((state) => state.selection.size > 0);
  const hasAny = useCurrent((state) => state.selection.size + state.areas.size > 0);
  return (
    <DropMenu
      label="Edit"
      className="button edit-menu-button"
      items={[
        { title: "Cut", shortcut: "cut", isDisabled: !hasAny, run: () => void cut(editor) },
        { title: "Copy", shortcut: "copy", isDisabled: !hasAny, run: () => void copy(editor) },
        { title: "Paste", shortcut: "paste", run: () => void pasteClipboard(editor, false) },
        {
          title: "Paste with incoming wires",
          shortcut: "paste-wired",
          run: () => void pasteClipboard(editor, true),
        },
        { title: "Duplicate", shortcut: "duplicate", isDisabled: !hasAny, run: () => duplicate(editor) },
        { title: "Delete", shortcut: "delete", isDisabled: !hasAny, run: () => remove(editor, false) },
        {
          title: "Delete and join the wires",
          shortcut: "heal",
          isDisabled: !hasNodes,
          run: () => remove(editor, true),
        },
        { title: "Select all", shortcut: "select-all", run: () => selectAll(editor), isNewGroup: true },
        { title: "Bypass", shortcut: "bypass", isDisabled: !hasNodes, run: () => toggleBypass(editor) },
        {
          title: "Preview in the model",
          shortcut: "preview",
          isDisabled: !hasNodes,
          run: () => toggleFlag(editor, "preview"),
        },
        { title: "Frame the selection", shortcut: "frame", run: () => frameSelection(editor), isNewGroup: true },
        { title: "Add a note", shortcut: "note", run: () => addNoteHere(editor) },
        { title: "Lay out", shortcut: "layout", run: () => layout(editor) },
        { title: "Align left edges", isDisabled: !hasNodes, run: () => align(editor, "left"), isNewGroup: true },
        { title: "Align upper edges", isDisabled: !hasNodes, run: () => align(editor, "top") },
        { title: "Distribute across", isDisabled: !hasNodes, run: () => distribute(editor, "across") },
        { title: "Distribute downward", isDisabled: !hasNodes, run: () => distribute(editor, "down") },
      ]}
    >
      <span>Edit</span>
    </DropMenu>
  );
}
