// What the page asks of the 3D view, and what the view tells the page.

import type { GizmoHost } from "./gizmo_view";
import type { OutOfView } from "./in_view";
import type { CurvatureScale, Look } from "./model_look";
import type { Section } from "./section";

export interface ViewSettings extends Look {
  grid: boolean;
  axes: boolean;
  control: boolean;
  orthographic: boolean;
  section: Section | null;
}

/** What the view tells the page. */
export interface ViewerHost {
  section(section: Section): void;
  outOfView(how: OutOfView): void;
  scale(scale: CurvatureScale | null): void;
  /** The largest distance to the model that is compared, where the colors show it. */
  deviation(largest: number | undefined): void;
  write: GizmoHost["write"];
  end: GizmoHost["end"];
}

/** Until the page has said otherwise. */
export const PLAIN: ViewSettings = {
  ...{ mode: "shaded", curvatureKind: "gauss", light: false },
  ...{ grid: true, axes: true, control: true, orthographic: false, section: null },
};
