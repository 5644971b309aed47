// Gives the parts of a model the look of the page.

import {
  type BufferGeometry,
  type Line,
  type LineBasicMaterial,
  type Material,
  Mesh,
  type MeshStandardMaterial,
  Points,
} from "three";
import type { Materials, Style } from "./materials";

/** Colors, opacity and vertex colors are the model's own; everything else is shared by all models. */
export function dress(
  object: Mesh<BufferGeometry> | Line<BufferGeometry> | Points<BufferGeometry>,
  materials: Materials,
): void {
  const style = styleOf(object.geometry, object.material);
  if (object instanceof Mesh) {
    if (!object.geometry.hasAttribute("normal")) object.geometry.computeVertexNormals();
    const material = materials.studio(style);
    object.material = material;
    object.castShadow = !style.translucent;
    studioMaterials.set(object, material);
  } else {
    object.material = object instanceof Points ? materials.points(style) : materials.lines(style);
  }
}

/** The dressed material of a mesh, whatever it wears at the moment. */
export function studioOf(mesh: Mesh): Material | undefined {
  return studioMaterials.get(mesh);
}

/** What the file says, as the loader has put it into a material that is not used any further. */
function styleOf(geometry: BufferGeometry, material: Material | Material[]): Style {
  const { color, opacity, transparent } = material as LineBasicMaterial;
  const { metalness = 0, roughness = 1 } = material as Partial<MeshStandardMaterial>;
  (material as Material).dispose();
  return {
    color: [color.r, color.g, color.b, opacity],
    translucent: transparent,
    vertexColors: geometry.hasAttribute("color"),
    metalness,
    roughness,
  };
}

const studioMaterials = new WeakMap<Mesh, Material>();
