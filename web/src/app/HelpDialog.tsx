import { useEffect, useRef, type ReactElement } from "react";
import { useEditing, useEditor } from "./context";
import { Icon } from "./icons";
import { SHORTCUTS, keyText, type Scope } from "./shortcuts";

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
  ["Change a number", "drag it: Shift finer, Ctrl coarser; click to type, also 2*pi/3"],
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
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const dialog = element.current;
    if (dialog && !dialog.open) dialog.showModal();
  }, []);
  const close = (): void => editor.store.set({ help: false });
  return (
    <dialog
      ref={element}
      className="dialog help"
      aria-labelledby="help-title"
      onClose={close}
      onClick={(event) => {
        if (event.target === element.current) element.current.close();
      }}
    >
      <div className="help-content">
        <header>
          <h2 id="help-title">Keys and pointer</h2>
          <button
            type="button"
            className="button icon-button"
            aria-label="Close"
            onClick={() => element.current?.close()}
          >
            <Icon name="close" />
          </button>
        </header>
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
      </div>
    </dialog>
  );
}
