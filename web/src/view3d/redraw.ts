// When the picture is drawn: with the next frame of the page after something changed, quickly while things move, and once
// more at rest, finely.

import type { WebGLRenderer } from "three";
import { fineRatio, Rest, setRatio } from "./rest";

export class Redraw {
  private readonly rest: Rest;
  /** Pixels of a drawing to one of the page while things move. */
  private readonly ratio: number;
  private requested = 0;
  private isNextFine = false;

  /** `isCoarse`: what moves is drawn more coarsely than what rests. `render` draws, finely or quickly. */
  constructor(
    private readonly renderer: WebGLRenderer,
    isCoarse: boolean,
    private readonly render: (fine: boolean) => void,
  ) {
    this.ratio = renderer.getPixelRatio();
    this.rest = new Rest(isCoarse, {
      setTimeout: (run, milliseconds) => window.setTimeout(run, milliseconds),
      clearTimeout: (timer) => window.clearTimeout(timer),
      drawFine: () => this.request(true),
      mark: (isStill) => (renderer.domElement.dataset["still"] = String(isStill)),
    });
  }

  /** Something changed. */
  draw(): void {
    this.rest.changed();
    this.request(false);
  }

  /** Before a drawing of the given size: sets how many pixels it has. */
  begin(fine: boolean, width: number, height: number): void {
    setRatio(this.renderer, fine ? Math.max(this.ratio, fineRatio(width, height)) : this.ratio);
  }

  /** After it. */
  drawn(fine: boolean): void {
    this.rest.drawn(fine);
  }

  setBusy(busy: boolean): void {
    this.rest.setBusy(busy);
  }

  stop(): void {
    cancelAnimationFrame(this.requested);
    this.rest.stop();
  }

  /** What moves is drawn quickly, also if it was to be drawn finely before. */
  private request(fine: boolean): void {
    this.isNextFine = fine;
    if (this.requested) return;
    this.requested = requestAnimationFrame(() => {
      this.requested = 0;
      this.render(this.isNextFine);
    });
  }
}
