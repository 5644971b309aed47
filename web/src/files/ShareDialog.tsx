import { type ReactElement, useRef } from "react";
import { useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { useStore } from "../widgets/hooks";
import { type Files, filesOf } from "./Files";
import { LONGEST_LINK } from "./share";

/** The ways to hand a graph to others, one part each, the one that needs nothing from the server first. */
export function ShareDialog(): ReactElement {
  const files = filesOf(useCurrentSession());
  const link = useStore(files.store, (state) => state.link);
  return (
    <Dialog title="Share" onClose={() => files.show(null)} actions={<LinkAction files={files} link={link} />}>
      <WholeLink link={link} />
    </Dialog>
  );
}

function LinkAction({ files, link }: { files: Files; link: string }): ReactElement {
  return (
    <button
      type="button"
      className="button primary"
      onClick={() => void (link ? files.copy(link, "the link") : files.save(true))}
    >
      {link ? "Copy link" : "Save as a file"}
    </button>
  );
}

/** A link that holds the whole graph, or the advice to send a file. */
function WholeLink({ link }: { link: string }): ReactElement {
  const field = useRef<HTMLInputElement>(null);
  if (!link) {
    return (
      <p className="dialog-note">
        This graph is too large for a link: above {LONGEST_LINK / 1000} kB, mail programs and chats cut links off. Send
        it as a file.
      </p>
    );
  }
  return (
    <>
      <p className="dialog-note">
        The link holds the whole graph as it is now; nothing is stored on the server. Whoever opens it gets a copy.
      </p>
      <input
        ref={field}
        className="text-field dialog-link"
        readOnly
        aria-label="Link"
        value={link}
        onFocus={() => {
          field.current?.select();
          // Its beginning says more than its end.
          field.current?.scrollTo(0, 0);
        }}
      />
    </>
  );
}
