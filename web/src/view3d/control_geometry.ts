// Points, point pairs, circles and lines of the chosen nodes, drawn over the model in the colors of their types. What is
// behind the model shows through, fainter.

import {
  BufferGeometry,
  Color,
  GreaterDepth,
  Group,
  LessEqualDepth,
  Line,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Points,
  PointsMaterial,
  DoubleSide,
  type DepthModes,
  type Material,
  type Object3D,
} from "three";
import type { ControlInfo } from "../app/state";
import type { DecodedModel } from "./decode";
import { pairsOf, segmentGeometry, thickLines, thickMaterial } from "./thick_lines";

export interface ControlColors extends ControlInfo {
  light: boolean;
}

const WIDTH = 2;
const POINT_SIZE = 8;
const HIDDEN = 0.28;
const FAINT = 0.45;
const SURFACE = 0.35;

/** One drawn preview; it takes over what `model` holds and frees it. */
export class ControlGeometry {
  readonly group = new Group();
  private readonly materials: Material[] = [];
  private readonly painted: { color: Color; type: string }[] = [];

  constructor(
    private readonly model: DecodedModel,
    private readonly colors: ControlColors,
  ) {
    model.scene.updateMatrixWorld(true);
    model.scene.traverse((object) => this.add(object));
    this.group.renderOrder = 5;
  }

  /** Another theme: the same colors, taken down on light ground. */
  setLight(light: boolean): void {
    for (const { color, type } of this.painted) color.copy(shade(this.colors.ofType(type), light));
  }

  dispose(): void {
    this.group.removeFromParent();
    this.group.traverse((object) => (object as Mesh).geometry?.dispose());
    for (const material of this.materials) material.dispose();
    this.model.dispose();
  }

  private add(object: Object3D): void {
    const source = (object as Mesh).geometry as BufferGeometry | undefined;
    if (!source) return;
    const type = extra(object, "type");
    const color = shade(this.colors.ofType(type), this.colors.light);
    this.painted.push({ color, type });
    const strength = isFaint(object, this.colors.faint) ? FAINT : 1;
    for (const [depth, opacity] of [
      [LessEqualDepth, strength],
      [GreaterDepth, HIDDEN * strength],
    ] as const) {
      const drawn = this.drawn(object, source, color, opacity, depth);
      drawn.renderOrder = 5;
      drawn.matrixAutoUpdate = false;
      drawn.matrix.copy(object.matrixWorld);
      this.group.add(drawn);
    }
  }

  private drawn(object: Object3D, source: BufferGeometry, color: Color, opacity: number, depthFunc: DepthModes): Object3D {
    if (object instanceof Points) return new Points(source, this.keep(pointMaterial(color, opacity, depthFunc)));
    if (object instanceof Line) {
      const positions = source.getAttribute("position").array;
      const index = source.getIndex();
      const pairs = object instanceof LineSegments ? (index ? gathered(positions, index.array) : positions) : pairsOf(positions);
      return thickLines(segmentGeometry(pairs), this.keep(thickMaterial({ color, width: WIDTH, opacity, depthFunc })));
    }
    const material = new MeshBasicMaterial({ side: DoubleSide, transparent: true, depthWrite: false });
    material.color = color;
    material.opacity = SURFACE * opacity;
    material.depthFunc = depthFunc;
    return new Mesh(source, this.keep(material));
  }

  private keep<T extends Material>(material: T): T {
    this.materials.push(material);
    return material;
  }
}

/** Round points of one size on the screen. */
export function pointMaterial(color: Color, opacity: number, depthFunc: DepthModes): PointsMaterial {
  const material = new PointsMaterial({ size: POINT_SIZE, sizeAttenuation: false, transparent: true, opacity });
  material.color = color;
  material.depthFunc = depthFunc;
  material.depthWrite = false;
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace(
      "#include <color_fragment>",
      "#include <color_fragment>\nif (length(gl_PointCoord - 0.5) > 0.5) discard;",
    );
  };
  return material;
}

function gathered(positions: ArrayLike<number>, index: ArrayLike<number>): Float32Array {
  const pairs = new Float32Array(3 * index.length);
  for (let at = 0; at < pairs.length; at++) pairs[at] = positions[3 * (index[Math.floor(at / 3)] ?? 0) + (at % 3)] ?? 0;
  return pairs;
}

/** The word `name` in the extras of the nearest node above that has it. */
function extra(object: Object3D, name: string): string {
  for (let at: Object3D | null = object; at; at = at.parent) {
    const value: unknown = at.userData[name];
    if (typeof value === "string") return value;
  }
  return "";
}

function isFaint(object: Object3D, faint: ReadonlySet<string>): boolean {
  return faint.has(extra(object, "id"));
}

/** The types' colors are made for dark ground; on light ground they are taken down until they are seen. */
function shade(text: string, light: boolean): Color {
  const color = new Color(text);
  const bright = 0.21 * color.r + 0.72 * color.g + 0.07 * color.b;
  return light && bright > 0.18 ? color.multiplyScalar(0.18 / bright) : color;
}
