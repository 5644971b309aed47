// Gives a decoded scene the look of the page.

import {
  LineBasicMaterial,
  Mesh,
  Points,
  PointsMaterial,
  type Material,
  type MeshStandardMaterial,
  type Object3D,
} from "three";
import type { Materials } from "./materials";

/** In pixels. */
const POINT_SIZE = 5;

/** Replaces the materials below `root`; colors, opacity and vertex colors are kept. */
export function dress(root: Object3D, materials: Materials): void {
  root.traverse((object) => {
    const drawn = object as Mesh;
    const source = drawn.material as Material | undefined;
    if (!source) return;
    const hasColors = drawn.geometry.hasAttribute("color");
    if (object instanceof Mesh) {
      if (!drawn.geometry.hasAttribute("normal")) drawn.geometry.computeVertexNormals();
      drawn.material = materials.studio(source, hasColors);
      studioMaterials.set(drawn, drawn.material);
    } else {
      const color = (source as MeshStandardMaterial).color;
      const style = { color, vertexColors: hasColors, opacity: source.opacity, transparent: source.transparent };
      drawn.material =
        object instanceof Points
          ? new PointsMaterial({ ...style, size: POINT_SIZE, sizeAttenuation: false })
          : new LineBasicMaterial(style);
    }
    source.dispose();
  });
}

/** The dressed material of a mesh, whatever it wears at the moment. */
export function studioOf(mesh: Mesh): Material | undefined {
  return studioMaterials.get(mesh);
}

const studioMaterials = new WeakMap<Mesh, Material>();
