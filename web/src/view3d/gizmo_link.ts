// Joins the gizmos to the session: what is selected is shown, what is dragged is written as an edit.

import type { Session } from "../app/session";
import type { Json } from "../model/json";
import { gizmosOf, type Gizmo, type Vec } from "./gizmo_values";
import type { Viewer } from "./Viewer";

/** Keeps the viewer's gizmos equal to the session's selection. Answers how to stop. */
export function showGizmosOf(session: Session, viewer: Viewer): () => void {
  let before: unknown[] = [];
  const update = (): void => {
    const { document, catalogue, values, selected } = session.store.get();
    const now = [document, catalogue, values, selected];
    if (now.every((part, at) => part === before[at])) return;
    before = now;
    viewer.showGizmos(gizmosOf({ document, catalogue, values, selected }));
  };
  update();
  return session.store.subscribe(update);
}

/** Writes a dragged value the way a slider would. */
export function writeGizmo(session: Session, gizmo: Gizmo, value: Vec | number, gesture: string): void {
  const json: Json = typeof value === "number" ? value : [...value];
  if (gizmo.target.kind === "parameter") {
    session.setParameter(gizmo.target.parameter, typeof value === "number" ? value : [...value], true, gesture);
  } else {
    session.setInput(gizmo.target.node, gizmo.target.port, json, { gesture, moving: true });
  }
}
