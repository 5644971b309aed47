// The lines of a mesh: its edges without the diagonals that only split quads.

import { BufferAttribute, BufferGeometry } from "three";

/** A line geometry that shares the mesh's positions. Diagonals are left out where texture coordinates tell them. */
export function wireGeometry(mesh: BufferGeometry): BufferGeometry {
  const position = mesh.getAttribute("position");
  const uv = mesh.getAttribute("uv");
  const index = mesh.getIndex();
  const corners = index ? index.count : position.count;
  const corner = (at: number): number => (index ? index.getX(at) : at);
  const isDiagonal = (a: number, b: number): boolean => {
    if (!uv) return false;
    return Math.abs(uv.getX(a) - uv.getX(b)) > 1e-4 && Math.abs(uv.getY(a) - uv.getY(b)) > 1e-4;
  };
  // An edge as one number, smaller corner first; exact up to 2^26 vertices.
  const edges = new Float64Array(corners);
  let count = 0;
  for (let triangle = 0; triangle + 2 < corners; triangle += 3) {
    for (let side = 0; side < 3; side++) {
      const a = corner(triangle + side);
      const b = corner(triangle + ((side + 1) % 3));
      if (!isDiagonal(a, b)) edges[count++] = Math.min(a, b) * position.count + Math.max(a, b);
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
