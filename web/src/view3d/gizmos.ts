// The gizmos of the selected node.

import { Group } from "three";
import type { Gizmo } from "./gizmo_values";
import { type GizmoHost, GizmoView } from "./gizmo_view";
import type { Handle } from "./handles";

export type { GizmoHost };

export class GizmoLayer {
  readonly group = new Group();
  private views = new Map<string, GizmoView>();

  constructor(private readonly host: GizmoHost) {}

  get handles(): Handle[] {
    return [...this.views.values()].flatMap((view) => view.handles);
  }

  /** Replaces the gizmos. One that is still there goes on, so that its drag does. */
  set(gizmos: readonly Gizmo[]): void {
    const next = new Map<string, GizmoView>();
    for (const gizmo of gizmos) {
      const key = `${gizmo.kind} ${gizmo.key}`;
      const view = this.views.get(key) ?? new GizmoView(gizmo, this.host);
      view.gizmo = gizmo;
      next.set(key, view);
      this.group.add(view.group);
    }
    for (const [key, view] of this.views) if (!next.has(key)) view.dispose();
    this.views = next;
  }

  /** Fits sizes to the camera; to be called before drawing. */
  update(): void {
    for (const view of this.views.values()) view.update();
  }

  dispose(): void {
    this.set([]);
    this.group.removeFromParent();
  }
}
