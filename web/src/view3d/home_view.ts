// Where the camera stands when a document opens, to which Home leads, and where it stands now as a document says it.

import { Vector3 } from "three";
import type { CameraPlace } from "../model/document";
import { inGraph } from "./drag";
import { PICTURE_ASPECT } from "./framing";
import type { CameraRig } from "./rig";

/** Looking around rounds: of the distance, what counts as not having moved. */
const NEAR = 1e-6;

export class HomeView {
  /** The document's own camera; null where the model is framed from the usual direction. */
  opening: CameraPlace | null = null;
  private readonly position = new Vector3();
  private readonly target = new Vector3();

  constructor(private readonly rig: CameraRig) {}

  /** The camera is at home now. */
  arrive(): void {
    this.position.copy(this.rig.perspective.position);
    this.target.copy(this.rig.target);
  }

  /** From now on Home leads to where the camera stands now. Answers that place. */
  keep(): CameraPlace {
    this.opening = this.asPicture();
    this.arrive();
    return this.opening;
  }

  /** Where the camera stands; null while that is home. */
  get camera(): CameraPlace | null {
    if (this.isHere()) return null;
    return { position: inGraph(this.rig.perspective.position), target: inGraph(this.rig.target) };
  }

  /** The same for a picture of the usual shape. */
  get pictureCamera(): CameraPlace | null {
    return this.isHere() ? null : this.asPicture();
  }

  private isHere(): boolean {
    const moved = this.rig.perspective.position.distanceTo(this.position) + this.rig.target.distanceTo(this.target);
    return moved < NEAR * this.position.distanceTo(this.target);
  }

  /** A narrower view steps back from a place that is for a picture of the usual shape. */
  private asPicture(): CameraPlace {
    const { position, aspect } = this.rig.perspective;
    const back = Math.max(1, PICTURE_ASPECT / aspect);
    const nearer = position.clone().sub(this.rig.target).divideScalar(back).add(this.rig.target);
    return { position: inGraph(nearer), target: inGraph(this.rig.target) };
  }
}
