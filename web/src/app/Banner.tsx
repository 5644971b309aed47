import type { ReactElement } from "react";
import { useCurrent } from "../widgets/context";
import { useLasting } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";

/** Says that the server is away; it goes by itself when the server is back. */
export function Banner(): ReactElement | null {
  const away = useCurrent((state) => state.away);
  const isEmpty = useCurrent((state) => state.shown === null);
  // A hiccup of a moment is not worth moving the page for.
  if (!useLasting(away, 300)) return null;
  return (
    <div className="banner" role="status">
      <Icon name="offline" />
      <span>
        <strong>The server does not answer.</strong>{" "}
        {isEmpty
          ? "The page goes on as soon as it does."
          : "The last picture stays; changes are sent as soon as it is back."}
      </span>
      <span className="banner-note">Trying again…</span>
    </div>
  );
}
