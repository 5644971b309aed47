import { useState, type ReactElement } from "react";
import {
  copy,
  cut,
  duplicate,
  frameSelection,
  addNoteHere,
  layout,
  pasteClipboard,
  remove,
  selectAll,
  toggleBypass,
  toggleFlag,
} from "./actions";
import { useCurrent, useEditor } from "./context";
import { Icon } from "./icons";
import { keyText } from "./shortcuts";
import { MenuList } from "../graph/ContextMenu";
import { Popup } from "../graph/Popup";

/** Undo, redo, the Edit menu and the way to a new node. */
export function EditButtons(): ReactElement {
  const editor = useEditor();
  const { session } = editor;
  const undoLabel = useCurrent((state) => state.undoLabel);
  const redoLabel = useCurrent((state) => state.redoLabel);
  const isOpen = useCurrent((state) => state.document !== null);
  return (
    <div className="edit-buttons" role="group" aria-label="Edit">
      <button
        type="button"
        className="button icon-button"
        disabled={undoLabel === undefined}
        aria-label="Undo"
        title={undoLabel === undefined ? "Nothing to undo" : `Undo: ${undoLabel} (${keyText("undo")})`}
        onClick={() => session.undo()}
      >
        <Icon name="undo" />
      </button>
      <button
        type="button"
        className="button icon-button"
        disabled={redoLabel === undefined}
        aria-label="Redo"
        title={redoLabel === undefined ? "Nothing to redo" : `Redo: ${redoLabel} (${keyText("redo")})`}
        onClick={() => session.redo()}
      >
        <Icon name="redo" />
      </button>
      <EditMenu />
      <button
        type="button"
        className="button add-button"
        disabled={!isOpen}
        title={`Add a node (${keyText("add")})`}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          const place = editor.canvas?.placeAt(editor.canvas.pointer());
          editor.openSearch({ screen: { x: box.left, y: box.bottom + 6 }, ...(place && { place }) });
        }}
      >
        <Icon name="plus" />
        <span>Add node</span>
      </button>
    </div>
  );
}

/** The actions on the selection, for hands without keys. */
function EditMenu(): ReactElement {
  const editor = useEditor();
  const [screen, setScreen] = useState<{ x: number; y: number } | null>(null);
  const hasNodes = useCurrent((state) => state.selection.size > 0);
  const hasAny = useCurrent((state) => state.selection.size + state.areas.size > 0);
  const close = (): void => setScreen(null);
  return (
    <>
      <button
        type="button"
        className="button edit-menu-button"
        aria-haspopup="menu"
        aria-expanded={screen !== null}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          setScreen(screen ? null : { x: box.left, y: box.bottom + 6 });
        }}
      >
        <span>Edit</span>
        <Icon name="chevron" />
      </button>
      {screen && (
        <Popup screen={screen} label="Edit" className="context-menu" role="menu" onClose={close}>
          <MenuList
            onDone={close}
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
            ]}
          />
        </Popup>
      )}
    </>
  );
}
