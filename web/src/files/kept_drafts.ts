// Drafts that are not lost while the page is open: what the browser does not store is held here, and said.

import { createStore, type Store } from "../model/store";
import type { Draft, DraftStore } from "./drafts";

/** A database that says nothing for so long keeps nothing. */
const LONGEST_MILLISECONDS = 4000;

/** Drafts that only this page has, and why, as the end of a sentence. */
export interface Held {
  drafts: readonly Draft[];
  reason: string;
}

export class KeptDrafts {
  readonly held: Store<Held> = createStore<Held>({ drafts: [], reason: "" });
  /** The browser has stored a draft since the page was opened, and has not refused one since. */
  isTrusted = false;
  /** The newest draft of each id that is wanted, by its time. */
  private readonly wanted = new Map<string, number>();

  constructor(private readonly store: DraftStore) {}

  /** Keeps a draft in place of an older one of the same id. Never rejects; answers whether the browser stored it. */
  async put(draft: Draft): Promise<boolean> {
    this.wanted.set(draft.id, draft.time);
    const timer = setTimeout(() => this.hold(draft, "its storage does not answer"), LONGEST_MILLISECONDS);
    try {
      await this.store.put(draft);
    } catch (error) {
      this.hold(draft, reasonOf(error));
      return false;
    } finally {
      clearTimeout(timer);
    }
    this.isTrusted = true;
    this.release(draft.id, draft.time);
    await this.storeHeld();
    return true;
  }

  /** Never rejects. */
  async remove(id: string): Promise<void> {
    this.wanted.delete(id);
    this.release(id);
    await this.store.remove(id).catch(() => undefined);
  }

  /** All of them, newest first; those that only this page has, where the browser tells of none. */
  async list(): Promise<Draft[]> {
    const late = new Promise<Draft[]>((resolve) => setTimeout(() => resolve([]), LONGEST_MILLISECONDS));
    const stored = await Promise.race([this.store.list().catch((): Draft[] => []), late]);
    const { drafts } = this.held.get();
    const others = stored.filter((one) => !drafts.some(({ id }) => id === one.id));
    return [...drafts, ...others].sort((a, b) => b.time - a.time);
  }

  private hold(draft: Draft, reason: string): void {
    if (this.wanted.get(draft.id) !== draft.time) return;
    this.isTrusted = false;
    const others = this.held.get().drafts.filter(({ id }) => id !== draft.id);
    this.held.set({ drafts: [...others, draft], reason });
  }

  /** What is held of a draft, up to the given time, is not needed any more. */
  private release(id: string, time = Infinity): void {
    const { drafts } = this.held.get();
    const left = drafts.filter((one) => one.id !== id || one.time > time);
    if (left.length < drafts.length) this.held.set({ drafts: left });
  }

  /** There is room again: older drafts follow. */
  private async storeHeld(): Promise<void> {
    for (const draft of this.held.get().drafts) {
      try {
        await this.store.put(draft);
      } catch {
        return;
      }
      this.release(draft.id, draft.time);
    }
  }
}

function reasonOf(error: unknown): string {
  const name = error instanceof Error || error instanceof DOMException ? error.name : "";
  if (name === "QuotaExceededError") return "its storage is full";
  return name === "SecurityError" ? "it does not allow storage" : "its storage fails";
}
