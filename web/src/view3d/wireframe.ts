// The lines of a mesh: its edges without the diagonals that only split quads, and of a fine surface every few of them.

import { BufferAttribute, BufferGeometry } from "three";

/** More lines than this in one direction are a gray mush at the size of a pane. */
const MOST_LINES = 72;
/** Texture coordinates come on a grid of 12 bits. */
const STEPS = 4096;
const SAME = 0.6 / STEPS;

/** Which values of each texture coordinate have a line; undefined where all have. */
export interface Lattice {
  u: Set<number> | undefined;
  v: Set<number> | undefined;
}

/** The lines to keep of surfaces that are drawn together. */
export function latticeOf(meshes: readonly BufferGeometry[]): Lattice {
  const [u, v] = [new Set<number>(), new Set<number>()];
  for (const mesh of meshes) {
    const uv = mesh.getAttribute("uv");
    for (let at = 0; at < (uv?.count ?? 0); at++) {
      u.add(step(uv.getX(at)));
      v.add(step(uv.getY(at)));
    }
  }
  return { u: thinned(u), v: thinned(v) };
}

/** A line geometry that shares the mesh's positions. Diagonals are told by texture coordinates; without, all edges stay. */
export function wireGeometry(mesh: BufferGeometry, lattice: Lattice): BufferGeometry {
  const position = mesh.getAttribute("position");
  const uv = mesh.getAttribute("uv");
  const index = mesh.getIndex();
  const corners = index ? index.count : position.count;
  const corner = (at: number): number => (index ? index.getX(at) : at);
  const isLine = (a: number, b: number): boolean => {
    if (!uv) return true;
    const [ua, va, ub, vb] = [uv.getX(a), uv.getY(a), uv.getX(b), uv.getY(b)];
    if (Math.abs(ua - ub) < SAME) return lattice.u?.has(step(ua)) ?? true;
    if (Math.abs(va - vb) < SAME) return lattice.v?.has(step(va)) ?? true;
    return false;
  };
  // An edge as one number, smaller corner first; exact up to 2^26 vertices.
  const edges = new Float64Array(corners);
  let count = 0;
  for (let triangle = 0; triangle + 2 < corners; triangle += 3) {
    for (let side = 0; side < 3; side++) {
      const a = corner(triangle + side);
      const b = corner(triangle + ((side + 1) % 3));
      if (isLine(a, b)) edges[count++] = Math.min(a, b) * position.count + Math.max(a, b);
    }
  }
  const sorted = edges.subarray(0, count).sort();
  const lines = new Uint32Array(2 * count);
  let used = 0;
  for (let at = 0; at < count; at++) {
    const edge = sorted[at] ?? 0;
    if (at > 0 && edge === sorted[at - 1]) continue;
    lines[used++] = Math.floor(edge / position.count);
    lines[used++] = edge % position.count;
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", position);
  geometry.setIndex(new BufferAttribute(lines.slice(0, used), 1));
  return geometry;
}

function step(coordinate: number): number {
  return Math.round(coordinate * STEPS);
}

/** Every n-th value, and the last; undefined if there are few enough. */
function thinned(values: Set<number>): Set<number> | undefined {
  if (values.size <= MOST_LINES) return undefined;
  const sorted = [...values].sort((a, b) => a - b);
  const every = Math.ceil(sorted.length / MOST_LINES);
  return new Set(sorted.filter((_, at) => at % every === 0 || at === sorted.length - 1));
}
