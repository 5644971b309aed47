// Pictures to take away: small ones for the gallery, and what is seen as a PNG.

import { PerspectiveCamera, Scene, type Vector3, type WebGLRenderer } from "three";
import type { CameraPlace } from "../model/document";
import type { DecodedModel } from "./decode";
import { frame, framingOf, placeCamera, samplePositions } from "./framing";

const FIELD_OF_VIEW = 32;

/**
 * A model alone on a clear ground, as an address for an <img>: seen from a place, else from a direction. Leaves the
 * renderer at a size of its own.
 */
export async function pictureOf(
  renderer: WebGLRenderer,
  model: DecodedModel,
  seen: CameraPlace | Vector3,
  width: number,
  height: number,
): Promise<string> {
  const scene = new Scene().add(model.scene);
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, width / height, 0.01, 1000);
  const points = samplePositions(model.scene);
  const [direction, framing] =
    "target" in seen ? framingOf(seen, points, camera.aspect) : ([seen, frame(points, seen, camera)] as const);
  const picture = document.createElement("canvas");
  picture.width = width;
  picture.height = height;
  if (framing) {
    placeCamera(camera, direction, framing);
    // Drawn twice as large and scaled down, which is smooth without multisampling.
    const ratio = renderer.getPixelRatio();
    renderer.setPixelRatio(1);
    renderer.setSize(2 * width, 2 * height, false);
    renderer.render(scene, camera);
    picture.getContext("2d")?.drawImage(renderer.domElement, 0, 0, width, height);
    renderer.setPixelRatio(ratio);
  }
  const blob = await png(picture);
  return blob ? URL.createObjectURL(blob) : "";
}

/** A drawn canvas on its ground, a gradient from top to bottom. To be called in the task that drew it. */
export function onGround(canvas: HTMLCanvasElement, [top, bottom]: readonly [string, string]): HTMLCanvasElement {
  const picture = document.createElement("canvas");
  picture.width = canvas.width;
  picture.height = canvas.height;
  const context = picture.getContext("2d");
  if (context) {
    const ground = context.createLinearGradient(0, 0, 0, picture.height);
    ground.addColorStop(0, top);
    ground.addColorStop(1, bottom);
    context.fillStyle = ground;
    context.fillRect(0, 0, picture.width, picture.height);
    context.drawImage(canvas, 0, 0);
  }
  return picture;
}

function png(canvas: HTMLCanvasElement): Promise<Blob | null> {
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}
