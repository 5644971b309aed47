// Meshes that look like the figures, so that the page can be tried without the server. Not the product's mathematics.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function boost(point, center, a) {
  const y = add(point, scale(center, -1));
  const yy = dot(y, y);
  const denominator = 1 + 2 * dot(a, y) + dot(a, a) * yy;
  return add(center, scale(add(y, scale(a, yy)), 1 / Math.max(1e-3, denominator)));
}

function turnZ([x, y, z], angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y, z];
}

const circle = (center, tilt, radius, v) => {
  const [x, y] = [radius * Math.cos(2 * Math.PI * v), radius * Math.sin(2 * Math.PI * v)];
  return add(center, [x * Math.cos(tilt), y, -x * Math.sin(tilt)]);
};

/** A mesh over (u, v) in [0,1]², `rows` by `columns` quads. */
function sheet(rows, columns, at, color, flipped = false) {
  const positions = [];
  const uvs = [];
  const indices = [];
  for (let i = 0; i <= rows; i++) {
    for (let j = 0; j <= columns; j++) {
      positions.push(...at(i / rows, j / columns));
      uvs.push(i / rows, j / columns);
      if (i === rows || j === columns) continue;
      const corner = i * (columns + 1) + j;
      const across = corner + columns + 1;
      const [p, q] = flipped ? [corner + 1, across] : [across, corner + 1];
      indices.push(corner, p, q, across + 1, q, p);
    }
  }
  return { positions, uvs, indices, color };
}

/** Vertex normals, equal where vertices coincide (closed surfaces). */
export function normalsOf({ positions, indices }) {
  const count = positions.length / 3;
  const first = new Map();
  const place = Array.from({ length: count }, (_, i) => {
    const key = [0, 1, 2].reduce((sum, k) => sum * 4e5 + Math.round((positions[3 * i + k] + 20) * 1e4), 0);
    if (!first.has(key)) first.set(key, i);
    return 3 * first.get(key);
  });
  const sums = new Float64Array(3 * count);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [3 * indices[t], 3 * indices[t + 1], 3 * indices[t + 2]];
    const p = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const q = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    for (let k = 0; k < 3; k++) for (let m = 0; m < 3; m++) sums[place[indices[t + k]] + m] += normal[m];
  }
  return Array.from({ length: 3 * count }, (_, at) => {
    const from = place[Math.floor(at / 3)];
    return sums[from + (at % 3)] / (Math.hypot(sums[from], sums[from + 1], sums[from + 2]) || 1);
  });
}

const SHAPES = {
  fig02_circle_family: (p, n) => [
    sheet(
      n(96),
      n(96),
      (u, v) => boost(circle([0.9, 0, 0], (p.tilt * Math.PI) / 180, 0.5, v), [0, 0, 0], [0, 0.1, u * p.reach]),
      null,
      true,
    ),
  ],
  fig04_boosted_ring: (p, n) => [
    sheet(
      n(p.bands),
      n(128),
      (u, v) => boost(circle([0, 0, 0], 0, 1, v), [0, 0, p.height], [0, 0, u * p.reach]),
      p.tint,
      true,
    ),
  ],
  fig05_twisted_ring: (p, n) => [
    sheet(
      n(192),
      n(128),
      (u, v) => {
        const boosted = boost(circle(p.center, 0.35, 1, v), [0, 0, 1.5], [0, 0, u * p.reach]);
        return add(turnZ(boosted, (u * p.turn * Math.PI) / 180), [0, 0, u * p.slide]);
      },
      null,
      true,
    ),
  ],
  fig06_hopf_fibers: (p, n) =>
    Array.from({ length: p.fibers }, (_, index) => {
      const angle = (2 * Math.PI * index) / p.fibers;
      const hue = [0.55 + 0.4 * Math.cos(angle), 0.55 + 0.4 * Math.cos(angle - 2.1), 0.6 + 0.4 * Math.cos(angle + 2.1)];
      return sheet(
        n(96),
        12,
        (u, v) => {
          // A Villarceau circle of a torus, with a tube around it.
          const [t, w] = [2 * Math.PI * u, 2 * Math.PI * v];
          const onTorus = (s) => [
            (1.1 + 0.6 * Math.cos(s)) * Math.cos(s + angle),
            (1.1 + 0.6 * Math.cos(s)) * Math.sin(s + angle),
            0.6 * Math.sin(s),
          ];
          const center = onTorus(t);
          const outward = [Math.cos(t + angle), Math.sin(t + angle), 0];
          return add(center, add(scale(outward, p.thickness * Math.cos(w)), [0, 0, p.thickness * Math.sin(w)]));
        },
        hue,
      );
    }),
  fig11_patch: (p, n) => [
    sheet(
      n(96),
      n(96),
      (u, v) => {
        const [x, y] = [2.4 * u - 1.2, 2.4 * v - 1.2];
        const blend = (1 - u) * (1 - v) - u * (1 - v) - (1 - u) * v + u * v;
        return boost([x, y, p.lift * blend], [2 * u - 1, 2 * v - 1, 0.5], [0.2 * p.bend, 0, p.bend * blend]);
      },
      null,
    ),
  ],
  fig12_warped_sphere: (p, n) => [
    sheet(
      n(120),
      n(160),
      (u, v) => {
        const [theta, phi] = [Math.PI * u, 2 * Math.PI * v];
        let point = [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
        const start = point;
        for (const [center, direction] of [
          [
            [1.3, 0, 0.3],
            [0, 0, 1],
          ],
          [
            [-0.7, 1.1, 0],
            [1, 0, 0],
          ],
          [
            [-0.6, -1, 0.4],
            [0, 1, 0.6],
          ],
        ]) {
          const d = add(start, scale(center, -1));
          const moved = boost(start, center, scale(direction, p.strength / (dot(d, d) + p.softening)));
          point = add(point, add(moved, scale(start, -1)));
        }
        return point;
      },
      null,
    ),
  ],
};

/** The meshes of an example for its parameter values; drafts have half as many rows and columns. */
export function meshesOf(id, parameters, quality) {
  const count = (n) => Math.max(2, quality === "draft" ? Math.round(n / 2) : n);
  return SHAPES[id](parameters, count);
}
