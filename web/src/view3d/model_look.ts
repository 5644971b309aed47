// How the surfaces of the model are drawn: the chosen mode, with lines and colors made for it.

import { BufferAttribute, type BufferGeometry, LineBasicMaterial, LineSegments, type Material, type Mesh } from "three";
import { type CurvatureKind, curvatureColors, curvatureRange, estimateCurvature, smoothed } from "./curvature";
import type { DecodedModel } from "./decode";
import { paintDeviation } from "./deviation";
import { studioOf } from "./dress";
import type { Materials } from "./materials";
import { latticeOf, wireGeometry } from "./wireframe";

export type ShadingMode = "shaded" | "shaded-wire" | "wire" | "normals" | "by-curvature";

/** What a legend says of the drawn curvature. */
export interface CurvatureScale {
  kind: CurvatureKind;
  /** At the ends of the palette. */
  range: number;
  /** From the mesh, because the server sent none. */
  isEstimate: boolean;
}

export interface Look {
  mode: ShadingMode;
  curvatureKind: CurvatureKind;
  light: boolean;
}

const WIRE = {
  dark: { over: "#0d1017", sole: "#9db6ff" },
  light: { over: "#1b2540", sole: "#3450a8" },
};

export class ModelLook {
  private readonly wire = new LineBasicMaterial({ transparent: true });
  private wires: LineSegments[] = [];

  constructor(private readonly materials: Materials) {
    this.wire.clippingPlanes = materials.planes;
  }

  /** Dresses the model for the mode. Answers the scale of the colors if there is one. */
  apply(model: DecodedModel, look: Look): CurvatureScale | null {
    this.clear();
    const { mode, light } = look;
    const colors = WIRE[light ? "light" : "dark"];
    this.wire.color.set(mode === "wire" ? colors.sole : colors.over);
    this.wire.opacity = mode === "wire" ? 0.8 : 0.42;
    const hasLines = mode === "wire" || mode === "shaded-wire";
    const lattice = hasLines ? latticeOf(model.meshes.map((mesh) => mesh.geometry)) : undefined;
    for (const mesh of model.meshes) {
      mesh.material = this.materialFor(mesh, mode);
      mesh.visible = true;
      if (!lattice) continue;
      const lines = new LineSegments(wireGeometry(mesh.geometry, lattice), this.wire);
      mesh.parent?.add(lines);
      mesh.visible = mode !== "wire";
      this.wires.push(lines);
    }
    return mode === "by-curvature" ? this.paint(model.meshes, look.curvatureKind) : null;
  }

  /** Colors the model by its distance to another one. Answers the largest; undefined where there are no surfaces. */
  applyDeviation(model: DecodedModel, other: DecodedModel): number | undefined {
    const largest = paintDeviation(model, other);
    if (largest === undefined) return undefined;
    for (const mesh of model.meshes) mesh.material = this.materials.painted;
    return largest;
  }

  /** Takes the lines of the last model away. */
  clear(): void {
    for (const lines of this.wires) {
      lines.removeFromParent();
      lines.geometry.dispose();
    }
    this.wires = [];
  }

  dispose(): void {
    this.clear();
    this.wire.dispose();
  }

  private materialFor(mesh: Mesh, mode: ShadingMode): Material {
    if (mode === "normals") return this.materials.normals;
    if (mode === "by-curvature") return this.materials.painted;
    return studioOf(mesh) ?? this.materials.normals;
  }

  private paint(meshes: readonly Mesh[], kind: CurvatureKind): CurvatureScale {
    const values = meshes.map(({ geometry }) => curvatureOf(geometry, kind));
    const range = curvatureRange(values.map((one) => one.list));
    meshes.forEach(({ geometry }, at) => {
      const colors = curvatureColors(values[at]?.list ?? [], range);
      // A name of its own: the model's colors are wanted again in other modes.
      geometry.setAttribute("paint", new BufferAttribute(colors, 3, true));
    });
    return { kind, range, isEstimate: values.some((one) => one.isEstimate) };
  }
}

function curvatureOf(geometry: BufferGeometry, kind: CurvatureKind): { list: ArrayLike<number>; isEstimate: boolean } {
  // Attributes of our own keep their names in the file, in small letters.
  const sent = geometry.getAttribute(`_${kind}`);
  if (sent) return { list: sent.array, isEstimate: false };
  const [position, normal, index] = [
    geometry.getAttribute("position"),
    geometry.getAttribute("normal"),
    geometry.getIndex(),
  ];
  const indices = index?.array ?? [];
  const list = smoothed(estimateCurvature(kind, position.array, normal.array, indices), indices);
  return { list, isEstimate: true };
}
