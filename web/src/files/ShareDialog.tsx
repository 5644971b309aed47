import { useRef, type ReactElement } from "react";
import { useCurrentSession } from "../app/context";
import { useStore } from "../app/hooks";
import { Dialog } from "./Dialog";
import { filesOf } from "./Files";
import { LONGEST_LINK } from "./share";

/** A link that holds the whole graph, or the advice to send a file. */
export function ShareDialog(): ReactElement {
  const files = filesOf(useCurrentSession());
  const link = useStore(files.store, (state) => state.link);
  const field = useRef<HTMLInputElement>(null);
  const close = (): void => files.show(null);
  if (!link) {
    return (
      <Dialog
        title="Share"
        onClose={close}
        actions={
          <button type="button" className="button primary" onClick={() => void files.save(true)}>
            Save as a file
          </button>
        }
      >
        <p className="dialog-note">
          This graph is too large for a link: above {LONGEST_LINK / 1000} kB, mail programs and chats cut links off. Send it
          as a file.
        </p>
      </Dialog>
    );
  }
  return (
    <Dialog
      title="Share"
      onClose={close}
      actions={
        <button type="button" className="button primary" onClick={() => void files.copy(link, "the link")}>
          Copy link
        </button>
      }
    >
      <p className="dialog-note">
        The link holds the whole graph as it is now; nothing is stored on the server. Whoever opens it gets a copy.
      </p>
      <input
        ref={field}
        className="text-field dialog-link"
        readOnly
        aria-label="Link"
        value={link}
        onFocus={() => field.current?.select()}
      />
    </Dialog>
  );
}
