// Where the camera stands so that a model fills the view.

import {
  Box3,
  type BufferGeometry,
  type Matrix4,
  type Mesh,
  type Object3D,
  type PerspectiveCamera,
  Vector3,
} from "three";
import type { CameraPlace, Triple } from "../model/document";

/** Share of the view that a framed model takes: what stands over the picture should not cover it. */
const FILL = 0.8;
const MOST_SAMPLES = 6000;
/** Width to height of the pictures that a document's camera is chosen for. */
export const PICTURE_ASPECT = 1.6;

export interface Framing {
  target: Vector3;
  distance: number;
  radius: number;
}

/** About `most` finite positions of a model in world space; some thousand are enough to frame it. */
export function samplePositions(root: Object3D, most = MOST_SAMPLES): Vector3[] {
  root.updateMatrixWorld(true);
  const geometries: { geometry: BufferGeometry; matrix: Matrix4 }[] = [];
  let total = 0;
  root.traverse((object) => {
    const geometry = (object as Mesh).geometry as BufferGeometry | undefined;
    if (!geometry?.getAttribute("position")) return;
    geometries.push({ geometry, matrix: object.matrixWorld });
    total += geometry.getAttribute("position").count;
  });
  const stride = Math.max(1, Math.ceil(total / most));
  const points: Vector3[] = [];
  for (const { geometry, matrix } of geometries) {
    const position = geometry.getAttribute("position");
    for (let at = 0; at < position.count; at += stride) {
      const point = new Vector3().fromBufferAttribute(position, at).applyMatrix4(matrix);
      if (Number.isFinite(point.x + point.y + point.z)) points.push(point);
    }
  }
  return points;
}

/** The target and distance from which `camera`, looking along `direction`, sees all points. */
export function frame(points: Vector3[], direction: Vector3, camera: PerspectiveCamera): Framing | undefined {
  if (points.length === 0) return undefined;
  const forward = direction.clone().normalize();
  const right = new Vector3().crossVectors(forward, camera.up).normalize();
  if (right.lengthSq() < 0.5) right.set(1, 0, 0);
  const up = new Vector3().crossVectors(right, forward);
  const target = new Box3().setFromPoints(points).getCenter(new Vector3());
  const tangentY = Math.tan((camera.fov * Math.PI) / 360) * FILL;
  const tangentX = tangentY * camera.aspect;
  const offset = new Vector3();
  let [distance, radius] = [0, 0];
  // The second round centers what is seen, since near parts look larger than far ones.
  for (let round = 0; round < 3; round++) {
    const seen = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
    const nearest = distance;
    distance = 0;
    for (const point of points) {
      offset.subVectors(point, target);
      const [x, y, depth] = [offset.dot(right), offset.dot(up), offset.dot(forward)];
      radius = Math.max(radius, offset.length());
      distance = Math.max(distance, Math.abs(x) / tangentX - depth, Math.abs(y) / tangentY - depth);
      const scale = nearest > 0 ? nearest / Math.max(nearest + depth, nearest * 0.05) : 1;
      seen.left = Math.min(seen.left, x * scale);
      seen.right = Math.max(seen.right, x * scale);
      seen.low = Math.min(seen.low, y * scale);
      seen.high = Math.max(seen.high, y * scale);
    }
    if (round === 2) break;
    target.addScaledVector(right, (seen.left + seen.right) / 2).addScaledVector(up, (seen.low + seen.high) / 2);
  }
  radius = Math.max(radius, 1e-6);
  return { target, distance: Math.max(distance, radius * 0.2), radius };
}

/**
 * The direction and framing of a document's camera. In a view narrower than a picture it stands further back, so that
 * the sides stay in sight.
 */
export function framingOf(place: CameraPlace, points: Vector3[], aspect: number): [Vector3, Framing] {
  const target = inScene(place.target);
  const direction = target.clone().sub(inScene(place.position));
  const distance = direction.length() * Math.max(1, PICTURE_ASPECT / aspect);
  const radius = points.reduce((most, point) => Math.max(most, point.distanceTo(target)), 1e-6);
  return [direction, { target, distance, radius }];
}

/** Graph coordinates (Z up) in those of the scene (Y up), as the export's root node turns them. */
function inScene([x, y, z]: Triple): Vector3 {
  return new Vector3(x, z, -y);
}

/** Puts the camera `distance` before the target, looking along `direction`, with depth enough to look around. */
export function placeCamera(camera: PerspectiveCamera, direction: Vector3, framing: Framing): void {
  const { target, distance, radius } = framing;
  camera.position.copy(target).addScaledVector(direction.clone().normalize(), -distance);
  camera.near = Math.max(distance, radius) / 500;
  camera.far = distance + radius * 80;
  camera.lookAt(target);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}
