import type { ReactElement } from "react";
import { keyText, type Scope, SHORTCUTS } from "../session/shortcuts";
import { useEditing, useEditor } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";

const GROUPS: readonly { scope: Scope; title: string }[] = [
  { scope: "page", title: "Everywhere" },
  { scope: "graph", title: "Over the graph" },
  { scope: "model", title: "Over the model" },
];

const POINTER: readonly [string, string][] = [
  ["Add a node", "double-click on the canvas"],
  ["Connect", "drag from socket to socket; let go on the canvas for a new node"],
  ["Take a wire off", "drag its end from the input"],
  ["Insert on a wire", "drag an unwired node over it"],
  ["Select", "drag a box; Shift adds"],
  ["Move the canvas", "middle or right button, or Space, and drag"],
  ["Zoom", "wheel, or pinch"],
  ["Preview a node", "Alt and a press on it"],
  ["Change a number", "drag it: Shift finer, Ctrl in larger steps; click to type, also 2*pi/3 or 3 mm"],
  ["Back to the default", "double-click the input's name"],
  ["Menu", "right button, or press for long"],
];

/** Every key and what the pointer does, from the table that drives the keys. */
export function HelpDialog(): ReactElement | null {
  const isOpen = useEditing((state) => state.help);
  return isOpen ? <Open /> : null;
}

function Open(): ReactElement {
  const editor = useEditor();
  return (
    <Dialog title="Keys and pointer" className="help" onClose={() => editor.store.set({ help: false })}>
      <div className="help-columns">
        {GROUPS.map(({ scope, title }) => (
          <section key={scope} aria-label={title}>
            <h3>{title}</h3>
            <dl>
              {SHORTCUTS.filter((item) => item.scope === scope).map((item) => (
                <div key={item.id}>
                  <dt>{item.title}</dt>
                  <dd>
                    {item.keys.map((key, index) => (
                      <kbd key={key}>{keyText(item.id, index)}</kbd>
                    ))}
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        <section aria-label="With the pointer">
          <h3>With the pointer</h3>
          <dl>
            {POINTER.map(([title, how]) => (
              <div key={title}>
                <dt>{title}</dt>
                <dd className="help-how">{how}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
      <p>
        <a href="docs" target="_blank" rel="noreferrer">
          The HTTP interface
        </a>
      </p>
    </Dialog>
  );
}
