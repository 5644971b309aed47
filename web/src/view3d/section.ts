// A plane that cuts the model open, square to an axis of the graph. It is dragged along that axis.

import { Color, Group, Plane, type Ray, Vector3 } from "three";
import { alongAxis, inScene, snapped, tidy } from "./drag";
import type { Handle } from "./handles";
import type { Materials } from "./materials";
import { remove } from "./overlays";
import { segmentGeometry, thickLines, thickMaterial } from "./thick_lines";

export type SectionAxis = "x" | "y" | "z";

export interface Section {
  axis: SectionAxis;
  /** Where the plane crosses the axis, in meters. */
  offset: number;
  /** Keeps the other half. */
  flipped: boolean;
}

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;
const LOOKS = {
  dark: { back: new Color("#f3af20"), frame: new Color("#f3af20") },
  light: { back: new Color("#e08a00"), frame: new Color("#b36b00") },
};

export class SectionPlane {
  /** What is seen of it, in the coordinates of the scene. */
  readonly group = new Group();
  readonly handle: Handle;
  private section: Section | null = null;
  private center = new Vector3();
  private radius = 1;
  private grip = 0;
  private before = 0;

  /** `onChange` hears of every drag. */
  constructor(
    private readonly materials: Materials,
    private readonly onChange: (section: Section) => void,
  ) {
    this.handle = {
      name: "Move the section plane",
      shape: "arrow",
      color: "var(--warning)",
      place: () => (this.section ? this.middle() : undefined),
      begin: (ray) => {
        this.before = this.section?.offset ?? 0;
        this.grip = this.before - (this.offsetAt(ray) ?? this.before);
      },
      move: (ray, snap) => this.drag(ray, snap),
      end: (cancelled) => cancelled && this.change(this.before),
      nudge: (x, y) => this.change((this.section?.offset ?? 0) + (x + y) * 0.02 * this.radius),
    };
  }

  /** Shows a section, or none, of a model around `center`. */
  set(section: Section | null, center: Vector3, radius: number, light: boolean): void {
    this.section = section;
    this.center.copy(center);
    this.radius = radius;
    for (const child of [...this.group.children]) remove(child);
    const look = LOOKS[light ? "light" : "dark"];
    this.materials.setFlatBacks(section && look.back);
    if (!section) {
      this.materials.setPlanes([]);
      return;
    }
    const normal = this.axis().multiplyScalar(section.flipped ? 1 : -1);
    this.materials.setPlanes([new Plane().setFromNormalAndCoplanarPoint(normal, this.middle())]);
    this.group.add(this.frame(look.frame));
  }

  /** The range that the plane is moved in. */
  get reach(): { minimum: number; maximum: number } {
    const middle = this.center.dot(this.axis());
    return { minimum: middle - this.radius, maximum: middle + this.radius };
  }

  dispose(): void {
    for (const child of [...this.group.children]) remove(child);
    this.group.removeFromParent();
  }

  private axis(): Vector3 {
    return inScene(AXES[this.section?.axis ?? "x"]);
  }

  /** The point of the plane nearest to the middle of the model. */
  private middle(): Vector3 {
    const axis = this.axis();
    return this.center.clone().addScaledVector(axis, (this.section?.offset ?? 0) - this.center.dot(axis));
  }

  private offsetAt(ray: Ray): number | undefined {
    return alongAxis(ray, new Vector3(), this.axis());
  }

  private drag(ray: Ray, snap: boolean): void {
    const offset = this.offsetAt(ray);
    if (offset !== undefined) this.change(offset + this.grip, snap ? this.radius / 20 : undefined);
  }

  private change(offset: number, step?: number): void {
    if (!this.section) return;
    const { minimum, maximum } = this.reach;
    const within = Math.min(maximum, Math.max(minimum, offset));
    const tidied = step ? snapped(within, step) : tidy(within, this.radius / 100);
    this.onChange({ ...this.section, offset: tidied });
  }

  private frame(color: Color): Group {
    const [u, v] = [new Vector3(), new Vector3()];
    const axis = this.axis();
    u.set(axis.y, axis.z, axis.x).multiplyScalar(1.05 * this.radius);
    v.set(axis.z, axis.x, axis.y).multiplyScalar(1.05 * this.radius);
    const middle = this.middle();
    const corners = [
      [1, 1],
      [-1, 1],
      [-1, -1],
      [1, -1],
    ].map(([a = 0, b = 0]) => middle.clone().addScaledVector(u, a).addScaledVector(v, b));
    const pairs = corners.flatMap((corner, at) => [
      ...corner.toArray(),
      ...(corners[(at + 1) % 4] ?? corner).toArray(),
    ]);
    const material = thickMaterial({ color, width: 1.5, opacity: 0.7 });
    return new Group().add(thickLines(segmentGeometry(pairs), material));
  }
}
