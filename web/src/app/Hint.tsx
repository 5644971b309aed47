import type { ReactElement } from "react";
import { useCurrent, useEditor } from "./context";
import { useRemembered } from "./hooks";
import { Icon } from "./icons";

/** Said once to someone new: what is on the page and how to change it. */
export function Hint(): ReactElement | null {
  const editor = useEditor();
  const [seen, setSeen] = useRemembered("dini.hint", "");
  const isReady = useCurrent((state) => state.shown !== null);
  if (seen || !isReady) return null;
  return (
    <aside className="hint" aria-label="How to begin">
      <button type="button" className="button icon-button" aria-label="Close the hint" onClick={() => setSeen("yes")}>
        <Icon name="close" />
      </button>
      <p className="hint-title">This is a finished graph. Change it.</p>
      <ul>
        <li>
          <strong>Drag a slider</strong> under the model, or any number on a node.
        </li>
        <li>
          <strong>Double-click the canvas</strong> to add a node; drag from socket to socket to connect.
        </li>
        <li>
          <strong>Ctrl+Z</strong> takes everything back; <strong>?</strong> lists every key.
        </li>
      </ul>
      <div className="hint-buttons">
        <button type="button" className="button quiet" onClick={() => editor.session.newDocument()}>
          Begin an empty graph
        </button>
        <button type="button" className="button primary" onClick={() => setSeen("yes")}>
          Understood
        </button>
      </div>
    </aside>
  );
}
