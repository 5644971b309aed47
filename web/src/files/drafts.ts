// Drafts: what was edited and not saved, kept by the browser. They never touch a saved file.

import type { JsonObject } from "../model/json";

export interface Draft {
  id: string;
  /** The tab that wrote it: the one that takes it up again after a reload. */
  tab: string;
  title: string;
  /** Name of the file it began as; empty if it was none. */
  name: string;
  /** The page's address when it was written, behind the "#". */
  address: string;
  /** Milliseconds since 1970. */
  time: number;
  /** Only values of an example's form were changed. */
  isAdjustment?: boolean;
  json: JsonObject;
}

export const MOST_DRAFTS = 10;
/** Going through the examples with a hand on their sliders must not push out work. */
export const MOST_ADJUSTMENTS = 3;

/** Keeps drafts; in the browser's database, or in memory where there is none. */
export interface DraftStore {
  put(draft: Draft): Promise<void>;
  remove(id: string): Promise<void>;
  /** All of them, newest first. */
  list(): Promise<Draft[]>;
}

/** Those beyond the newest ten, and beyond the newest three of which only an example's form was changed. */
export function surplus(drafts: readonly Draft[]): Draft[] {
  const sorted = [...drafts].sort((a, b) => b.time - a.time);
  const light = sorted.filter((draft) => draft.isAdjustment).slice(MOST_ADJUSTMENTS);
  return [...light, ...sorted.filter((draft) => !light.includes(draft)).slice(MOST_DRAFTS)];
}

const STORE = "drafts";

export function openDraftStore(): DraftStore {
  let database: Promise<IDBDatabase> | undefined;
  const open = (): Promise<IDBDatabase> => {
    database ??= new Promise((resolve, reject) => {
      const request = indexedDB.open("dini", 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: "id" });
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error ?? new Error("no database"));
    });
    return database;
  };
  const run = async <T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> => {
    const transaction = (await open()).transaction(STORE, mode);
    const request = work(transaction.objectStore(STORE));
    return new Promise((resolve, reject) => {
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = transaction.onerror = () => reject(transaction.error ?? new Error("not stored"));
    });
  };
  const list = async (): Promise<Draft[]> => {
    const all = (await run("readonly", (store) => store.getAll() as IDBRequest<Draft[]>)) ?? [];
    return all.sort((a, b) => b.time - a.time);
  };
  const remove = async (id: string): Promise<void> => void (await run("readwrite", (store) => store.delete(id)));
  return {
    list,
    remove,
    async put(draft) {
      await run("readwrite", (store) => store.put(draft));
      for (const old of surplus(await list())) await remove(old.id);
    },
  };
}
