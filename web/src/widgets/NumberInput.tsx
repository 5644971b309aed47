import { type KeyboardEvent, type PointerEvent, type ReactElement, useId, useRef, useState } from "react";
import { numberText } from "../model/format";
import { readQuantity } from "../model/units";
import { barStyle, ZeroTick } from "./bar";
import { describedBy, FieldError } from "./FieldError";

interface NumberInputProps {
  id: string;
  label: string;
  value: number;
  decimals: number;
  unit?: string;
  step: number;
  invalid: boolean;
  described?: string;
  /** The range that a bar behind the number shows, and that a drag over the whole width runs through. */
  range?: { minimum: number; maximum: number };
  /** One of the stops inside a node: Tab reaches it only from there. */
  isStop?: boolean;
  /** A typed value; it is passed on as it is, so that the server can say what is wrong with it. */
  onType(value: number): void;
  /** A dragged or stepped value, in steps of `scale` times the step: 0.1 with Shift, 10 with Ctrl. */
  onMove(value: number, scale: number): void;
  /** Whether a text that is no number stands in the field. */
  onUnreadable?(isUnreadable: boolean): void;
}

interface Drag {
  pointer: number;
  x: number;
  /** The value before rounding, so that slow fine drags add up. */
  value: number;
  moved: boolean;
}

const DRAG_THRESHOLD = 3;
const PIXELS_PER_STEP = 4;
/** Width that a drag through the whole range takes at least. */
const LEAST_WIDTH = 60;

/** A number that is typed (formulas too), dragged sideways, or stepped with the arrow keys. */
export function NumberInput(props: NumberInputProps): ReactElement {
  const { id, label, value, decimals, unit = "", step, described, range, isStop, onType, onMove, onUnreadable } = props;
  const errorId = useId();
  const [text, setText] = useState<string | null>(null);
  const [textFor, setTextFor] = useState(value);
  const [error, setError] = useState("");
  const drag = useRef<Drag | null>(null);
  const invalid = props.invalid || error !== "";
  // A value that comes from elsewhere (the bar, a reset) replaces what is being typed.
  if (textFor !== value) {
    setTextFor(value);
    setText(null);
    setError("");
  }

  const forget = (): void => {
    setText(null);
    setError("");
    onUnreadable?.(false);
  };
  const commit = (): void => {
    if (text === null) return;
    const typed = readQuantity(text, unit);
    if ("error" in typed) {
      setError(typed.error);
      onUnreadable?.(true);
      return;
    }
    forget();
    if (typed.value !== value || invalid) onType(typed.value);
  };
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>): void => {
    if (event.key === "Enter") {
      commit();
      event.currentTarget.select();
    } else if (event.key === "Escape") {
      forget();
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      forget();
      const sign = event.key === "ArrowUp" ? 1 : -1;
      onMove(value + sign * step * scaleOf(event), scaleOf(event));
    }
  };
  const onPointerDown = (event: PointerEvent<HTMLInputElement>): void => {
    if (event.button !== 0 || document.activeElement === event.currentTarget) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    drag.current = { pointer: event.pointerId, x: event.clientX, value, moved: false };
  };
  const onPointerMove = (event: PointerEvent<HTMLInputElement>): void => {
    const state = drag.current;
    if (state?.pointer !== event.pointerId) return;
    if (!state.moved) {
      if (Math.abs(event.clientX - state.x) < DRAG_THRESHOLD) return;
      // The way to here only told a drag from a press.
      Object.assign(state, { moved: true, x: event.clientX });
      return;
    }
    const width = Math.max(LEAST_WIDTH, event.currentTarget.getBoundingClientRect().width);
    // Through a range the number goes along with the pointer; Ctrl only takes larger steps there.
    const perPixel = range
      ? ((range.maximum - range.minimum) / width) * Math.min(1, scaleOf(event))
      : (step / PIXELS_PER_STEP) * scaleOf(event);
    state.value += (event.clientX - state.x) * perPixel;
    state.x = event.clientX;
    setError("");
    onMove(state.value, scaleOf(event));
  };
  const onPointerUp = (event: PointerEvent<HTMLInputElement>): void => {
    const input = event.currentTarget;
    const isPress = drag.current?.moved === false;
    drag.current = null;
    if (!isPress) return;
    input.focus();
    input.select();
  };
  return (
    <span className="number-input nodrag nokey" data-invalid={invalid}>
      {range && (
        <>
          <span className="number-fill" style={barStyle(shareOf(value, range), shareOf(0, range))} />
          <ZeroTick share={shareOf(0, range)} />
        </>
      )}
      <input
        id={id}
        type="text"
        inputMode="decimal"
        autoComplete="off"
        spellCheck={false}
        aria-label={label}
        tabIndex={isStop ? -1 : undefined}
        data-stop={isStop}
        data-typing={text !== null}
        aria-invalid={invalid}
        aria-describedby={describedBy(described, error !== "" && errorId)}
        value={text ?? numberText(value, decimals)}
        onChange={(event) => setText(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={onKeyDown}
        onMouseDown={(event) => {
          // Pressing may become a drag; the field takes the focus on release.
          if (document.activeElement !== event.currentTarget) event.preventDefault();
        }}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerUp}
        onPointerCancel={() => (drag.current = null)}
      />
      {unit && (
        <span className="unit" aria-hidden="true">
          {unit.trim()}
        </span>
      )}
      <FieldError id={errorId} text={error} />
    </span>
  );
}

/** Shift makes steps finer, Ctrl coarser. */
export function scaleOf(event: { shiftKey: boolean; ctrlKey: boolean; metaKey: boolean }): number {
  if (event.shiftKey) return 0.1;
  return event.ctrlKey || event.metaKey ? 10 : 1;
}

function shareOf(value: number, { minimum, maximum }: { minimum: number; maximum: number }): number {
  return Math.min(1, Math.max(0, (value - minimum) / (maximum - minimum)));
}
