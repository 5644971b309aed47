// Pictures for the gallery where the server has none, made once in the page from drafts, one at a time, while nothing else is being evaluated.

import { readDocument } from "../model/document";
import { fileOutput } from "../model/graph";
import { evaluate } from "../net/api";
import type { Session } from "./session";
import type { Example, PictureViewer } from "./state";

const WIDTH = 240;
const HEIGHT = 150;
const DRAFT = { quality: "draft", triangles: 20_000 } as const;
const PAUSE_MILLISECONDS = 60;

/** Fills in the pictures that the list of examples came without. Ends silently where one cannot be made. */
export async function makeThumbnails(session: Session, viewer: PictureViewer): Promise<void> {
  await untilIdle(session);
  for (const { id } of session.store.get().examples ?? []) {
    await untilIdle(session);
    const example = session.store.get().examples?.find((item) => item.id === id);
    if (!example || example.image) continue;
    const image = await pictureOf(example, session, viewer);
    const examples = session.store.get().examples ?? [];
    session.store.set({ examples: examples.map((item) => (item.id === id ? { ...item, image } : item)) });
  }
}

async function pictureOf(example: Example, session: Session, viewer: PictureViewer): Promise<string> {
  const { catalogue } = session.store.get();
  const result = readDocument(example.graph);
  if (!catalogue || "error" in result) return "";
  const { json } = result.document;
  const body = { graph: json, parameters: {}, output: fileOutput(result.document, catalogue) };
  const answer = await evaluate(body, DRAFT);
  if (answer.kind !== "model") return "";
  try {
    const picture = await viewer.decode(answer.model);
    const address = await viewer.thumbnail(picture, WIDTH, HEIGHT);
    picture.dispose();
    return address;
  } catch {
    return "";
  }
}

/** Resolves when the shown picture is up to date and has been for a moment. */
async function untilIdle(session: Session): Promise<void> {
  const isIdle = (): boolean => {
    const { busy, away, examples } = session.store.get();
    return !busy && !away && examples !== null;
  };
  for (;;) {
    await new Promise((resolve) => window.setTimeout(resolve, PAUSE_MILLISECONDS));
    if (isIdle()) return;
    await new Promise<void>((resolve) => {
      const stop = session.store.subscribe(() => {
        if (!isIdle()) return;
        stop();
        resolve();
      });
    });
  }
}
