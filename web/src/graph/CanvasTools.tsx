import type { ReactElement } from "react";
import { layout } from "../session/actions";
import { IconButton } from "../widgets/Button";
import { useEditor } from "../widgets/context";

/** The canvas's buttons, for those who know no keys. */
export function CanvasTools({ onFit }: { onFit(): void }): ReactElement {
  const editor = useEditor();
  return (
    <div className="pane-tools" role="toolbar" aria-label="Canvas">
      <IconButton
        className="tool"
        label="Find a node"
        icon="search"
        hint="Find a node of this graph"
        shortcut="find"
        onClick={() => editor.store.set({ finding: true })}
      />
      <IconButton
        className="tool"
        label="Lay out"
        icon="layout"
        hint="Lay the graph out"
        shortcut="layout"
        onClick={() => layout(editor)}
      />
      <IconButton
        className="tool"
        label="Fit graph"
        icon="frame"
        hint="Show the whole graph"
        shortcut="fit-all"
        onClick={onFit}
      />
    </div>
  );
}
