// The letters at the ends of the axes: always as large, and where the toolbars of the view leave them to be seen.

import { type Camera, CanvasTexture, Sprite, SpriteMaterial, Vector2, Vector3, type WebGLRenderer } from "three";

/** How high a letter is, in pixels. */
const LETTER_PIXELS = 12;
/** Its picture, and how high the capitals are in it. */
const PICTURE = { pixels: 64, font: 44, capitals: 32 };
const SPRITE_PIXELS = (LETTER_PIXELS * PICTURE.pixels) / PICTURE.capitals;
/** What the toolbars and the border take of a view, in pixels. */
const TAKEN = { top: 58, bottom: 60, side: 16 };
/** Letters so near to the origin would lie on one another. */
const LEAST_SHARE = 0.15;
const BISECTIONS = 20;

/** How far along from `origin` to `tip` a letter is in sight of a view of the given size: 1 at the tip, 0 where it is not. */
export function letterShare(origin: Vector3, tip: Vector3, camera: Camera, size: Vector2): number {
  const point = new Vector3();
  const isSeen = (share: number): boolean => {
    point.lerpVectors(origin, tip, share).applyMatrix4(camera.matrixWorldInverse);
    if (point.z >= 0) return false;
    point.applyMatrix4(camera.projectionMatrix);
    return (
      Math.abs(point.x) <= 1 - (2 * TAKEN.side) / size.x &&
      point.y <= 1 - (2 * TAKEN.top) / size.y &&
      point.y >= -1 + (2 * TAKEN.bottom) / size.y
    );
  };
  if (isSeen(1)) return 1;
  if (!isSeen(0)) return 0;
  let [seen, hidden] = [0, 1];
  for (let step = 0; step < BISECTIONS; step++) {
    const middle = (seen + hidden) / 2;
    if (isSeen(middle)) seen = middle;
    else hidden = middle;
  }
  return seen < LEAST_SHARE ? 0 : seen;
}

/** A letter at `tip`, given in the coordinates of what it is added to, or before it on the axis. */
export function makeAxisLetter(letter: string, color: string, tip: Vector3): Sprite {
  const sprite = new Sprite(
    new SpriteMaterial({ map: pictureOf(letter, color), sizeAttenuation: false, transparent: true, depthWrite: false }),
  );
  sprite.position.copy(tip);
  // Where it is drawn is known only when it is.
  sprite.frustumCulled = false;
  const size = new Vector2();
  const [from, to] = [new Vector3(), new Vector3()];
  sprite.onBeforeRender = (renderer, _scene, camera) => {
    (renderer as WebGLRenderer).getSize(size);
    const axes = sprite.parent;
    if (!axes || size.x <= 0 || size.y <= 0) return;
    const share = letterShare(
      from.setFromMatrixPosition(axes.matrixWorld),
      axes.localToWorld(to.copy(tip)),
      camera,
      size,
    );
    sprite.material.opacity = share > 0 ? 1 : 0;
    sprite.position.copy(tip).multiplyScalar(share);
    sprite.scale.setScalar((2 * SPRITE_PIXELS) / (size.y * (camera.projectionMatrix.elements[5] ?? 1)));
    // Where it is not at its end, it stands beside the line and before the model.
    sprite.material.depthTest = share === 1;
    sprite.center.set(share < 1 ? -0.05 : 0.5, 0.5);
    sprite.updateMatrixWorld();
  };
  return sprite;
}

function pictureOf(letter: string, color: string): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = PICTURE.pixels;
  const context = canvas.getContext("2d");
  if (context) {
    context.font = `600 ${PICTURE.font}px 'Inter Variable', sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = color;
    context.fillText(letter, PICTURE.pixels / 2, PICTURE.pixels / 2 + 2);
  }
  return new CanvasTexture(canvas);
}
