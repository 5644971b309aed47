import type { ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { useLasting } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";

/** Says that the server is away or crowded; it goes by itself when the server is back. */
export function Banner(): ReactElement | null {
  const away = useCurrent((state) => state.away);
  const isCrowded = useCurrent((state) => state.isCrowded);
  const session = useCurrentSession();
  const isEmpty = useCurrent((state) => state.shown === null);
  // A hiccup of a moment is not worth moving the page for.
  if (!useLasting(away, 300)) return null;
  return (
    <div className="banner" role="status">
      <Icon name="offline" />
      <span>
        <strong>{isCrowded ? "The server has too much to do." : "The server does not answer."}</strong>{" "}
        {isEmpty
          ? "The page goes on as soon as it does."
          : "The last picture stays; changes are sent as soon as it is back."}
      </span>
      <span className="banner-note">Trying again by itself…</span>
      <button type="button" className="button quiet" onClick={() => session.retry()}>
        Try again
      </button>
    </div>
  );
}
