// Whether the model is still in sight: it may have been left behind by the camera, or have grown out of the picture.

import { type Camera, Vector3 } from "three";

/** How the model and the picture miss each other; empty while they do not. */
export type OutOfView = "" | "out" | "cut";

/** How many places of a model tell where it is. */
export const MOST_SEEN = 300;
/** A smaller share of the model than this in sight is nothing that can be looked at. */
const LOST = 0.02;
/** A model that has become another may lose this share at the border without a word. */
const BORDER = 0.05;

export class InView {
  private points: readonly Vector3[] = [];
  private seen = 1;
  private isNew = false;
  private isCut = false;

  /** Another model is shown, with some of its places. */
  setModel(positions: readonly Vector3[]): void {
    this.points = positions;
    this.isNew = true;
  }

  /** Looks at the model through the camera that it is drawn with. */
  look(camera: Camera): OutOfView {
    if (this.points.length === 0) return "";
    const place = new Vector3();
    const inside = this.points.filter((point) => {
      const { x, y, z } = place.copy(point).project(camera);
      return Math.abs(x) <= 1 && Math.abs(y) <= 1 && Math.abs(z) <= 1;
    });
    const share = inside.length / this.points.length;
    // Who comes close on purpose has cut it off by hand; what is said is only that it grew beyond the picture.
    if (this.isNew && share < this.seen) this.isCut ||= share < 1 - BORDER;
    else if (!this.isNew && share !== this.seen) this.isCut = false;
    if (share >= 1 - BORDER) this.isCut = false;
    this.seen = share;
    this.isNew = false;
    return share < LOST ? "out" : this.isCut ? "cut" : "";
  }

  /** The model was put into the picture. */
  framed(): void {
    this.seen = 1;
    this.isCut = false;
    this.isNew = false;
  }
}
