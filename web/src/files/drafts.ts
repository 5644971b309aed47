// Drafts: what was edited and not saved, kept by the browser. They never touch a saved file.

import type { JsonObject } from "../model/json";
import type { Origin, StoredPlace } from "../session/state";

export interface Draft {
  id: string;
  /** The tab that wrote it: the one that takes it up again after a reload. */
  tab: string;
  title: string;
  /** Name of the file it began as; empty if it was none. */
  name: string;
  /** What the server keeps that it began as. */
  stored?: StoredPlace;
  /** The page's address when it was written, behind the "#". */
  address: string;
  /** Milliseconds since 1970. */
  time: number;
  /** The draft that this one takes the place of, if that is not gone yet. */
  ancestor?: string;
  /** Only values of an example's form were changed. */
  isAdjustment?: boolean;
  json: JsonObject;
}

/** Where a document that is taken up from a draft comes from. */
export function originOf({ id, stored }: Pick<Draft, "id" | "stored">): Origin {
  return { kind: "draft", id, ...(stored && { stored }) };
}

/** The version that the server keeps of an open document, if it does. */
export function storedPlace(origin: Origin): StoredPlace | undefined {
  if (origin.kind === "draft") return origin.stored;
  if (origin.kind !== "stored") return undefined;
  const { id, version, tag } = origin;
  return { id, version, tag };
}

export const MOST_DRAFTS = 10;
/** Going through the examples with a hand on their sliders must not push out work. */
export const MOST_ADJUSTMENTS = 3;

/** Where drafts are kept. All of it may reject. */
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
