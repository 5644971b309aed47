// What a drag across the picture means in space. Rays go from the eye through the pointer.

import { type Ray, Vector3 } from "three";

/** Rays flatter than this against a plane or nearer than this to an axis say nothing useful about it. */
const FLAT = 0.04;

/** How far along an axis the ray passes it: `origin + t * direction`; undefined if they are nearly parallel. */
export function alongAxis(ray: Ray, origin: Vector3, direction: Vector3): number | undefined {
  const unit = direction.clone().normalize();
  const cosine = unit.dot(ray.direction);
  const sine = 1 - cosine * cosine;
  if (sine < FLAT * FLAT) return undefined;
  const between = origin.clone().sub(ray.origin);
  return (cosine * between.dot(ray.direction) - between.dot(unit)) / sine;
}

/** Where the ray meets a plane; undefined if it runs along it or away from it. */
export function onPlane(ray: Ray, point: Vector3, normal: Vector3): Vector3 | undefined {
  const unit = normal.clone().normalize();
  const slope = unit.dot(ray.direction);
  if (Math.abs(slope) < FLAT) return undefined;
  const t = point.clone().sub(ray.origin).dot(unit) / slope;
  return ray.origin.clone().addScaledVector(ray.direction, t);
}

/** The nearest multiple of `step`, without the noise of binary fractions. */
export function snapped(value: number, step: number): number {
  return tidy(Math.round(value / step) * step, step);
}

/** Rounded to a thousandth of the step: a dragged number is not more exact than the hand. */
export function tidy(value: number, step: number): number {
  const decimals = Math.min(12, Math.max(0, Math.ceil(-Math.log10(step)) + 2));
  return Number(value.toFixed(decimals)) + 0;
}

/** Coordinates of the graph (Z up) in the scene (Y up), as the root of every model turns them. */
export function inScene([x, y, z]: readonly [number, number, number]): Vector3 {
  return new Vector3(x, z, -y);
}

/** Coordinates of the scene in the graph. */
export function inGraph({ x, y, z }: Vector3): [number, number, number] {
  return [x, -z + 0, y];
}
