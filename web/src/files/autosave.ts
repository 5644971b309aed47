// Writes the draft of the open document a moment after every change of its graph or its form, and at once when the page
// is left.

import { documentWithValues } from "../model/saved_values";
import type { Session } from "../session/session";
import type { SessionState } from "../session/state";
import { type Draft, storedPlace } from "./drafts";
import type { KeptDrafts } from "./kept_drafts";
import { newId, rememberOpen } from "./tab";

const PAUSE_MILLISECONDS = 500;

export class Autosave {
  private id = newId();
  private opened = 0;
  /** The draft this document was taken up from; it goes when its successor is written. */
  private ancestor: string | undefined;
  /** What the newest draft, or the opened document, holds. */
  private written: { json?: unknown; values?: unknown } = {};
  private pending: Draft | undefined;
  private timer = 0;
  /** How many drafts are on their way to the browser. */
  private writing = 0;
  /** A draft of this document was written, or will be. */
  private isKept = false;
  /** The newest draft that was written of the open document. */
  private newest: Draft | undefined;

  /** `left` is told when another document takes the place of one that was not saved. */
  constructor(
    private readonly session: Session,
    private readonly drafts: KeptDrafts,
    private readonly tab: string,
    private readonly left: (draft: Draft) => void,
  ) {
    session.store.subscribe(() => this.look());
    document.addEventListener("visibilitychange", () => void (document.hidden && this.flush()));
    window.addEventListener("pagehide", () => {
      this.flush();
      rememberOpen(session, this.unsaved());
    });
    window.addEventListener("beforeunload", (event) => {
      if (this.isAtRisk()) event.preventDefault();
    });
  }

  /** The open document is saved: its draft is not needed any more. */
  saved(): void {
    window.clearTimeout(this.timer);
    this.pending = undefined;
    for (const id of [this.id, this.ancestor]) if (id) void this.drafts.remove(id);
    this.ancestor = undefined;
    this.isKept = false;
    this.newest = undefined;
  }

  /** The draft is of the document that is open. */
  isOpen(draft: Draft): boolean {
    return draft.id === this.id;
  }

  /**
   * Something would be lost with the page. What is only on its way counts as long as the browser has not shown that it
   * keeps drafts.
   */
  private isAtRisk(): boolean {
    this.flush();
    return this.drafts.held.get().drafts.length > 0 || (this.writing > 0 && !this.drafts.isTrusted);
  }

  /** The draft of what is open, if that was not saved; of one that was taken up and not changed, the same again. */
  private unsaved(): Draft | undefined {
    if (draftNeed(this.session.store.get(), true) !== "write") return undefined;
    const draft = this.draft();
    if (!draft || this.ancestor === undefined) return draft;
    return this.isKept ? { ...draft, ancestor: this.ancestor } : { ...draft, id: this.ancestor };
  }

  private look(): void {
    const state = this.session.store.get();
    const { opened, origin, document, values } = state;
    if (opened !== this.opened) {
      // The last document's draft is written before another one takes its place.
      this.flush();
      if (this.isKept && this.newest) this.left(this.newest);
      this.newest = undefined;
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
      void this.drafts.remove(this.id);
      return;
    }
    this.isKept = true;
    this.pending = this.draft();
    this.newest = this.pending;
    this.timer = window.setTimeout(() => this.flush(), PAUSE_MILLISECONDS);
  }

  private flush(): void {
    window.clearTimeout(this.timer);
    const { pending, ancestor } = this;
    if (!pending) return;
    this.pending = undefined;
    this.writing++;
    void this.drafts.put(pending).then((isStored) => {
      this.writing--;
      if (!isStored || ancestor === undefined) return;
      void this.drafts.remove(ancestor);
      if (this.ancestor === ancestor) this.ancestor = undefined;
    });
  }

  private draft(): Draft | undefined {
    const { document, values, origin, isChanged } = this.session.store.get();
    if (!document) return undefined;
    return {
      id: this.id,
      tab: this.tab,
      title: document.title,
      name: origin.kind === "file" ? origin.name : "",
      stored: storedPlace(origin),
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
