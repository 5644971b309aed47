import type { ReactElement } from "react";
import { useCurrentSession } from "../widgets/context";
import { useStore } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";
import { filesOf } from "./Files";

/** Says that changes would be lost with the page, as long as that is so. */
export function UnkeptBanner(): ReactElement | null {
  const files = filesOf(useCurrentSession());
  const { drafts, reason } = useStore(files.drafts.held, (state) => state);
  const isThis = drafts.some((draft) => files.autosave.isOpen(draft));
  const others = drafts.filter((draft) => !files.autosave.isOpen(draft));
  if (drafts.length === 0) return null;
  return (
    <div className="banner" role="alert">
      <Icon name="alert" />
      <span>
        <strong>
          {isThis ? "Your changes are not kept" : `“${others[0]?.title}” was not saved`}: the browser stores no draft,
          because {reason}.
        </strong>{" "}
        {isThis ? "They are" : "It is"} lost when this page is left.
      </span>
      {isThis && (
        <button type="button" className="button quiet" onClick={() => void files.save()}>
          Save
        </button>
      )}
      {others.length > 0 && (
        <button type="button" className="button quiet" onClick={() => files.show("recover")}>
          Recover…
        </button>
      )}
    </div>
  );
}
