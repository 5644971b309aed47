import { type KeyboardEvent, type PointerEvent, type ReactElement, useRef } from "react";
import { barStyle, ZeroTick } from "./bar";
import { scaleOf } from "./NumberInput";

interface SliderBarProps {
  label: string;
  value: number;
  minimum: number;
  maximum: number;
  step: number;
  text: string;
  described?: string;
  /** As that of a number field: the step is `scale` times the usual one. */
  onMove(value: number, scale: number): void;
}

const PAGE = 10;

/** A bar that is dragged (Shift finer, Ctrl coarser), or moved with the keys. The wheel never changes it. */
export function SliderBar({
  label,
  value,
  minimum,
  maximum,
  step,
  text,
  described,
  onMove,
}: SliderBarProps): ReactElement {
  // The dragged value before rounding, so that slow fine drags add up.
  const dragged = useRef(0);
  const lastX = useRef(0);
  const range = maximum - minimum;

  const onPointerDown = (event: PointerEvent<HTMLDivElement>): void => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const box = event.currentTarget.getBoundingClientRect();
    // With Shift or Ctrl the value is moved from where it is, and not to where the pointer is.
    const isRelative = scaleOf(event) !== 1;
    dragged.current = isRelative ? value : minimum + (range * (event.clientX - box.left)) / box.width;
    lastX.current = event.clientX;
    if (!isRelative) onMove(dragged.current, 1);
  };
  const onPointerMove = (event: PointerEvent<HTMLDivElement>): void => {
    if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
    const width = event.currentTarget.getBoundingClientRect().width;
    const share = (event.clientX - lastX.current) / width;
    lastX.current = event.clientX;
    if (share === 0) return;
    dragged.current += share * range * Math.min(1, scaleOf(event));
    onMove(dragged.current, scaleOf(event));
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    const steps: Record<string, number> = {
      ArrowRight: step,
      ArrowUp: step,
      ArrowLeft: -step,
      ArrowDown: -step,
      PageUp: PAGE * step,
      PageDown: -PAGE * step,
      Home: minimum - value,
      End: maximum - value,
    };
    const change = steps[event.key];
    if (change === undefined) return;
    event.preventDefault();
    const scale = event.key.startsWith("Arrow") ? scaleOf(event) : 1;
    onMove(value + scale * change, scale);
  };
  const share = (at: number): number => Math.min(1, Math.max(0, (at - minimum) / range));
  return (
    <div
      className="slider-bar"
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuemin={minimum}
      aria-valuemax={maximum}
      aria-valuenow={value}
      aria-valuetext={text}
      aria-describedby={described}
      style={barStyle(share(value), share(0))}
      onPointerDown={onPointerDown}
      onPointerMove={onPointerMove}
      onKeyDown={onKeyDown}
    >
      <span className="slider-fill" />
      <ZeroTick share={share(0)} />
    </div>
  );
}
