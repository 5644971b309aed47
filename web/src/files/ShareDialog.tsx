import type { ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { useStore } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";
import { addressesOf, isOnlyHere } from "./addresses";
import { storedPlace } from "./drafts";
import { type Files, filesOf } from "./Files";
import { LONGEST_LINK } from "./share";

/** The ways to hand a graph to others, one part each, the one that needs nothing from the server first. */
export function ShareDialog(): ReactElement {
  const files = filesOf(useCurrentSession());
  const link = useStore(files.store, (state) => state.link);
  return (
    <Dialog
      title="Share"
      className="share-dialog"
      onClose={() => files.show(null)}
      actions={<LinkAction files={files} link={link} />}
    >
      {isOnlyHere(location.hostname) && (
        <p className="dialog-warning">
          <Icon name="alert" />
          <span>
            The server’s address, {location.host}, works on this computer only. For others, open this page by an address
            that they can reach.
          </span>
        </p>
      )}
      <WholeLink link={link} />
      <OnServer files={files} />
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
        The link holds the whole graph as it is now, seen as you see it; nothing is stored on the server. Whoever opens
        it gets a copy.
      </p>
      <AddressField title="Link" text={link} />
    </>
  );
}

/** The addresses of what the server keeps of this graph, or the way to them. */
function OnServer({ files }: { files: Files }): ReactElement {
  const session = useCurrentSession();
  const place = storedPlace(useCurrent((state) => state.origin));
  const isChanged = useCurrent((state) => state.isChanged || state.isAdjusted);
  const version = place && `version ${place.version}`;
  return (
    <section className="share-stored" aria-label="On the server">
      <h3>On the server</h3>
      {place ? (
        <p className="dialog-note">
          {isChanged
            ? `What was changed since ${version} is not at these addresses yet.`
            : `These lead to what is kept as ${place.id}, now ${version}.`}
        </p>
      ) : (
        <p className="dialog-note">
          Saved to the server, the graph has addresses for this editor, for its model, and for a frame in other pages.
        </p>
      )}
      {addressesOf(session.store.get()).map(({ title, text }) => (
        <div className="address-row" key={title}>
          <span>{title}</span>
          <AddressField title={title} text={text} />
          <button
            type="button"
            className="button"
            aria-label={`Copy: ${title}`}
            onClick={() => void files.copy(text, title.toLowerCase())}
          >
            Copy
          </button>
        </div>
      ))}
      {(!place || isChanged) && (
        <button type="button" className="button" onClick={() => void files.stored.keep()}>
          {place ? "Save to the server" : "Save to the server…"}
        </button>
      )}
    </section>
  );
}

function AddressField({ title, text }: { title: string; text: string }): ReactElement {
  return (
    <input
      className="text-field dialog-link"
      readOnly
      aria-label={title}
      value={text}
      onFocus={(event) => {
        event.currentTarget.select();
        // Its beginning says more than its end.
        event.currentTarget.scrollTo(0, 0);
      }}
    />
  );
}
