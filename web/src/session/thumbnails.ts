// Small pictures of graphs: for the gallery where the server has none, for drafts and stored graphs. They are made in the
// page from drafts, one at a time, while nothing else is being evaluated.

import { readDocument } from "../model/document";
import { fileOutput } from "../model/graph";
import { withGroups } from "../model/group_cards";
import type { Json } from "../model/json";
import type { Store } from "../model/store";
import { evaluate } from "../net/api";
import type { PictureViewer, SessionState } from "./state";

const WIDTH = 240;
const HEIGHT = 150;
const DRAFT = { quality: "draft", triangles: 20_000 } as const;
const PAUSE_MILLISECONDS = 60;
/** Variants have other pictures with every edit; more than this are not looked at together. */
const MOST_KEPT = 200;

/** Fills in the pictures that the list of examples came without. Ends silently where one cannot be made. */
export async function makeThumbnails(store: Store<SessionState>, viewer: PictureViewer): Promise<void> {
  await untilIdle(store);
  for (const { id } of store.get().examples ?? []) {
    await untilIdle(store);
    const example = store.get().examples?.find((item) => item.id === id);
    if (!example || example.image) continue;
    const image = await draw(example.graph, store, viewer);
    const examples = store.get().examples ?? [];
    store.set({ examples: examples.map((item) => (item.id === id ? { ...item, image } : item)) });
  }
}

/** Pictures of graphs that are asked for, each made once. */
export class Thumbnails {
  private readonly made = new Map<string, Promise<string>>();
  private last: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly store: Store<SessionState>,
    private readonly viewer: () => Promise<PictureViewer>,
  ) {}

  /**
   * The address of a picture; empty where none can be made. `key` is the same for the same graph, `read` gets its
   * document when its turn has come.
   */
  of(key: string, read: () => Promise<Json>): Promise<string> {
    const known = this.made.get(key);
    if (known !== undefined) {
      // The one that was not asked for the longest goes first.
      this.made.delete(key);
      this.made.set(key, known);
      return known;
    }
    const image = this.last.then(async () => {
      await untilIdle(this.store);
      return draw(await read(), this.store, await this.viewer());
    });
    const safe = image.catch(() => "");
    this.made.set(key, safe);
    this.last = safe;
    const [oldest] = this.made.keys();
    if (oldest !== undefined && this.made.size > MOST_KEPT) {
      void this.made.get(oldest)?.then((address) => URL.revokeObjectURL(address));
      this.made.delete(oldest);
    }
    return safe;
  }
}

async function draw(graph: Json, store: Store<SessionState>, viewer: PictureViewer): Promise<string> {
  const { catalogue } = store.get();
  const result = readDocument(graph);
  if (!catalogue || "error" in result) return "";
  const { document, values } = result;
  const output = fileOutput(document, withGroups(catalogue, document));
  if (output === undefined) return "";
  const answer = await evaluate({ graph: document.json, parameters: values, output }, DRAFT);
  if (answer.kind !== "model") return "";
  try {
    const picture = await viewer.decode(answer.model);
    return await viewer.thumbnail(picture, WIDTH, HEIGHT, document.camera ?? null).finally(() => picture.dispose());
  } catch {
    return "";
  }
}

/** Resolves when the shown picture is up to date and has been for a moment. */
async function untilIdle(store: Store<SessionState>): Promise<void> {
  const isIdle = (): boolean => {
    const { busy, away, examples } = store.get();
    return !busy && !away && examples !== null;
  };
  for (;;) {
    await new Promise((resolve) => window.setTimeout(resolve, PAUSE_MILLISECONDS));
    if (isIdle()) return;
    await new Promise<void>((resolve) => {
      const stop = store.subscribe(() => {
        if (!isIdle()) return;
        stop();
        resolve();
      });
    });
  }
}
