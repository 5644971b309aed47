// What the model stands on: the grid and the axes, in the size that suits the model.

import { Group, type LineSegments } from "three";
import { cellSize, makeAxes, makeGrid, type OverlayColors, remove } from "./overlays";

const COLORS: Record<"dark" | "light", OverlayColors> = {
  dark: { grid: "#454d5b", axes: ["#ff7a6b", "#7ddb8c", "#4fb4ff"] },
  light: { grid: "#a9b2c0", axes: ["#d2402f", "#1f8f3e", "#1f74d0"] },
};

export interface GroundLook {
  grid: boolean;
  axes: boolean;
  light: boolean;
}

export class Ground {
  readonly group = new Group();
  private grid: LineSegments | undefined;
  private axes: Group | undefined;

  constructor() {
    // The graph's Z axis is the picture's up direction, as the export's root node turns it.
    this.group.rotation.x = -Math.PI / 2;
  }

  /** Lays it out for a model of the given radius. */
  set(radius: number, { grid, axes, light }: GroundLook): void {
    this.clear();
    const colors = COLORS[light ? "light" : "dark"];
    const cell = cellSize(radius);
    this.grid = grid ? makeGrid(cell, colors.grid) : undefined;
    this.axes = axes ? makeAxes(2.5 * cell, colors.axes) : undefined;
    if (this.grid) this.group.add(this.grid);
    if (this.axes) this.group.add(this.axes);
  }

  clear(): void {
    remove(this.grid);
    remove(this.axes);
  }
}
