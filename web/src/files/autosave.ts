// Writes the draft of the open document a moment after every change of its graph or its form, and at once when the page
// is left.

import type { Session, SessionState } from "../app/session";
import { documentWithValues } from "./document_file";
import type { Draft, DraftStore } from "./drafts";

const PAUSE_MILLISECONDS = 500;
const TAB_KEY = "dini.tab";

/** A word that a tab keeps over reloads. */
export function tabName(): string {
  const fresh = newId();
  try {
    const known = sessionStorage.getItem(TAB_KEY);
    if (known) return known;
    sessionStorage.setItem(TAB_KEY, fresh);
  } catch {
    // Without storage every load is a tab of its own.
  }
  return fresh;
}

export class Autosave {
  private id = newId();
  private opened = 0;
  /** The draft this document was taken up from; it goes when its successor is written. */
  private ancestor: string | undefined;
  /** What the newest draft, or the opened document, holds. */
  private written: { json?: unknown; values?: unknown } = {};
  private pending: Draft | undefined;
  private timer = 0;
  /** A draft of this document was written, or will be. */
  private isKept = false;

  constructor(
    private readonly session: Session,
    private readonly store: DraftStore,
    private readonly tab: string,
  ) {
    session.store.subscribe(() => this.look());
    document.addEventListener("visibilitychange", () => void (document.hidden && this.flush()));
    window.addEventListener("pagehide", () => this.flush());
  }

  /** The open document is saved: its draft is not needed any more. */
  async saved(): Promise<void> {
    window.clearTimeout(this.timer);
    this.pending = undefined;
    for (const id of [this.id, this.ancestor]) if (id) await this.store.remove(id).catch(() => undefined);
    this.ancestor = undefined;
    this.isKept = false;
  }

  private look(): void {
    const state = this.session.store.get();
    const { opened, origin, document, values } = state;
    if (opened !== this.opened) {
      // The last document's draft is written before another one takes its place.
      this.flush();
      this.opened = opened;
      this.id = newId();
      this.isKept = false;
      this.ancestor = origin.kind === "draft" ? origin.id : undefined;
      this.written = { json: document?.json, values };
    }
    if (!document || (document.json === this.written.json && values === this.written.values)) return;
    const need = draftNeed(state, this.isKept);
    if (need === "nothing") return;
    this.written = { json: document.json, values };
    window.clearTimeout(this.timer);
    if (need === "remove") {
      this.pending = undefined;
      this.isKept = false;
      void this.store.remove(this.id).catch(() => undefined);
      return;
    }
    this.isKept = true;
    this.pending = this.draft();
    this.timer = window.setTimeout(() => this.flush(), PAUSE_MILLISECONDS);
  }

  private flush(): void {
    window.clearTimeout(this.timer);
    const { pending, ancestor } = this;
    if (!pending) return;
    this.pending = undefined;
    // A browser that keeps nothing, or is full, is no reason to disturb the work.
    void this.store
      .put(pending)
      .then(() => (ancestor ? this.store.remove(ancestor) : undefined))
      .catch(() => undefined);
    this.ancestor = undefined;
  }

  private draft(): Draft | undefined {
    const { document, values, origin, isChanged } = this.session.store.get();
    if (!document) return undefined;
    return {
      id: this.id,
      tab: this.tab,
      title: document.title,
      name: origin.kind === "file" ? origin.name : "",
      address: location.hash,
      time: Date.now(),
      isAdjustment: !isChanged && origin.kind === "example",
      json: documentWithValues(document, values),
    };
  }
}

/**
 * What is to be done for a document that changed, with or without a draft of it so far. What is again as it was opened or
 * saved needs no draft; taken up from a draft, it is still saved nowhere else.
 */
export function draftNeed(
  { isChanged, isAdjusted, origin }: Pick<SessionState, "isChanged" | "isAdjusted" | "origin">,
  isKept: boolean,
): "write" | "remove" | "nothing" {
  if (isChanged || isAdjusted) return "write";
  if (!isKept) return "nothing";
  return origin.kind === "draft" ? "write" : "remove";
}

function newId(): string {
  return [...crypto.getRandomValues(new Uint8Array(9))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
