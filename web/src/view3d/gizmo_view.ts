// One gizmo: its lines in the scene, and the handles over them.

import { Color, Group, type Mesh, type Object3D, Quaternion, type Ray, type ShaderMaterial, Vector3 } from "three";
import { inScene } from "./drag";
import { AXES, axisDrag, type DragView, planeDrag, radiusDrag, sum, tipDrag } from "./gizmo_drags";
import type { Gizmo, Vec } from "./gizmo_values";
import type { Handle } from "./handles";
import { pairsOf, segmentGeometry, thickLines, thickMaterial } from "./thick_lines";

export interface GizmoHost extends DragView {
  /** Length in the scene of a pixel there. */
  pixelSize(place: Vector3): number;
  /** The camera's right hand. */
  right(): Vector3;
  write(gizmo: Gizmo, value: Vec | number, gesture: string): void;
  /** The drag is over; a cancelled one is to leave no trace. */
  end(gizmo: Gizmo, gesture: string, cancelled: boolean): void;
}

const AXIS_COLORS = ["#ff6b5c", "#66d17a", "#4fa8ff"] as const;
const ACCENT = "#2fc2ff";
const ARM_PIXELS = 74;
const SQUARE_PIXELS = 33;
const RING_SEGMENTS = 128;
/** Cosine of the angle to the eye beyond which an axis is too short on the screen to be dragged. */
const TOWARDS_EYE = 0.97;

let gestures = 0;

export class GizmoView {
  readonly group = new Group();
  readonly handles: Handle[];
  private readonly lines: Mesh[] = [];
  private dot: Vector3 | undefined;

  constructor(
    public gizmo: Gizmo,
    private readonly host: GizmoHost,
  ) {
    this.handles = gizmo.kind === "position" ? this.position() : gizmo.kind === "radius" ? this.radius() : this.arrow();
  }

  update(): void {
    const { gizmo, host } = this;
    const place = inScene(gizmo.kind === "position" ? gizmo.value : gizmo.at);
    this.group.position.copy(place);
    if (gizmo.kind === "position") this.group.scale.setScalar(host.pixelSize(place) * ARM_PIXELS);
    else if (gizmo.kind === "radius") orient(this.group, inScene(gizmo.normal), gizmo.value);
    else orient(this.group, inScene(gizmo.value), Math.hypot(...gizmo.value));
    if (gizmo.kind !== "position") return;
    this.lines.forEach((line, axis) => {
      line.visible = !this.isTowardsEye(axis);
    });
  }

  dispose(): void {
    this.group.removeFromParent();
    for (const line of this.lines) {
      line.geometry.dispose();
      (line.material as ShaderMaterial).dispose();
    }
  }

  private position(): Handle[] {
    const { label } = this.gizmo;
    for (const [at, axis] of AXES.entries()) {
      this.line(pairsOf([0, 0, 0, ...inScene(axis).toArray()]), AXIS_COLORS[at] ?? ACCENT);
    }
    const arms = AXES.map((axis, at) =>
      this.vectorHandle({
        name: `Move ${label} along ${"XYZ"[at]}`,
        shape: "arrow",
        color: AXIS_COLORS[at] ?? ACCENT,
        place: () => (this.isTowardsEye(at) ? undefined : this.beside(axis, ARM_PIXELS)),
        drag: axisDrag(this.host, at, this.vector),
        step: (x, y) => scaled(axis, x + y),
      }),
    );
    const squares = AXES.map((axis, at) => {
      const [u = axis, v = axis] = AXES.filter((one) => one !== axis);
      const letters = [0, 1, 2].filter((one) => one !== at).map((one) => "XYZ"[one]);
      return this.vectorHandle({
        name: `Move ${label} in the plane ${letters.join("")}`,
        shape: "square",
        color: AXIS_COLORS[at] ?? ACCENT,
        place: () => (this.isEdgeOn(at) ? undefined : this.beside(sum(u, v, 1), SQUARE_PIXELS)),
        drag: planeDrag(this.host, at, this.vector),
        step: (x, y) => sum(scaled(u, x), v, y),
      });
    });
    const ball = this.vectorHandle({
      name: `Move ${label}`,
      shape: "ball",
      color: ACCENT,
      place: () => inScene(this.vector()),
      drag: planeDrag(this.host, undefined, this.vector),
      step: (x, y) => [x, y, 0],
    });
    return [...squares, ...arms, ball];
  }

  private arrow(): Handle[] {
    this.line([0, 0, 0, 0, 0, 1], ACCENT);
    return [
      this.vectorHandle({
        name: `Turn ${this.gizmo.label}`,
        shape: "tip",
        color: ACCENT,
        place: () => inScene(sum(this.foot(), this.vector(), 1)),
        drag: tipDrag(this.host, this.foot, this.vector),
        step: (x, y) => [x, y, 0],
      }),
    ];
  }

