// Showing the model to someone: the view and the graph's controls fill the window, the editor is out of sight.

import { useEffect, useState } from "react";

/** Whether the model is shown alone, and the way to change it. Escape ends it. */
export function useShowMode(): [boolean, (showing: boolean) => void] {
  const [showing, setShowing] = useState(false);
  useEffect(() => {
    if (!showing) return undefined;
    const root = document.documentElement;
    root.dataset["show"] = "true";
    const onKey = (event: KeyboardEvent): void => {
      if (event.key === "Escape" && !event.defaultPrevented) setShowing(false);
    };
    document.addEventListener("keydown", onKey);
    return () => {
      delete root.dataset["show"];
      document.removeEventListener("keydown", onKey);
    };
  }, [showing]);
  return [showing, setShowing];
}
