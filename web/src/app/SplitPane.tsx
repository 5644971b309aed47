import {
  type CSSProperties,
  type KeyboardEvent,
  type PointerEvent,
  type ReactElement,
  type ReactNode,
  useRef,
} from "react";
import { useRemembered } from "../widgets/hooks";

interface SplitPaneProps {
  /** Where the border stands is remembered under this name. */
  name: string;
  label: string;
  direction: "row" | "column";
  /** Share of the first pane, 0 to 1. */
  initial: number;
  /** The second may be false: then the first takes the whole place. */
  children: [ReactNode, ReactNode];
}

const LEAST = 0.18;

/** Two panes with a border that is dragged, or moved with the arrow keys. */
export function SplitPane({ name, label, direction, initial, children }: SplitPaneProps): ReactElement {
  const [text, setText] = useRemembered(`dini.split.${name}`, String(initial));
  const element = useRef<HTMLDivElement>(null);
  const share = clampShare(Number(text) || initial);
  const move = (next: number): void => setText(clampShare(next).toFixed(3));

  const onPointerMove = (event: PointerEvent<HTMLDivElement>): void => {
    const box = element.current?.getBoundingClientRect();
    if (!box || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
    move(direction === "row" ? (event.clientX - box.left) / box.width : (event.clientY - box.top) / box.height);
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const step = { ArrowLeft: -0.02, ArrowUp: -0.02, ArrowRight: 0.02, ArrowDown: 0.02 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    move(share + step);
  };
  const isWhole = children[1] === false;
  return (
    <div
      ref={element}
      className={`split split-${direction}`}
      style={{ "--share": isWhole ? 1 : share } as CSSProperties}
    >
      <div className="split-first">{children[0]}</div>
      <div
        className="split-border"
        role="separator"
        hidden={isWhole}
        tabIndex={0}
        aria-label={label}
        aria-orientation={direction === "row" ? "vertical" : "horizontal"}
        aria-valuenow={Math.round(100 * share)}
        aria-valuemin={Math.round(100 * LEAST)}
        aria-valuemax={Math.round(100 * (1 - LEAST))}
        onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
        onPointerMove={onPointerMove}
        onDoubleClick={() => move(initial)}
        onKeyDown={onKeyDown}
      />
      <div className="split-second" hidden={isWhole}>
        {children[1]}
      </div>
    </div>
  );
}

function clampShare(share: number): number {
  return Math.min(1 - LEAST, Math.max(LEAST, share));
}
