import type { ReactElement } from "react";
import { useCurrent, useEditor } from "../widgets/context";
import { useRemembered } from "../widgets/hooks";

/**
 * Said once to someone new: what is on the page and how to change it. It has a place of its own below the panes, so that
 * it covers nothing of what it speaks of.
 */
export function Hint(): ReactElement | null {
  const editor = useEditor();
  const [seen, setSeen] = useRemembered("dini.hint", "");
  const isReady = useCurrent((state) => state.shown !== null);
  if (seen || !isReady) return null;
  const beginEmpty = (): void => {
    setSeen("yes");
    editor.session.newDocument();
  };
  return (
    <aside className="hint" aria-label="How to begin">
      <p className="hint-title">This is a finished graph. Change it.</p>
      <ul>
        <li>
          <strong>Drag a slider</strong> under the model, or any number on a node.
        </li>
        <li>
          <strong>Double-click the canvas</strong> to add a node; drag between sockets to connect.
        </li>
        <li>
          <strong>Ctrl+Z</strong> takes everything back; <strong>?</strong> lists every key.
        </li>
      </ul>
      <div className="hint-buttons">
        <button type="button" className="button quiet" onClick={beginEmpty}>
          Begin an empty graph
        </button>
        <button type="button" className="button primary" onClick={() => setSeen("yes")}>
          Understood
        </button>
      </div>
    </aside>
  );
}
