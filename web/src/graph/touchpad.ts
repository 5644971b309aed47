// Two fingers on a touchpad move the canvas, and a pinch zooms it; the wheel of a mouse zooms as it always did.

import { type RefObject, useEffect } from "react";
import type { Flow } from "./flow";

/** A wheel turns by whole notches; fingers move by little. */
const LEAST_NOTCH = 40;
/** What follows within this time belongs to the same movement. */
const PAUSE_MILLISECONDS = 250;

/** Tells fingers from wheels: small or slanting steps are those of fingers, and so are large ones that follow at once. */
export class TouchpadSense {
  private last = Number.NEGATIVE_INFINITY;
  private isTouchpad = false;

  /** True if the event moves the canvas rather than zooms it. A pinch comes as a wheel with Ctrl held. */
  moves({ deltaX, deltaY, deltaMode, ctrlKey, metaKey, timeStamp }: WheelFacts): boolean {
    if (ctrlKey || metaKey) return false;
    const isNew = timeStamp - this.last > PAUSE_MILLISECONDS;
    this.last = timeStamp;
    const isFine = deltaMode === 0 && (Math.abs(deltaY) < LEAST_NOTCH || !Number.isInteger(deltaY));
    if (isFine || deltaX !== 0) this.isTouchpad = true;
    else if (isNew) this.isTouchpad = false;
    return this.isTouchpad;
  }
}

export type WheelFacts = Pick<WheelEvent, "deltaX" | "deltaY" | "deltaMode" | "ctrlKey" | "metaKey" | "timeStamp">;

/** Moves the canvas with two fingers. `onMove` is told of each movement. */
export function useTouchpad(
  flow: Flow | null,
  element: RefObject<HTMLElement | null>,
  onMove: (event: Event) => void,
): void {
  useEffect(() => {
    const pane = element.current;
    if (!flow || !pane) return undefined;
    const sense = new TouchpadSense();
    const onWheel = (event: WheelEvent): void => {
      const isCanvas = event.target instanceof Element && event.target.closest(".react-flow") !== null;
      if (!isCanvas || !sense.moves(event)) return;
      event.preventDefault();
      event.stopPropagation();
      const { x, y, zoom } = flow.getViewport();
      onMove(event);
      void flow.setViewport({ x: x - event.deltaX, y: y - event.deltaY, zoom });
    };
    pane.addEventListener("wheel", onWheel, { capture: true, passive: false });
    return () => pane.removeEventListener("wheel", onWheel, { capture: true });
  }, [flow, element, onMove]);
}
