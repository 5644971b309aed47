// How far one model lies from another, as colors.

import { BufferAttribute, type Mesh, Vector3 } from "three";
import type { DecodedModel } from "./decode";
import { DEVIATION_COLORS } from "./deviation_colors";
import { NearestSurface, type Triangles } from "./nearest";

/**
 * Paints every vertex of a model by its distance to the other one, in the attribute "paint". Answers the largest
 * distance, in meters; undefined where one of the two has no surface.
 */
export function paintDeviation(model: DecodedModel, other: DecodedModel): number | undefined {
  const surface = trianglesOf(other.meshes);
  if (surface.indices.length === 0 || model.meshes.length === 0) return undefined;
  const nearest = new NearestSurface(surface);
  const place = new Vector3();
  let largest = 0;
  const distances = model.meshes.map((mesh) => {
    const position = mesh.geometry.getAttribute("position");
    const list = new Float32Array(position.count);
    for (let vertex = 0; vertex < position.count; vertex++) {
      place.fromBufferAttribute(position, vertex).applyMatrix4(mesh.matrixWorld);
      const distance = nearest.distance(place.x, place.y, place.z);
      list[vertex] = distance;
      if (distance > largest) largest = distance;
    }
    return list;
  });
  model.meshes.forEach(({ geometry }, at) => {
    geometry.setAttribute(
      "paint",
      new BufferAttribute(colorsOf(distances[at] ?? new Float32Array(), largest), 3, true),
    );
  });
  return largest;
}

function trianglesOf(meshes: readonly Mesh[]): Triangles {
  const positions: number[] = [];
  const indices: number[] = [];
  const place = new Vector3();
  for (const mesh of meshes) {
    mesh.updateWorldMatrix(true, false);
    const first = positions.length / 3;
    const position = mesh.geometry.getAttribute("position");
    for (let vertex = 0; vertex < position.count; vertex++) {
      place.fromBufferAttribute(position, vertex).applyMatrix4(mesh.matrixWorld);
      positions.push(place.x, place.y, place.z);
    }
    const index = mesh.geometry.getIndex()?.array ?? [];
    for (let at = 0; at < index.length; at++) indices.push(first + (index[at] ?? 0));
  }
  return { positions: new Float32Array(positions), indices };
}

function colorsOf(distances: Float32Array, largest: number): Uint8Array<ArrayBuffer> {
  const colors = new Uint8Array(3 * distances.length);
  distances.forEach((distance, vertex) => {
    const share = largest > 0 ? (distance / largest) * (DEVIATION_COLORS.length - 1) : 0;
    const from = Math.min(Math.floor(share), DEVIATION_COLORS.length - 2);
    for (let channel = 0; channel < 3; channel++) {
      const [a, b] = [DEVIATION_COLORS[from]?.[channel] ?? 0, DEVIATION_COLORS[from + 1]?.[channel] ?? 0];
      colors[3 * vertex + channel] = Math.round(255 * (a + (b - a) * (share - from)));
    }
  });
  return colors;
}
