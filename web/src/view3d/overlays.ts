// The grid and the axes, in the graph's coordinates (Z up).

import {
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  type Mesh,
  type Object3D,
  Sprite,
  Vector3,
} from "three";
import { makeAxisLetter } from "./axis_letters";

export interface OverlayColors {
  grid: string;
  axes: readonly [string, string, string];
}

const HALF_LINES = 20;
const MAJOR_EVERY = 5;

/** Size of a grid cell for a model of the given radius: 1, 2 or 5 times a power of ten. */
export function cellSize(radius: number): number {
  const wanted = Math.max(radius, 1e-9) / 5;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5].find((factor) => factor * power >= wanted * 0.999) ?? 10;
  return step * power;
}

/** A square of lines in the XY plane that fades towards its border. */
export function makeGrid(cell: number, color: string): LineSegments {
  const positions: number[] = [];
  const colors: number[] = [];
  const rgb = new Color(color);
  const reach = HALF_LINES * cell;
  const vertex = (x: number, y: number, strength: number): void => {
    const fade = Math.max(0, 1 - Math.hypot(x, y) / reach) ** 1.5;
    positions.push(x, y, 0);
    colors.push(rgb.r, rgb.g, rgb.b, strength * fade);
  };
  for (let line = -HALF_LINES; line <= HALF_LINES; line++) {
    const strength = line % MAJOR_EVERY === 0 ? 0.85 : 0.38;
    // Lines are cut into pieces, because the fade is read at their ends only.
    for (let piece = -HALF_LINES; piece < HALF_LINES; piece += 2) {
      const [from, to, at] = [piece * cell, (piece + 2) * cell, line * cell];
      vertex(at, from, strength);
      vertex(at, to, strength);
      vertex(from, at, strength);
      vertex(to, at, strength);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.setAttribute("color", new Float32BufferAttribute(colors, 4));
  const material = new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false });
  const grid = new LineSegments(geometry, material);
  grid.renderOrder = -1;
  return grid;
}

/** Three lines of the given length from the origin, with their letters. */
export function makeAxes(length: number, colors: readonly [string, string, string]): Group {
  const group = new Group();
  ["X", "Y", "Z"].forEach((letter, index) => {
    const end = new Vector3().setComponent(index, length);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute([0, 0, 0, ...end], 3));
    const color = colors[index] ?? "#ffffff";
    group.add(new LineSegments(geometry, new LineBasicMaterial({ color, transparent: true, opacity: 0.9 })));
    group.add(makeAxisLetter(letter, color, end.clone().multiplyScalar(1.06)));
  });
  return group;
}

/** Takes an overlay out of the scene and frees all it is made of. */
export function remove(object: Object3D | undefined): void {
  if (!object) return;
  object.removeFromParent();
  object.traverse((child) => {
    if (child instanceof Sprite) child.material.map?.dispose();
    const drawn = child as Mesh<BufferGeometry, Material>;
    drawn.geometry?.dispose();
    drawn.material?.dispose();
  });
}
