// The models in the view: the shown one, the one in the colors of its motion that may stand in its place, and the one that
// it is compared with. Each is let go when another takes its place.

import type { Camera, Scene, WebGLRenderer } from "three";
import { OCCLUDING_LAYER } from "./ambient_occlusion";
import type { DecodedModel } from "./decode";
import type { ModelLook } from "./model_look";
import { type ComparedHow, SplitView } from "./split_view";
import type { ViewerHost, ViewSettings } from "./viewer_settings";

export class ShownModels {
  readonly split: SplitView;
  private shown: DecodedModel | undefined;
  private moving: DecodedModel | undefined;

  constructor(
    private readonly scene: Scene,
    private readonly look: ModelLook,
    private readonly host: Pick<ViewerHost, "scale" | "deviation">,
  ) {
    this.split = new SplitView(scene);
  }

  /** The shown model, also while the colors of its motion stand in its place. */
  get model(): DecodedModel | undefined {
    return this.shown;
  }

  /** Replaces the shown model. It is not dressed yet. */
  show(model: DecodedModel): void {
    this.clear();
    this.shown = model;
    for (const mesh of model.meshes) {
      if (![mesh.material].flat().some(({ transparent }) => transparent)) mesh.layers.enable(OCCLUDING_LAYER);
    }
    this.scene.add(model.scene);
  }

  /** Shows a model in place of the shown one; null brings that back. */
  showMotion(model: DecodedModel | null): void {
    this.clearMotion();
    this.moving = model ?? undefined;
    if (model) this.scene.add(model.scene);
    if (this.shown) this.shown.scene.visible = !model;
  }

  /** Takes a model to be compared with; null takes it away. */
  compare(other: DecodedModel | null): void {
    this.split.set(other);
  }

  compareHow(how: ComparedHow): void {
    this.split.setHow(how);
  }

  /** Dresses the models for the mode, and says what the colors mean. */
  dress(settings: ViewSettings): void {
    if (!this.shown) return;
    const { other, isSplit } = this.split;
    this.host.scale(this.look.apply(this.shown, settings));
    this.host.deviation(other && !isSplit ? this.look.applyDeviation(this.shown, other) : undefined);
  }

  /** The shown model alone, in its own colors: what tells of numbers by colors is not darkened. */
  isPlain({ mode }: ViewSettings): boolean {
    const isOwn = mode === "shaded" || mode === "shaded-wire";
    return isOwn && this.shown !== undefined && this.moving === undefined && this.split.other === undefined;
  }

  render(renderer: WebGLRenderer, camera: Camera, width: number, height: number): void {
    if (this.split.isSplit) this.split.render(renderer, camera, this.moving ?? this.shown, width, height);
    else renderer.render(this.scene, camera);
  }

  /** Lets the shown model go, not the one that it was compared with. */
  clear(): void {
    this.clearMotion();
    this.look.clear();
    if (this.shown) this.scene.remove(this.shown.scene);
    this.shown?.dispose();
    this.shown = undefined;
  }

  private clearMotion(): void {
    if (this.moving) this.scene.remove(this.moving.scene);
    this.moving?.dispose();
    this.moving = undefined;
  }
}
