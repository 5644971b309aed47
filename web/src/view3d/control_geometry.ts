// Points, point pairs, circles and lines of the chosen nodes, drawn over the model in the colors of their types. What is
// behind the model shows through, fainter.

import { type BufferGeometry, Group, Line, LineSegments, Mesh, type Object3D, Points, Vector3 } from "three";
import type { ControlInfo } from "../session/state";
import type { ControlMaterials } from "./control_materials";
import type { DecodedModel } from "./decode";
import { segmentGeometry, thickLines } from "./thick_lines";

const OVER_MODEL = 5;

/** One drawn preview; it takes over what `model` holds and frees it. */
export class ControlGeometry {
  readonly group = new Group();

  constructor(
    private readonly model: DecodedModel,
    info: ControlInfo,
    materials: ControlMaterials,
  ) {
    model.scene.updateMatrixWorld(true);
    // All lines of a look are one drawing: a family may have hundreds.
    const lines = new Map<string, { color: string; isFaint: boolean; pairs: number[] }>();
    model.scene.traverse((object) => {
      const geometry = (object as Mesh).geometry as BufferGeometry | undefined;
      if (!geometry) return;
      const color = info.ofType(extra(object, "type"));
      const isFaint = info.faint.has(extra(object, "id"));
      if (object instanceof Line) {
        const key = `${color} ${isFaint}`;
        const entry = lines.get(key) ?? { color, isFaint, pairs: [] };
        lines.set(key, entry);
        addPairs(entry.pairs, object);
        return;
      }
      const kind = object instanceof Points ? "points" : "faces";
      for (const material of materials.pair(kind, color, isFaint)) {
        const drawn = kind === "points" ? new Points(geometry, material) : new Mesh(geometry, material);
        drawn.matrixAutoUpdate = false;
        drawn.matrix.copy(object.matrixWorld);
        this.add(drawn);
      }
    });
    for (const { color, isFaint, pairs } of lines.values()) {
      const geometry = segmentGeometry(pairs);
      for (const material of materials.pair("lines", color, isFaint)) this.add(thickLines(geometry, material));
    }
  }

  /** What it was made of, with every place in it. */
  get source(): Object3D {
    return this.model.scene;
  }

  dispose(): void {
    this.group.removeFromParent();
    this.group.traverse((object) => (object as Mesh).geometry?.dispose());
    this.model.dispose();
  }

  private add(object: Object3D): void {
    object.renderOrder = OVER_MODEL;
    this.group.add(object);
  }
}

/** The segments of a line, strip or list, in the coordinates of the scene. */
function addPairs(pairs: number[], line: Line): void {
  const position = line.geometry.getAttribute("position");
  const index = line.geometry.getIndex();
  const count = index?.count ?? position.count;
  const step = line instanceof LineSegments ? 2 : 1;
  const point = new Vector3();
  for (let at = 0; at + 1 < count; at += step) {
    for (const corner of [at, at + 1]) {
      point.fromBufferAttribute(position, index ? index.getX(corner) : corner).applyMatrix4(line.matrixWorld);
      pairs.push(point.x, point.y, point.z);
    }
  }
}

/** The word `name` in the extras of the nearest node above that has it. */
function extra(object: Object3D, name: string): string {
  for (let at: Object3D | null = object; at; at = at.parent) {
    const value: unknown = at.userData[name];
    if (typeof value === "string") return value;
  }
  return "";
}
