// Lines some pixels wide: WebGL's own are one pixel. Every segment is a rectangle that the vertex shader turns to the eye.

import {
  BufferAttribute,
  BufferGeometry,
  type Color,
  type DepthModes,
  type Material,
  Mesh,
  ShaderMaterial,
  Vector2,
} from "three";

const VERTEX = `
attribute vec3 from;
attribute vec3 to;
uniform vec2 size;
uniform float width;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(from, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  // An end behind the eye is moved to just before it, or the segment would be drawn to the wrong side.
  const float nearest = 1e-4;
  if (a.w < nearest && b.w > nearest) a = mix(a, b, (nearest - a.w) / (b.w - a.w));
  if (b.w < nearest && a.w > nearest) b = mix(b, a, (nearest - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
  vec4 end = position.x < 0.5 ? a : b;
  vec2 corner = vec2(-along.y, along.x) * position.y + along * (position.x < 0.5 ? -0.5 : 0.5);
  end.xy += corner * width / size * end.w;
  gl_Position = end;
}`;

const FRAGMENT = `
uniform vec3 color;
uniform float opacity;
void main() {
  gl_FragColor = vec4(color, opacity);
  #include <colorspace_fragment>
}`;

export interface LineLook {
  color: Color;
  /** In pixels. */
  width: number;
  opacity: number;
  depthFunc?: DepthModes;
  depthTest?: boolean;
}

/** Size of the drawing in pixels, shared by all thick lines: set it whenever the size changes. */
export const drawingSize = { value: new Vector2(1, 1) };

/**
 * Segments between pairs of points, three numbers a point. Every corner is a vertex of its own: without a GPU, an
 * instance costs as much as a drawing.
 */
export function segmentGeometry(pairs: ArrayLike<number>): BufferGeometry {
  const count = Math.floor(pairs.length / 6);
  const [from, to] = [new Float32Array(12 * count), new Float32Array(12 * count)];
  const corners = new Float32Array(12 * count);
  const index = new Uint32Array(6 * count);
  for (let segment = 0; segment < count; segment++) {
    for (let corner = 0; corner < 4; corner++) {
      const vertex = 4 * segment + corner;
      for (let axis = 0; axis < 3; axis++) {
        from[3 * vertex + axis] = pairs[6 * segment + axis] ?? 0;
        to[3 * vertex + axis] = pairs[6 * segment + 3 + axis] ?? 0;
      }
      corners[3 * vertex] = corner === 1 || corner === 2 ? 1 : 0;
      corners[3 * vertex + 1] = corner < 2 ? -1 : 1;
    }
    index.set(
      [0, 1, 2, 0, 2, 3].map((corner) => 4 * segment + corner),
      6 * segment,
    );
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(corners, 3));
  geometry.setAttribute("from", new BufferAttribute(from, 3));
  geometry.setAttribute("to", new BufferAttribute(to, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

/** The points of a polyline as pairs. */
export function pairsOf(points: ArrayLike<number>): Float32Array {
  const count = Math.max(0, points.length / 3 - 1);
  const pairs = new Float32Array(6 * count);
  for (let segment = 0; segment < count; segment++) {
    for (let at = 0; at < 6; at++) pairs[6 * segment + at] = points[3 * segment + at] ?? 0;
  }
  return pairs;
}

export function thickMaterial({ color, width, opacity, depthFunc, depthTest = true }: LineLook): ShaderMaterial {
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { color: { value: color }, width: { value: width }, opacity: { value: opacity }, size: drawingSize },
    transparent: true,
    depthTest,
    depthWrite: false,
  });
  if (depthFunc !== undefined) material.depthFunc = depthFunc;
  return material;
}

/** A drawn object of segments; it is never taken for out of sight, because its corners are where the shader says. */
export function thickLines(geometry: BufferGeometry, material: Material): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}
