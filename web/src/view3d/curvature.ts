// Curvature of a mesh per vertex, and its colors. Where the server sends none it is estimated from the normals: over a
// triangle they are taken as linear, and what their change makes of the triangle's edges is the shape operator.

export type CurvatureKind = "gauss" | "mean";

/** Share of the values that lies within the ends of the palette. */
const CLAMP = 0.95;
const MOST_SAMPLES = 20_000;
const MOST_ROUNDS = 24;
const VERTICES_PER_ROUND = 1000;

/** Linear colors of the palette: blue below zero, white at zero, orange above. */
const NEGATIVE = [0.02, 0.12, 0.55] as const;
const POSITIVE = [0.87, 0.25, 0.01] as const;
const ZERO = [0.78, 0.78, 0.78] as const;

/**
 * Gaussian (1/m^2) or mean curvature (1/m) of every vertex, from positions, unit normals and triangles. Mean curvature
 * is positive where the surface bends away from its normals, as on a ball. A vertex without any whole triangle has 0.
 */
export function estimateCurvature(
  kind: CurvatureKind,
  positions: ArrayLike<number>,
  normals: ArrayLike<number>,
  indices: ArrayLike<number>,
): Float32Array {
  const sums = new Float32Array(positions.length / 3);
  const weights = new Float32Array(positions.length / 3);
  const edge = (list: ArrayLike<number>, from: number, to: number): Triple => [
    at(list, 3 * to) - at(list, 3 * from),
    at(list, 3 * to + 1) - at(list, 3 * from + 1),
    at(list, 3 * to + 2) - at(list, 3 * from + 2),
  ];
  for (let corner = 0; corner + 2 < indices.length; corner += 3) {
    const [a, b, c] = [at(indices, corner), at(indices, corner + 1), at(indices, corner + 2)];
    const [e, f] = [edge(positions, a, b), edge(positions, a, c)];
    const normal = cross(e, f);
    const area = Math.hypot(...normal);
    const length = Math.hypot(...e);
    if (!(area > 1e-6 * length * Math.hypot(...f))) continue;
    // A basis of the triangle's plane: along the first edge, and across it.
    const u = scaled(e, 1 / length);
    const v = scaled(cross(normal, e), 1 / (area * length));
    const [dn, dm] = [edge(normals, a, b), edge(normals, a, c)];
    const [eu, fu, fv] = [length, dot(f, u), dot(f, v)];
    const [nu, nv, mu, mv] = [dot(dn, u), dot(dn, v), dot(dm, u), dot(dm, v)];
    const determinant = eu * fv;
    const value =
      kind === "gauss" ? (nu * mv - nv * mu) / determinant : (nu * fv + mv * eu - nv * fu) / (2 * determinant);
    for (const vertex of [a, b, c]) {
      sums[vertex] = at(sums, vertex) + area * value;
      weights[vertex] = at(weights, vertex) + area;
    }
  }
  return sums.map((sum, vertex) => sum / (at(weights, vertex) || 1));
}

/**
 * Takes the grain out of an estimate: normals come in steps, and their change over a small triangle shows mostly those.
 * Values are averaged with their neighbors', the more often the finer the mesh is.
 */
export function smoothed(values: Float32Array, indices: ArrayLike<number>): Float32Array {
  const rounds = Math.min(MOST_ROUNDS, Math.floor(values.length / VERTICES_PER_ROUND));
  let result = values;
  for (let round = 0; round < rounds; round++) {
    const [sums, counts] = [new Float32Array(values.length), new Float32Array(values.length)];
    for (let corner = 0; corner + 2 < indices.length; corner += 3) {
      const [a, b, c] = [at(indices, corner), at(indices, corner + 1), at(indices, corner + 2)];
      const mean = (at(result, a) + at(result, b) + at(result, c)) / 3;
      for (const vertex of [a, b, c]) {
        sums[vertex] = at(sums, vertex) + mean;
        counts[vertex] = at(counts, vertex) + 1;
      }
    }
    result = sums.map((sum, vertex) => (at(counts, vertex) > 0 ? sum / at(counts, vertex) : at(values, vertex)));
  }
  return result;
}

/** The magnitude that 95 of 100 values stay within; at least a hair, so that a flat surface is white. */
export function curvatureRange(lists: readonly ArrayLike<number>[]): number {
  const total = lists.reduce((sum, list) => sum + list.length, 0);
  const stride = Math.max(1, Math.ceil(total / MOST_SAMPLES));
  const samples: number[] = [];
  for (const list of lists) {
    for (let vertex = 0; vertex < list.length; vertex += stride) {
      const value = Math.abs(at(list, vertex));
      if (Number.isFinite(value)) samples.push(value);
    }
  }
  samples.sort((a, b) => a - b);
  return Math.max(1e-6, samples[Math.min(samples.length - 1, Math.floor(CLAMP * samples.length))] ?? 0);
}

/** A linear color per value, as bytes. */
export function curvatureColors(values: ArrayLike<number>, range: number): Uint8Array<ArrayBuffer> {
  const colors = new Uint8Array(3 * values.length);
  for (let vertex = 0; vertex < values.length; vertex++) {
    const share = Math.min(1, Math.max(-1, at(values, vertex) / range)) || 0;
    const end = share < 0 ? NEGATIVE : POSITIVE;
    for (let channel = 0; channel < 3; channel++) {
      const [from, to] = [ZERO[channel] ?? 0, end[channel] ?? 0];
      colors[3 * vertex + channel] = Math.round(255 * (from + (to - from) * Math.abs(share)));
    }
  }
  return colors;
}

type Triple = [number, number, number];

function at(list: ArrayLike<number>, index: number): number {
  return list[index] ?? 0;
}

function cross([a, b, c]: Triple, [x, y, z]: Triple): Triple {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

function dot([a, b, c]: Triple, [x, y, z]: Triple): number {
  return a * x + b * y + c * z;
}

function scaled([a, b, c]: Triple, factor: number): Triple {
  return [a * factor, b * factor, c * factor];
}
