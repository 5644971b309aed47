// Without a GPU edges are drawn as they come, since smooth ones take several times as long. Once nothing has changed for a
// moment there is time: the same picture is drawn once more, finer, and the browser scales it down.

import type { WebGLRenderer } from "three";

const REST_MILLISECONDS = 150;
const FINE_RATIO = 2;
/** A drawing with more pixels takes too long even for a rest. */
const MOST_PIXELS = 4_000_000;

/** Pixels of the drawing to one of the page, for a picture at rest of the given size. */
export function fineRatio(width: number, height: number): number {
  return Math.max(1, Math.min(FINE_RATIO, Math.sqrt(MOST_PIXELS / Math.max(1, width * height))));
}

/** Clock and canvas, as far as resting needs them. */
export interface RestHost {
  setTimeout(run: () => void, milliseconds: number): number;
  clearTimeout(timer: number): void;
  /** Draws once more, finer. */
  drawFine(): void;
  /** Whether the picture is the last one until something changes. */
  mark(isStill: boolean): void;
}

/** Decides when the picture is drawn finer. Nothing runs while nothing changes. */
export class Rest {
  private timer = 0;
  private isBusy = false;
  private isFine = false;

  constructor(
    private readonly isNeeded: boolean,
    private readonly host: RestHost,
  ) {}

  /** Something changed; a drawing follows. */
  changed(): void {
    this.stop();
    this.host.mark(false);
  }

  /** A drawing was made. */
  drawn(fine: boolean): void {
    this.isFine = fine || !this.isNeeded;
    this.host.mark(this.isFine);
    this.start();
  }

  /** While an evaluation is under way the next picture is near, and the processor is needed for it. */
  setBusy(busy: boolean): void {
    this.isBusy = busy;
    this.start();
  }

  stop(): void {
    this.host.clearTimeout(this.timer);
  }

  private start(): void {
    this.stop();
    if (this.isFine || this.isBusy) return;
    this.timer = this.host.setTimeout(() => this.host.drawFine(), REST_MILLISECONDS);
  }
}

/** Sets how many pixels of the drawing come to one of the page; to be followed by a drawing, since it clears. */
export function setRatio(renderer: WebGLRenderer, ratio: number): void {
  if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
}
