// The places in the picture that can be taken hold of. Each is an element over the canvas, so it has a name, a size for
// fingers, keys, and a place in the order of focus; what is seen of it is drawn in the scene.

import type { Ray, Vector3 } from "three";

/** What a handle does. Places and rays are in the scene. */
export interface Handle {
  /** What it moves, for screen readers and as a tip. */
  name: string;
  shape: "ball" | "arrow" | "square" | "tip" | "dot";
  color: string;
  /** Where it is; undefined where it cannot be used, as an arrow that points at the eye. */
  place(): Vector3 | undefined;
  /** A drag begins with the ray through the pointer. */
  begin(ray: Ray): void;
  move(ray: Ray, snap: boolean): void;
  /** The drag is over; a cancelled one leaves nothing changed. */
  end(cancelled: boolean): void;
  /** Steps from the arrow keys: along the first and the second axis of what is moved. */
  nudge(x: number, y: number): void;
}

/** What the layer needs of the view around it. */
export interface HandleView {
  canvas: HTMLElement;
  /** Ray through a place of the picture, in pixels from its corner. */
  ray(x: number, y: number): Ray;
  /** Pixels from the corner of the picture; undefined behind the eye. */
  project(place: Vector3): { x: number; y: number } | undefined;
}

const NUDGES: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowDown: [0, -1],
  ArrowUp: [0, 1],
};

export class HandleLayer {
  private readonly element = document.createElement("div");
  private readonly shown = new Map<Handle, HTMLButtonElement>();
  private stop: ((cancelled: boolean) => void) | undefined;

  constructor(
    container: HTMLElement,
    private readonly view: HandleView,
  ) {
    this.element.className = "handles";
    container.append(this.element);
  }

  get isDragging(): boolean {
    return this.stop !== undefined;
  }

  /** Replaces the handles. A drag of one that is gone ends where it is. */
  set(handles: readonly Handle[]): void {
    for (const [handle, button] of this.shown) {
      if (handles.includes(handle)) continue;
      button.remove();
      this.shown.delete(handle);
    }
    for (const handle of handles) {
      if (!this.shown.has(handle)) this.shown.set(handle, this.make(handle));
    }
    this.update();
  }

  /** Puts the handles where they are in the picture now. */
  update(): void {
    const { clientWidth, clientHeight } = this.view.canvas;
    for (const [handle, button] of this.shown) {
      const place = handle.place();
      const at = place && this.view.project(place);
      const isInside = at && at.x > -12 && at.y > -12 && at.x < clientWidth + 12 && at.y < clientHeight + 12;
      button.hidden = !isInside;
      if (at) button.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    }
  }

  dispose(): void {
    this.stop?.(false);
    this.element.remove();
    this.shown.clear();
  }

  private make(handle: Handle): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.className = `handle handle-${handle.shape}`;
    button.title = handle.name;
    button.setAttribute("aria-label", handle.name);
    button.style.setProperty("--handle", handle.color);
    button.addEventListener("pointerdown", (event) => this.drag(handle, button, event));
    button.addEventListener("keydown", (event) => {
      const nudge = NUDGES[event.key];
      if (!nudge || event.altKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      const size = event.shiftKey ? 0.1 : 1;
      handle.nudge(nudge[0] * size, nudge[1] * size);
    });
    this.element.append(button);
    return button;
  }

  private drag(handle: Handle, button: HTMLButtonElement, event: PointerEvent): void {
    if (event.button !== 0 || this.stop) return;
    event.preventDefault();
    button.focus({ preventScroll: true });
    button.setPointerCapture(event.pointerId);
    button.dataset["held"] = "true";
    const rayAt = ({ clientX, clientY }: PointerEvent): Ray => {
      const box = this.view.canvas.getBoundingClientRect();
      return this.view.ray(clientX - box.left, clientY - box.top);
    };
    handle.begin(rayAt(event));
    const onMove = (next: PointerEvent): void => handle.move(rayAt(next), next.ctrlKey || next.metaKey);
    const onEnd = (): void => this.stop?.(false);
    const onKey = (next: KeyboardEvent): void => {
      if (next.key !== "Escape") return;
      next.preventDefault();
      next.stopPropagation();
      this.stop?.(true);
    };
    this.stop = (cancelled) => {
      this.stop = undefined;
      button.removeEventListener("pointermove", onMove);
      button.removeEventListener("pointerup", onEnd);
      button.removeEventListener("pointercancel", onEnd);
      document.removeEventListener("keydown", onKey, true);
      delete button.dataset["held"];
      handle.end(cancelled);
    };
    button.addEventListener("pointermove", onMove);
    button.addEventListener("pointerup", onEnd);
    button.addEventListener("pointercancel", onEnd);
    document.addEventListener("keydown", onKey, true);
  }
}
