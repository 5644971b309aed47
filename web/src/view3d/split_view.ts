// A second model that is looked at together with the first: each in half of the view, or as the distance between them.

import type { Camera, Scene, WebGLRenderer } from "three";
import type { CameraPlace } from "../model/document";
import type { DecodedModel } from "./decode";

export type ComparedHow = "beside" | "over";

export class SplitView {
  private kept: DecodedModel | undefined;
  private how: ComparedHow = "beside";
  /** Where the camera stood before the view was split. */
  wholePlace: CameraPlace | undefined;

  constructor(private readonly scene: Scene) {}

  /** What the model is compared with. */
  get other(): DecodedModel | undefined {
    return this.kept;
  }

  /** Two pictures beside each other. */
  get isSplit(): boolean {
    return this.kept !== undefined && this.how === "beside";
  }

  /** Takes another model in place of the last one; null takes that away. */
  set(other: DecodedModel | null): void {
    if (this.kept) this.scene.remove(this.kept.scene);
    this.kept?.dispose();
    this.kept = other ?? undefined;
    if (this.kept) this.scene.add(this.kept.scene);
  }

  setHow(how: ComparedHow): void {
    this.how = how;
    // As a distance only the colors of the first model tell of it.
    if (this.kept) this.kept.scene.visible = this.isSplit;
  }

  /** Draws the model in the left half, the other one in the right half, from the same place. */
  render(
    renderer: WebGLRenderer,
    camera: Camera,
    model: DecodedModel | undefined,
    width: number,
    height: number,
  ): void {
    renderer.setScissorTest(true);
    for (const [side, shown] of [model, this.kept].entries()) {
      if (model) model.scene.visible = shown === model;
      if (this.kept) this.kept.scene.visible = shown === this.kept;
      const left = Math.round((side * width) / 2);
      renderer.setViewport(left, 0, width / 2, height);
      renderer.setScissor(left, 0, width / 2, height);
      renderer.render(this.scene, camera);
    }
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, width, height);
    if (model) model.scene.visible = true;
  }
}
