// Keys of the view, for the pane under the pointer or with the focus.

import { type RefObject, useEffect, useRef } from "react";
import { type ModelKey, shortcutOf } from "../session/shortcuts";
import type { ViewActions } from "./ViewTools";

/** Turning and zooming are heard by the canvas itself. */
type ViewKey = Exclude<ModelKey, "model-turn" | "model-zoom">;

/** Runs the actions on their keys, as long as the pointer is over the pane or the focus in it, and no field is edited. */
export function useViewKeys(pane: RefObject<HTMLElement | null>, actions: ViewActions, onProjection: () => void): void {
  const runs: Readonly<Record<ViewKey, () => void>> = {
    "model-fill": actions.frame,
    "model-home": actions.home,
    "model-front": () => actions.view("front"),
    "model-right": () => actions.view("right"),
    "model-above": () => actions.view("top"),
    "model-perspective": onProjection,
  };
  const newest = useRef(runs);
  newest.current = runs;
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const element = pane.current;
      const target = event.target as HTMLElement;
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      if (target.closest("input, select, textarea, [role=slider], [role=separator], [role=dialog], [role=menu]"))
        return;
      // Someone who works with the keys may have left the pointer anywhere, but the graph has keys of the same names.
      const hasFocus =
        element?.contains(target) && (target.role === "img" || !document.querySelector(".graph-pane:hover"));
      if (!element?.matches(":hover") && !hasFocus) return;
      const meant = shortcutOf(event, "model")?.id;
      if (meant === undefined || meant === "model-turn" || meant === "model-zoom") return;
      event.preventDefault();
      newest.current[meant]();
    };
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, [pane]);
}
