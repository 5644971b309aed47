// Gives a primitive of a model the look of the page.

import { type BufferGeometry, Line, LineSegments, Mesh, Points, type Material, type Object3D } from "three";
import type { GltfPrimitive } from "./gltf";
import type { Materials } from "./materials";

/** The drawn object of a primitive. Materials are shared; colors, opacity and vertex colors are the model's own. */
export function dress(geometry: BufferGeometry, primitive: GltfPrimitive, materials: Materials): Object3D {
  const style = {
    color: primitive.color,
    translucent: primitive.translucent,
    vertexColors: geometry.hasAttribute("color"),
  };
  switch (primitive.mode) {
    case "triangles": {
      if (!geometry.hasAttribute("normal")) geometry.computeVertexNormals();
      const mesh = new Mesh(geometry, materials.studio(style));
      studioMaterials.set(mesh, mesh.material);
      return mesh;
    }
    case "points":
      return new Points(geometry, materials.points(style));
    case "lines":
      return new LineSegments(geometry, materials.lines(style));
    case "line-strip":
      return new Line(geometry, materials.lines(style));
  }
}

/** The dressed material of a mesh, whatever it wears at the moment. */
export function studioOf(mesh: Mesh): Material | undefined {
  return studioMaterials.get(mesh);
}

const studioMaterials = new WeakMap<Mesh, Material>();
