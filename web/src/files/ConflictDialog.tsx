import type { ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { GraphPicture } from "../widgets/GraphPicture";
import { useStore } from "../widgets/hooks";
import { agoText } from "./ago";
import { filesOf } from "./Files";
import { StoredPicture } from "./OpenStoredDialog";

/** Two graphs for one name: the open one, and what the server keeps there by now. Nothing is replaced without a word. */
export function ConflictDialog(): ReactElement | null {
  const session = useCurrentSession();
  const files = filesOf(session);
  const theirs = useStore(files.stored.store, (state) => state.conflict);
  const mine = useCurrent((state) => state.document);
  const opened = useCurrent((state) => state.opened);
  const revision = useCurrent((state) => state.revision);
  if (!theirs || !mine) return null;
  return (
    <Dialog
      title={`The server keeps another “${theirs.id}”`}
      className="conflict"
      onClose={() => files.show(null)}
      actions={
        <>
          <button type="button" className="button" onClick={() => void files.stored.open(theirs.id)}>
            Open the server’s
          </button>
          <button type="button" className="button" onClick={() => void files.stored.write(theirs.id, theirs.tag)}>
            Replace it
          </button>
          <button type="button" className="button primary" onClick={() => files.stored.ask(`${theirs.id}-2`)}>
            Save mine as a copy…
          </button>
        </>
      }
    >
      <p className="dialog-note">
        It was saved since this one was opened, or its name was taken. Replaced versions stay on the server; opening the
        server’s keeps yours under File, Recover.
      </p>
      <ul className="kept-list">
        <li aria-label="Yours">
          <GraphPicture id={`open ${opened} ${revision}`} read={() => Promise.resolve(mine.json)} />
          <span className="kept-text">
            <strong>{mine.title}</strong>
            <span>Yours, not saved</span>
          </span>
        </li>
        <li aria-label="The server’s">
          <StoredPicture graph={theirs} />
          <span className="kept-text">
            <strong>{theirs.title || theirs.id}</strong>
            <span>
              On the server, version {theirs.version}, {agoText(Date.now() - theirs.created)}
            </span>
          </span>
        </li>
      </ul>
    </Dialog>
  );
}
