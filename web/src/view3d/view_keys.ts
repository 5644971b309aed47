// Keys of the view, for the pane under the pointer or with the focus.

import { useEffect, useRef, type RefObject } from "react";
import { digitOf, keyName } from "../model/keys";
import type { ViewActions } from "./ViewTools";

/** The one table of the view's keys: the shortcut list reads it too. */
export const VIEW_KEYS = [
  { key: "F", text: "Fill the view with the selection, or the model" },
  { key: "Home", text: "Opening view" },
  { key: "1", text: "From the front" },
  { key: "3", text: "From the right" },
  { key: "7", text: "From above" },
  { key: "5", text: "With or without perspective" },
] as const;

/** Runs the actions on their keys, as long as the pointer is over the pane or the focus in it, and no field is edited. */
export function useViewKeys(pane: RefObject<HTMLElement | null>, actions: ViewActions, onProjection: () => void): void {
  const runs: Record<(typeof VIEW_KEYS)[number]["key"], () => void> = {
    F: actions.frame,
    Home: actions.home,
    1: () => actions.view("front"),
    3: () => actions.view("right"),
    7: () => actions.view("top"),
    5: onProjection,
  };
  const newest = useRef(runs);
  newest.current = runs;
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const element = pane.current;
      const target = event.target as HTMLElement;
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      if (target.closest("input, select, textarea, [role=slider], [role=separator], [role=dialog], [role=menu]")) return;
      // Someone who works with the keys may have left the pointer anywhere, but the graph has keys of the same names.
      const hasFocus = element?.contains(target) && (target.role === "img" || !document.querySelector(".graph-pane:hover"));
      if (!element?.matches(":hover") && !hasFocus) return;
      const named = (name: string | undefined) => VIEW_KEYS.find(({ key }) => key === name);
      const run = named(keyName(event)) ?? named(digitOf(event));
      if (!run) return;
      event.preventDefault();
      newest.current[run.key]();
    };
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, [pane]);
}
