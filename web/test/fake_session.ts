// A session that draws nothing: what plays, compares and fills sheets is tried with it.

import { readDocument } from "../src/model/document";
import type { Json } from "../src/model/json";
import { createStore } from "../src/model/store";
import type { Session } from "../src/session/session";
import { EMPTY, type Picture, type PictureViewer, type SessionState } from "../src/session/state";

export interface Drawn extends Picture {
  text: string;
  isGone: boolean;
}

/** A server that answers by the address of a request. What `answer` throws is a connection that breaks. */
export function serve(answer: (address: string, body: string) => Response | Promise<Response>): void {
  globalThis.fetch = async (address, request) => {
    const signal = request?.signal;
    signal?.throwIfAborted();
    const given = await answer(String(address), String(request?.body ?? ""));
    signal?.throwIfAborted();
    return given;
  };
}

/** Lines of a batch, as the server sends them. */
export function lines(items: readonly object[]): Response {
  return new Response(items.map((item) => `${JSON.stringify(item)}\n`).join(""));
}

/** Lets what has been begun go on. */
export async function settle(): Promise<void> {
  for (let turn = 0; turn < 8; turn++) await new Promise((done) => setTimeout(done, 1));
}

export class FakeView {
  readonly decoded: Drawn[] = [];
  readonly shown: string[] = [];
  readonly compared: (string | null)[] = [];
  /** Texts of models that cannot be drawn. */
  readonly broken = new Set<string>();
  pictures = 0;

  /** How many pictures are neither shown nor let go. */
  get left(): number {
    return this.decoded.filter(({ isGone, text }) => !isGone && !this.shown.includes(text)).length;
  }

  get viewer(): PictureViewer {
    const decode = async (bytes: Uint8Array<ArrayBuffer>): Promise<Picture> => {
      const text = new TextDecoder().decode(bytes);
      if (this.broken.has(text)) throw new Error("unreadable");
      const made: Drawn = {
        ...{ text, isGone: false, triangles: 1, vertices: 3, decodeMilliseconds: 0 },
        dispose: () => {
          made.isGone = true;
        },
      };
      this.decoded.push(made);
      return made;
    };
    const viewer: Partial<PictureViewer> = {
      decode,
      show: (picture) => void this.shown.push((picture as Drawn).text),
      compare: (picture) => void this.compared.push(picture && (picture as Drawn).text),
      thumbnail: async () => `blob:picture-${++this.pictures}`,
    };
    return viewer as PictureViewer;
  }
}

export function fakeSession(json: Json, view: FakeView, change: Partial<SessionState> = {}): Session {
  const read = readDocument(json);
  if ("error" in read) throw new Error(read.error);
  const store = createStore<SessionState>({ ...EMPTY, document: read.document, ...change });
  const session: Partial<Session> = {
    store,
    viewer: Promise.resolve(view.viewer),
    drawnBody: () => {
      const { document, values } = store.get();
      return document ? { graph: document.json, parameters: values, output: "out" } : undefined;
    },
    showAgain: () => void view.shown.push("again"),
    markUnkept: () => store.set({ origin: { kind: "new" }, isChanged: true }),
  };
  return session as Session;
}
