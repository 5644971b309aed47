import { useStore } from "@xyflow/react";
import { type ReactElement, useEffect, useRef } from "react";

/** Below this zoom the rows of nodes cannot be read, and their titles keep their size on the screen. */
const FAR = 0.5;

/** Tells the style sheet how far the graph is away: `data-far` and `--zoom` on the canvas. */
export function FarTitles(): ReactElement {
  const mark = useRef<HTMLSpanElement>(null);
  const zoom = useStore(({ transform }) => (transform[2] < FAR ? transform[2].toPrecision(3) : ""));
  useEffect(() => {
    const canvas = mark.current?.closest<HTMLElement>(".react-flow");
    if (!canvas) return;
    canvas.dataset["far"] = String(zoom !== "");
    canvas.style.setProperty("--zoom", zoom || "1");
  }, [zoom]);
  return <span ref={mark} hidden />;
}