  private radius(): Handle[] {
    const turn = Array.from({ length: RING_SEGMENTS + 1 }, (_, at) => (2 * Math.PI * at) / RING_SEGMENTS);
    this.line(pairsOf(turn.flatMap((angle) => [Math.cos(angle), Math.sin(angle), 0])), ACCENT);
    const normal = (): Vec => (this.gizmo.kind === "radius" ? this.gizmo.normal : [0, 0, 1]);
    const size = (): number => (this.gizmo.kind === "radius" ? this.gizmo.value : 1);
    const drag = radiusDrag(this.host, this.foot, normal);
    let move: ReturnType<typeof drag> | undefined;
    const written = this.writer();
    return [
      {
        name: `Change ${this.gizmo.label}`,
        shape: "dot",
        color: ACCENT,
        place: () => inScene(this.foot()).addScaledVector(this.outward(inScene(normal())), size()),
        begin: (ray) => {
          this.dot = this.outward(inScene(normal()));
          move = drag(ray);
          written.begin();
        },
        move: (ray, snap) => written.write(move?.(ray, snap)),
        end: (cancelled) => {
          this.dot = undefined;
          written.end(cancelled);
        },
        nudge: (x, y) => written.write(Math.max(this.host.cell() / 100, size() + ((x + y) * this.host.cell()) / 10)),
      },
    ];
  }

  private vectorHandle(parts: {
    name: string;
    shape: Handle["shape"];
    color: string;
    place(): Vector3 | undefined;
    drag: (first: Ray) => (ray: Ray, snap: boolean) => Vec | undefined;
    step(x: number, y: number): Vec;
  }): Handle {
    const { name, shape, color, place } = parts;
    let move: ReturnType<typeof parts.drag> | undefined;
    const written = this.writer();
    return {
      ...{ name, shape, color, place },
      begin: (ray) => {
        move = parts.drag(ray);
        written.begin();
      },
      move: (ray, snap) => written.write(move?.(ray, snap)),
      end: (cancelled) => written.end(cancelled),
      nudge: (x, y) => {
        const cell = this.host.cell();
        written.write(
          sum(this.vector(), parts.step(x, y), cell / 10).map((part) => rounded(part, cell)) as unknown as Vec,
        );
      },
    };
  }

  /** One drag is one gesture. */
  private writer() {
    let gesture = "";
    return {
      begin: () => (gesture = `gizmo ${this.gizmo.key} ${++gestures}`),
      write: (value: Vec | number | undefined) => {
        if (value !== undefined) this.host.write(this.gizmo, value, gesture || `gizmo ${this.gizmo.key}`);
      },
      end: (cancelled: boolean) => this.host.end(this.gizmo, gesture, cancelled),
    };
  }

  private readonly vector = (): Vec => (typeof this.gizmo.value === "number" ? [0, 0, 0] : this.gizmo.value);
  private readonly foot = (): Vec => (this.gizmo.kind === "position" ? this.gizmo.value : this.gizmo.at);

  private line(pairs: ArrayLike<number>, color: string): void {
    const material = thickMaterial({ color: new Color(color), width: 2.5, opacity: 1, depthTest: false });
    const line = thickLines(segmentGeometry(pairs), material);
    line.renderOrder = 20;
    this.lines.push(line);
    this.group.add(line);
  }

  private beside(offset: Vec, pixels: number): Vector3 {
    const place = inScene(this.vector());
    return place.clone().addScaledVector(inScene(offset), this.host.pixelSize(place) * pixels);
  }

  private isTowardsEye(axis: number): boolean {
    return Math.abs(this.host.direction().dot(inScene(AXES[axis] ?? [1, 0, 0]))) > TOWARDS_EYE;
  }

  private isEdgeOn(axis: number): boolean {
    return Math.abs(this.host.direction().dot(inScene(AXES[axis] ?? [1, 0, 0]))) < 0.25;
  }

  /** The way from the ring's center to its handle: to the right on the screen, as far as the ring's plane allows. */
  private outward(normal: Vector3): Vector3 {
    if (this.dot) return this.dot;
    const unit = normal.clone().normalize();
    const right = this.host.right();
    const flat = right.addScaledVector(unit, -right.dot(unit));
    return flat.lengthSq() > 1e-6 ? flat.normalize() : new Vector3(unit.y, unit.z, unit.x).cross(unit).normalize();
  }
}

/** Turns and scales what is drawn along Z with size 1. */
function orient(object: Object3D, direction: Vector3, size: number): void {
  object.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), direction.clone().normalize()));
  object.scale.setScalar(size);
}

function scaled(a: Vec, factor: number): Vec {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

function rounded(value: number, cell: number): number {
  return Number(value.toFixed(Math.min(12, Math.max(0, Math.ceil(-Math.log10(cell)) + 3)))) + 0;
}
