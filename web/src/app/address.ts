// The page's address names the open example; the page's root element tells tests what is going on.

import type { Store } from "../model/store";
import type { Session } from "../session/session";
import type { SessionState } from "../session/state";

/** The example named in "#example=...", or null. */
export function exampleInAddress(): string | null {
  return new URLSearchParams(location.hash.slice(1)).get("example");
}

/** True for "?view=picture": the model alone on a plain ground, drawn smoothly, as the pictures of the examples are made. */
export function wantsPicture(): boolean {
  return new URLSearchParams(location.search).get("view") === "picture";
}

/** Keeps address and open example equal, both ways. */
export function keepAddress(session: Session): void {
  let written: string | null = null;
  session.store.subscribe(() => {
    const { exampleId, document: open, origin, isChanged, isAdjusted } = session.store.get();
    if (exampleId === null && open) {
      // A link holds what is open until that is changed. Whatever else the address names is not what is open.
      const isLink = origin.kind === "shared" && !isChanged && !isAdjusted && location.hash.startsWith("#g=");
      if (location.hash && !isLink) history.replaceState(null, "", location.pathname + location.search);
      written = "";
      document.title = `${open.title} · Dini`;
      return;
    }
    if (exampleId === written || exampleId === null) return;
    const first = written === null;
    written = exampleId;
    if (open) document.title = `${open.title} · Dini`;
    const wanted = exampleInAddress();
    // The example a person did not ask for stays out of the address.
    if (wanted !== exampleId && !(first && wanted === null)) location.hash = `example=${encodeURIComponent(exampleId)}`;
  });
  window.addEventListener("hashchange", () => {
    const wanted = exampleInAddress();
    if (wanted !== null) session.openExample(wanted);
    // A link with a graph, pasted into the address of an open page, begins like a new one.
    else if (location.hash.startsWith("#g=")) location.reload();
  });
}

/** Writes data-state, data-example, data-revision, data-shown and data-quality, so that tests wait for facts and not for time. */
export function showStateOn(element: HTMLElement, store: Store<SessionState>): void {
  const write = (): void => {
    const { busy, away, problem, revision, shown, exampleId } = store.get();
    const state = away || (problem && !busy) ? "error" : busy ? "busy" : "idle";
    const facts = {
      state,
      example: exampleId ?? "",
      revision: String(revision),
      shown: String(shown?.revision ?? 0),
      quality: shown?.quality ?? "",
    };
    for (const [name, value] of Object.entries(facts)) {
      if (element.dataset[name] !== value) element.dataset[name] = value;
    }
  };
  write();
  store.subscribe(write);
}
