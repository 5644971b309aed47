import type { ReactElement } from "react";
import { layout } from "../app/actions";
import { useEditor } from "../app/context";
import { Icon } from "../app/icons";
import { keyText } from "../app/shortcuts";

/** The canvas's buttons, for those who know no keys. */
export function CanvasTools({ onFit }: { onFit(): void }): ReactElement {
  const editor = useEditor();
  return (
    <div className="pane-tools" role="toolbar" aria-label="Canvas">
      <button
        type="button"
        className="tool"
        title={`Find a node of this graph (${keyText("find")})`}
        aria-label="Find a node"
        onClick={() => editor.store.set({ finding: true })}
      >
        <Icon name="search" />
      </button>
      <button
        type="button"
        className="tool"
        title={`Lay the graph out (${keyText("layout")})`}
        aria-label="Lay out"
        onClick={() => layout(editor)}
      >
        <Icon name="layout" />
      </button>
      <button
        type="button"
        className="tool"
        title={`Show the whole graph (${keyText("fit-all")})`}
        aria-label="Fit graph"
        onClick={onFit}
      >
        <Icon name="frame" />
      </button>
    </div>
  );
}
