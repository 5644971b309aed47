// How each handle of a gizmo turns a pointer's ray into a new value. All of it in the scene's coordinates.

import { type Ray, Vector3 } from "three";
import { alongAxis, inGraph, inScene, onPlane, snapped, tidy } from "./drag";
import type { Vec } from "./gizmo_values";

/** What a drag needs to know of the view. */
export interface DragView {
  /** Where the camera looks. */
  direction(): Vector3;
  /** Size of a cell of the grid. */
  cell(): number;
}

/** Begins with the first ray and answers a new value for every further one; undefined where a ray says nothing. */
export type VectorDrag = (first: Ray) => (ray: Ray, snap: boolean) => Vec | undefined;
export type NumberDrag = (first: Ray) => (ray: Ray, snap: boolean) => number | undefined;

export const AXES: readonly Vec[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Along one axis of the graph. */
export function axisDrag(view: DragView, axis: number, value: () => Vec): VectorDrag {
  return (first) => {
    const start = value();
    const [origin, along] = [inScene(start), inScene(AXES[axis] ?? [1, 0, 0])];
    const grip = alongAxis(first, origin, along) ?? 0;
    return (ray, snap) => {
      const reach = alongAxis(ray, origin, along);
      if (reach === undefined) return undefined;
      const next = [...start] as [number, number, number];
      next[axis] = rounded((start[axis] ?? 0) + reach - grip, view, snap);
      return next;
    };
  };
}

/** In a plane through the value: square to an axis of the graph, or facing the eye. The other axis stays as it is. */
export function planeDrag(view: DragView, fixed: number | undefined, value: () => Vec): VectorDrag {
  return (first) => {
    const start = value();
    const origin = inScene(start);
    const normal = fixed === undefined ? view.direction() : inScene(AXES[fixed] ?? [0, 0, 1]);
    const grip = onPlane(first, origin, normal)?.sub(origin) ?? new Vector3();
    return (ray, snap) => {
      const met = onPlane(ray, origin, normal);
      if (!met) return undefined;
      const moved = inGraph(met.sub(grip));
      return [0, 1, 2].map((axis) =>
        axis === fixed ? (start[axis] ?? 0) : rounded(moved[axis] ?? 0, view, snap),
      ) as unknown as Vec;
    };
  };
}

/** The tip of an arrow: a drag of a point, with the arrow's foot taken off. An arrow never becomes nothing. */
export function tipDrag(view: DragView, foot: () => Vec, value: () => Vec): VectorDrag {
  const tip = (): Vec => sum(foot(), value(), 1);
  return (first) => {
    const move = planeDrag(view, undefined, tip)(first);
    return (ray, snap) => {
      const moved = move(ray, snap);
      const next = moved && sum(moved, foot(), -1).map((part) => tidy(part, view.cell()));
      return next && Math.hypot(...next) > 0 ? (next as unknown as Vec) : undefined;
    };
  };
}

/** The distance from a center, in the plane of a ring or, where that is seen from the side, facing the eye. */
export function radiusDrag(view: DragView, center: () => Vec, normal: () => Vec): NumberDrag {
  return () => (ray, snap) => {
    const origin = inScene(center());
    const met = onPlane(ray, origin, inScene(normal())) ?? onPlane(ray, origin, view.direction());
    if (!met) return undefined;
    const smallest = tidy(view.cell() / 100, view.cell() / 100);
    return Math.max(smallest, rounded(met.distanceTo(origin), view, snap));
  };
}

function rounded(value: number, view: DragView, snap: boolean): number {
  return snap ? snapped(value, view.cell() / 2) : tidy(value, view.cell());
}

export function sum(a: Vec, b: Vec, factor: number): Vec {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}
