// The materials of control geometry, shared and kept: a shader whose last material goes is compiled again for the next
// drawing, which takes longer than drawing it.

import {
  Color,
  type DepthModes,
  DoubleSide,
  GreaterDepth,
  LessEqualDepth,
  type Material,
  MeshBasicMaterial,
  PointsMaterial,
} from "three";
import { thickMaterial } from "./thick_lines";

export type ControlKind = "lines" | "points" | "faces";

const WIDTH = 2;
const POINT_SIZE = 8;
/** Strength of what is behind the model, of what is only taken, and of surfaces. */
const HIDDEN = 0.28;
const FAINT = 0.45;
const FACES = 0.35;

export class ControlMaterials {
  private readonly kept = new Map<string, Material>();
  private readonly colors = new Map<string, Color>();
  private light = false;

  /** The two materials of a drawing: before the model, and behind it. */
  pair(kind: ControlKind, color: string, isFaint: boolean): [Material, Material] {
    const strength = (isFaint ? FAINT : 1) * (kind === "faces" ? FACES : 1);
    return [this.one(kind, color, strength, LessEqualDepth), this.one(kind, color, strength * HIDDEN, GreaterDepth)];
  }

  /** The colors are made for dark ground; on light ground they are taken down until they are seen. */
  setLight(light: boolean): void {
    this.light = light;
    for (const [text, color] of this.colors) this.shade(color, text);
  }

  dispose(): void {
    for (const material of this.kept.values()) material.dispose();
    this.kept.clear();
  }

  private one(kind: ControlKind, text: string, opacity: number, depthFunc: DepthModes): Material {
    const key = `${kind} ${text} ${opacity} ${depthFunc}`;
    let material = this.kept.get(key);
    if (!material) {
      material = this.make(kind, this.color(text), opacity, depthFunc);
      this.kept.set(key, material);
    }
    return material;
  }

  private make(kind: ControlKind, color: Color, opacity: number, depthFunc: DepthModes): Material {
    if (kind === "lines") return thickMaterial({ color, width: WIDTH, opacity, depthFunc });
    const common = { transparent: true, opacity, depthWrite: false, depthFunc };
    if (kind === "points") {
      const material = new PointsMaterial({ ...common, size: POINT_SIZE, sizeAttenuation: false });
      material.color = color;
      material.onBeforeCompile = (shader) => {
        shader.fragmentShader = shader.fragmentShader.replace(
          "#include <color_fragment>",
          "#include <color_fragment>\nif (length(gl_PointCoord - 0.5) > 0.5) discard;",
        );
      };
      return material;
    }
    const material = new MeshBasicMaterial({ ...common, side: DoubleSide });
    material.color = color;
    return material;
  }

  private color(text: string): Color {
    let color = this.colors.get(text);
    if (!color) {
      color = this.shade(new Color(), text);
      this.colors.set(text, color);
    }
    return color;
  }

  private shade(color: Color, text: string): Color {
    color.set(text);
    const bright = 0.21 * color.r + 0.72 * color.g + 0.07 * color.b;
    return this.light && bright > 0.18 ? color.multiplyScalar(0.18 / bright) : color;
  }
}
