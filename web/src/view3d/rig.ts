// The camera and how it is moved. Perspective is what is moved; the orthographic camera follows it, so that turning,
// moving and zooming are the same in both.

import { type Camera, OrthographicCamera, PerspectiveCamera, type Ray, Raycaster, Vector2, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { type Framing, placeCamera } from "./framing";
import { turnByKey } from "./keys";

export type StandardView = "front" | "right" | "top" | "iso";

const FIELD_OF_VIEW = 32;
const TANGENT = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);

/** Where the standard views look, in the scene (Y up). From above it is not quite straight down: up has to be up. */
const DIRECTIONS: Readonly<Record<StandardView, readonly [number, number, number]>> = {
  front: [0, 0, -1],
  right: [-1, 0, 0],
  top: [0, -1, -1e-4],
  iso: [-1, -1, -1],
};

export class CameraRig {
  readonly perspective = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000);
  private readonly orthographic = new OrthographicCamera();
  private readonly controls: OrbitControls;
  private readonly raycaster = new Raycaster();
  private isOrthographic = false;

  constructor(canvas: HTMLCanvasElement, damped: boolean, onChange: () => void) {
    this.controls = new OrbitControls(this.perspective, canvas);
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = damped;
    this.controls.dampingFactor = 0.12;
    this.controls.addEventListener("change", onChange);
  }

  /** The camera to draw with. */
  get camera(): Camera {
    return this.isOrthographic ? this.orthographic : this.perspective;
  }

  get target(): Vector3 {
    return this.controls.target;
  }

  /** Where the camera looks. */
  get direction(): Vector3 {
    return this.perspective.getWorldDirection(new Vector3());
  }

  set projection(kind: "perspective" | "orthographic") {
    this.isOrthographic = kind === "orthographic";
  }

  /** Brings both cameras up to date; to be called before drawing. */
  update(): void {
    this.controls.update();
    if (!this.isOrthographic) return;
    const { perspective, orthographic } = this;
    const height = perspective.position.distanceTo(this.controls.target) * TANGENT;
    orthographic.top = height;
    orthographic.bottom = -height;
    orthographic.right = height * perspective.aspect;
    orthographic.left = -orthographic.right;
    // Also what is behind the camera's place is seen: without perspective there is no such place.
    orthographic.near = -perspective.far;
    orthographic.far = perspective.far;
    orthographic.position.copy(perspective.position);
    orthographic.quaternion.copy(perspective.quaternion);
    orthographic.updateProjectionMatrix();
    orthographic.updateMatrixWorld();
  }

  resize(aspect: number): void {
    this.perspective.aspect = aspect;
    this.perspective.updateProjectionMatrix();
  }

  look(direction: Vector3, framing: Framing): void {
    placeCamera(this.perspective, direction, framing);
    this.controls.target.copy(framing.target);
    this.controls.minDistance = framing.radius * 0.02;
    this.controls.maxDistance = framing.radius * 60;
    this.controls.update();
  }

  onKey(event: KeyboardEvent): void {
    const offset = this.perspective.position.clone().sub(this.controls.target);
    if (!turnByKey(event, offset, this.perspective.up)) return;
    event.preventDefault();
    this.perspective.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  /** Length in the scene of one pixel at a place. */
  pixelSize(place: Vector3, height: number): number {
    const depth = this.isOrthographic
      ? this.perspective.position.distanceTo(this.controls.target)
      : place.clone().sub(this.perspective.position).dot(this.direction);
    return (2 * Math.max(depth, this.perspective.near) * TANGENT) / Math.max(1, height);
  }

  /** The ray through a place of the picture, x and y from -1 to 1. */
  ray(x: number, y: number): Ray {
    this.raycaster.setFromCamera(new Vector2(x, y), this.camera);
    return this.raycaster.ray.clone();
  }

  dispose(): void {
    this.controls.dispose();
  }
}

export function directionOf(view: StandardView): Vector3 {
  return new Vector3(...DIRECTIONS[view]);
}
