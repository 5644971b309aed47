// The browser's own database as the place for drafts.

import { type Draft, type DraftStore, surplus } from "./drafts";

const STORE = "drafts";

/** Opens with the first use. A database that could not be opened is tried again with the next. */
export function openDraftDatabase(): DraftStore {
  let database: Promise<IDBDatabase> | undefined;
  const open = (): Promise<IDBDatabase> => {
    database ??= opened().catch((error: unknown) => {
      database = undefined;
      throw error;
    });
    return database;
  };
  const run = async <T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> => {
    const transaction = (await open()).transaction(STORE, mode);
    const request = work(transaction.objectStore(STORE));
    return new Promise((resolve, reject) => {
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = transaction.onerror = () => reject(transaction.error ?? request.error);
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
      const old = await list().then(surplus, () => []);
      for (const { id } of old) await remove(id).catch(() => undefined);
    },
  };
}

function opened(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open("dini", 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: "id" });
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}
