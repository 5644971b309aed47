import { type ReactElement, useState } from "react";
import { useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { useStore } from "../widgets/hooks";
import { filesOf } from "./Files";
import { STORED_NAME } from "./StoredGraphs";

/** Asks for the name under which the server keeps the open graph. */
export function KeepDialog(): ReactElement {
  const files = filesOf(useCurrentSession());
  const proposed = useStore(files.stored.store, (state) => state.name);
  const [name, setName] = useState(proposed);
  const isFit = STORED_NAME.test(name);
  const save = (): void => {
    if (isFit) void files.stored.write(name);
  };
  return (
    <Dialog
      title="Save to the server"
      onClose={() => files.show(null)}
      actions={
        <button type="button" className="button primary" disabled={!isFit} onClick={save}>
          Save
        </button>
      }
    >
      <p className="dialog-note">
        The server keeps every version. The graph gets addresses of its own: for this editor, for its model, and for a
        frame in other pages.
      </p>
      <label className="dialog-field">
        <span>Name</span>
        <input
          className="text-field"
          value={name}
          spellCheck={false}
          autoComplete="off"
          aria-invalid={!isFit}
          onChange={(event) => setName(event.currentTarget.value.trim())}
          onKeyDown={(event) => event.key === "Enter" && save()}
        />
      </label>
      {!isFit && (
        <p className="dialog-error" role="alert">
          A name is a letter, followed by up to 63 letters, digits, “_” or “-”.
        </p>
      )}
    </Dialog>
  );
}
