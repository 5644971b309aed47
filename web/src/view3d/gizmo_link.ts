// Joins the gizmos to the session: what is selected is shown, what is dragged is written as an edit.

import type { Json } from "../model/json";
import { prefixOf } from "../model/scope";
import { inspect } from "../net/validation";
import type { Session } from "../session/session";
import { type Anchor, anchorsOf, type Gizmo, type GizmoSource, gizmosOf, type Vec, vectorOf } from "./gizmo_values";
import type { Viewer } from "./Viewer";

/** A drag of something upstream should not ask for every step of it. */
const PAUSE_MILLISECONDS = 80;

/** Keeps the viewer's gizmos equal to the session's selection. Answers how to stop. */
export function showGizmosOf(session: Session, viewer: Viewer): () => void {
  let before: unknown[] = [];
  let wired = new Map<string, Vec>();
  let request: AbortController | undefined;
  let timer = 0;
  const source = (): GizmoSource => {
    const { document, catalogue, values, selected } = session.store.get();
    return { document, catalogue, values, selected, wired };
  };
  const show = (): void => viewer.showGizmos(gizmosOf(source()));
  const ask = async (anchors: readonly Anchor[]): Promise<void> => {
    const { document, values } = session.store.get();
    if (!document) return;
    const prefix = prefixOf(document.inside);
    const mine = new AbortController();
    request = mine;
    const found = new Map<string, Vec>();
    for (const { port, node, output } of anchors) {
      const answer = await inspect({ graph: document.json, parameters: values }, prefix + node, output, mine.signal);
      if (mine.signal.aborted) return;
      // A family is in many places; a handle is in one.
      const isSingle = answer && "values" in answer && answer.axes.length === 0;
      const place = isSingle ? vectorOf(answer.values[0]) : undefined;
      if (place) found.set(port, place);
    }
    wired = found;
    show();
  };
  const update = (): void => {
    const now = source();
    const facts = [now.document, now.catalogue, now.values, now.selected];
    if (facts.every((part, at) => part === before[at])) return;
    const anchors = anchorsOf(now);
    // The last known places stand until the new ones are here, as long as they are still wired.
    const isKept = (port: string): boolean => now.selected === before[3] && anchors.some((one) => one.port === port);
    wired = new Map([...wired].filter(([port]) => isKept(port)));
    before = facts;
    show();
    window.clearTimeout(timer);
    request?.abort();
    if (anchors.length > 0) timer = window.setTimeout(() => void ask(anchors), PAUSE_MILLISECONDS);
  };
  update();
  const stop = session.store.subscribe(update);
  return () => {
    window.clearTimeout(timer);
    request?.abort();
    stop();
  };
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
