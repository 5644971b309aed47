import { type ReactElement, useState } from "react";
import { setTitle } from "../model/edit";
import { useCurrent, useCurrentSession } from "../widgets/context";

const STATES = {
  ...{ example: "example", file: "saved", stored: "on the server" },
  ...{ new: "not saved", shared: "shared", draft: "draft" },
};

/** The document's title, to read and to type, and whether it was changed since it was opened or saved. */
export function TitleField(): ReactElement | null {
  const session = useCurrentSession();
  const title = useCurrent((state) => state.document?.title);
  const kind = useCurrent((state) => state.origin.kind);
  const isChanged = useCurrent((state) => state.isChanged || state.isAdjusted);
  const [typed, setTyped] = useState<string | null>(null);
  if (title === undefined) return null;
  const commit = (): void => {
    const next = typed?.trim();
    if (next && next !== title) session.edit("Rename the graph", setTitle(next));
    setTyped(null);
  };
  return (
    <>
      {/* The heading is for those who hear the page; the field beside it shows the same. */}
      <h1 className="hidden-text">{title}</h1>
      <input
        className="title-field"
        aria-label="Title of the graph"
        title={title}
        spellCheck={false}
        autoComplete="off"
        style={{ width: `${Math.min(28, Math.max(8, (typed ?? title).length + 1))}ch` }}
        value={typed ?? title}
        data-typing={typed !== null}
        onChange={(event) => setTyped(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === "Enter") event.currentTarget.blur();
          if (event.key === "Escape") {
            setTyped(null);
            event.currentTarget.blur();
          }
        }}
      />
      <span className="document-state" data-changed={isChanged}>
        {isChanged ? "edited" : STATES[kind]}
      </span>
    </>
  );
}
