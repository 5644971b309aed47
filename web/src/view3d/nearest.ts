// The distance from points to a surface of triangles, by a tree of boxes.

/** Positions as triples, triangles as triples of places among them. */
export interface Triangles {
  positions: Float32Array;
  indices: ArrayLike<number>;
}

const MOST_IN_LEAF = 6;
const BOX = 6;

/** A surface that is asked for distances; building it takes about as long as some thousand questions. */
export class NearestSurface {
  /** Triangles in the order of the leaves. */
  private readonly order: Uint32Array;
  /** Least and greatest coordinates of each node. */
  private readonly boxes: number[] = [];
  /** First triangle and count of a leaf, or the second child and 0: the first child follows its parent. */
  private readonly nodes: number[] = [];
  private last = 0;

  constructor(private readonly surface: Triangles) {
    const count = Math.floor(surface.indices.length / 3);
    this.order = Uint32Array.from({ length: count }, (_, triangle) => triangle);
    const centers = new Float32Array(3 * count);
    for (let triangle = 0; triangle < count; triangle++) {
      for (let axis = 0; axis < 3; axis++) {
        let sum = 0;
        for (let corner = 0; corner < 3; corner++) sum += this.coordinate(triangle, corner, axis);
        centers[3 * triangle + axis] = sum / 3;
      }
    }
    if (count > 0) this.build(0, count, centers);
  }

  /** Infinity where there are no triangles. */
  distance(x: number, y: number, z: number): number {
    if (this.order.length === 0) return Infinity;
    // Neighbors are asked for one after the other: what was nearest to the last is near to this one.
    let [best, nearest] = [this.squareTo(this.last, x, y, z), this.last];
    const stack = [0];
    for (let node = stack.pop(); node !== undefined; node = stack.pop()) {
      if (this.squareToBox(node, x, y, z) >= best) continue;
      const [first = 0, size = 0] = [this.nodes[2 * node], this.nodes[2 * node + 1]];
      if (size === 0) {
        const isFirstNearer = this.squareToBox(node + 1, x, y, z) < this.squareToBox(first, x, y, z);
        stack.push(...(isFirstNearer ? [first, node + 1] : [node + 1, first]));
        continue;
      }
      for (let at = first; at < first + size; at++) {
        const triangle = this.order[at] ?? 0;
        const square = this.squareTo(triangle, x, y, z);
        if (square < best) [best, nearest] = [square, triangle];
      }
    }
    this.last = nearest;
    return Math.sqrt(best);
  }

  private coordinate(triangle: number, corner: number, axis: number): number {
    return this.surface.positions[3 * (this.surface.indices[3 * triangle + corner] ?? 0) + axis] ?? 0;
  }

  /** Puts the triangles from `first` to `end` below a new node. The tree is as deep as the logarithm of their number. */
  private build(first: number, end: number, centers: Float32Array): number {
    const node = this.nodes.length / 2;
    const [low, high] = [
      [Infinity, Infinity, Infinity],
      [-Infinity, -Infinity, -Infinity],
    ];
    for (let at = first; at < end; at++) {
      for (let corner = 0; corner < 3; corner++) {
        for (let axis = 0; axis < 3; axis++) {
          const value = this.coordinate(this.order[at] ?? 0, corner, axis);
          low[axis] = Math.min(low[axis] ?? value, value);
          high[axis] = Math.max(high[axis] ?? value, value);
        }
      }
    }
    this.boxes.push(...low, ...high);
    this.nodes.push(first, end - first);
    if (end - first <= MOST_IN_LEAF) return node;
    const sizes = low.map((value, axis) => (high[axis] ?? value) - value);
    const axis = sizes.indexOf(Math.max(...sizes));
    this.order.subarray(first, end).sort((a, b) => (centers[3 * a + axis] ?? 0) - (centers[3 * b + axis] ?? 0));
    const middle = (first + end) >> 1;
    this.build(first, middle, centers);
    this.nodes[2 * node] = this.build(middle, end, centers);
    this.nodes[2 * node + 1] = 0;
    return node;
  }

  private squareToBox(node: number, x: number, y: number, z: number): number {
    let square = 0;
    for (let axis = 0; axis < 3; axis++) {
      const value = axis === 0 ? x : axis === 1 ? y : z;
      const outside = Math.max(
        (this.boxes[BOX * node + axis] ?? 0) - value,
        value - (this.boxes[BOX * node + 3 + axis] ?? 0),
        0,
      );
      square += outside * outside;
    }
    return square;
  }

  /** The square of the distance to a triangle (Ericson, Real-Time Collision Detection, 5.1.5). */
  private squareTo(triangle: number, x: number, y: number, z: number): number {
    const at = (corner: number, axis: number): number => this.coordinate(triangle, corner, axis);
    const [ax, ay, az] = [at(0, 0), at(0, 1), at(0, 2)];
    const [ux, uy, uz] = [at(1, 0) - ax, at(1, 1) - ay, at(1, 2) - az];
    const [vx, vy, vz] = [at(2, 0) - ax, at(2, 1) - ay, at(2, 2) - az];
    const [px, py, pz] = [x - ax, y - ay, z - az];
    const square = (s: number, t: number): number =>
      (px - s * ux - t * vx) ** 2 + (py - s * uy - t * vy) ** 2 + (pz - s * uz - t * vz) ** 2;
    const [d1, d2] = [ux * px + uy * py + uz * pz, vx * px + vy * py + vz * pz];
    if (d1 <= 0 && d2 <= 0) return square(0, 0);
    const [uu, uv, vv] = [ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz];
    const [d3, d4] = [d1 - uu, d2 - uv];
    if (d3 >= 0 && d4 <= d3) return square(1, 0);
    const vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return square(d1 / (d1 - d3), 0);
    const [d5, d6] = [d1 - uv, d2 - vv];
    if (d6 >= 0 && d5 <= d6) return square(0, 1);
    const vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return square(0, d2 / (d2 - d6));
    const va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
      const share = (d4 - d3) / (d4 - d3 + (d5 - d6));
      return square(1 - share, share);
    }
    const sum = va + vb + vc;
    return sum > 0 ? square(vb / sum, vc / sum) : square(0, 0);
  }
}
