import { type ReactElement, useEffect, useState } from "react";
import { plural } from "../model/format";
import { asObject } from "../model/json";
import { useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { GraphPicture } from "../widgets/GraphPicture";
import { agoText } from "./ago";
import type { Draft } from "./drafts";
import { filesOf } from "./Files";

/** The last drafts: what was edited and not saved, in any tab. */
export function RecoverDialog(): ReactElement {
  const files = filesOf(useCurrentSession());
  const [drafts, setDrafts] = useState<Draft[] | null>(null);
  useEffect(() => void files.drafts.list().then(setDrafts), [files]);
  const forget = async (draft: Draft): Promise<void> => {
    await files.drafts.remove(draft.id);
    setDrafts(await files.drafts.list());
  };
  return (
    <Dialog title="Recover" onClose={() => files.show(null)}>
      <p className="dialog-note">Changes that were not saved are kept in this browser, for the last ten graphs.</p>
      {drafts?.length === 0 && <p className="empty">There are no drafts.</p>}
      <ul className="kept-list">
        {drafts?.map((draft) => (
          <li key={draft.id} aria-label={draft.title}>
            <GraphPicture id={`draft ${draft.id} ${draft.time}`} read={() => Promise.resolve(draft.json)} />
            <span className="kept-text">
              <strong>{draft.title}</strong>
              <span>
                {agoText(Date.now() - draft.time)} · {plural(Object.keys(asObject(draft.json["nodes"])).length, "node")}
                {draft.name && ` · ${draft.name}`}
              </span>
            </span>
            <button
              type="button"
              className="button quiet"
              aria-label={`Delete the draft ${draft.title}`}
              onClick={() => void forget(draft)}
            >
              Delete
            </button>
            <button
              type="button"
              className="button primary"
              aria-label={`Open the draft ${draft.title}`}
              onClick={() => files.recover(draft)}
            >
              Open
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
