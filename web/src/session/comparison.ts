// Two settings of one graph, looked at together: the present values, and those of a variant.

import { isSameGraph } from "../model/document";
import type { ParameterValues } from "../model/parameters";
import { createStore, type Store } from "../model/store";
import { evaluate } from "../net/api";
import { problemText } from "../net/problem";
import type { Session } from "./session";
import type { PictureViewer } from "./state";

export type ComparedHow = "beside" | "over";

export interface ComparisonState {
  /** What the other one is called; null while nothing is compared. */
  name: string | null;
  how: ComparedHow;
  isLoading: boolean;
  error: string;
}

const DRAFT_TRIANGLES = 20_000;
const comparisons = new WeakMap<Session, Comparison>();

/** The one comparison of a session. */
export function comparisonOf(session: Session): Comparison {
  const comparison = comparisons.get(session) ?? new Comparison(session);
  comparisons.set(session, comparison);
  return comparison;
}

export class Comparison {
  readonly store: Store<ComparisonState> = createStore<ComparisonState>({
    ...{ name: null, how: "beside", isLoading: false, error: "" },
  });
  private request = new AbortController();
  /** The file of the other one, once it has come. */
  private model: Uint8Array<ArrayBuffer> | undefined;

  constructor(private readonly session: Session) {
    let { document } = session.store.get();
    session.store.subscribe(() => {
      const now = session.store.get().document;
      const isSame = isSameGraph(now, document);
      document = now;
      // The other one was made by another graph.
      if (!isSame) this.close();
    });
  }

  /** Shows what other values make beside the present model, or as the distance between the two. */
  async open(name: string, values: ParameterValues): Promise<void> {
    this.close();
    const body = this.session.drawnBody();
    if (!body) return;
    this.request = new AbortController();
    const { signal } = this.request;
    this.store.set({ name, isLoading: true, error: "" });
    try {
      const effort = { quality: "final", triangles: DRAFT_TRIANGLES } as const;
      const answer = await evaluate({ ...body, parameters: values }, effort, signal);
      const viewer = await this.session.viewer;
      if (signal.aborted) return;
      if (answer.kind !== "model") {
        const error = answer.kind === "away" ? "The server does not answer." : problemText(answer.problem);
        this.store.set({ isLoading: false, error });
        return;
      }
      this.model = answer.model;
      await this.draw(viewer, signal);
      if (!signal.aborted) this.store.set({ isLoading: false });
    } catch {
      if (!signal.aborted) this.store.set({ isLoading: false, error: `${name} cannot be drawn.` });
    }
  }

  /** Another view has taken the place of the one that both were drawn in. */
  drawAgain(viewer: PictureViewer): void {
    if (this.model) void this.draw(viewer, this.request.signal).catch(() => undefined);
  }

  set(how: ComparedHow): void {
    this.store.set({ how });
    void this.session.viewer.then((viewer) => viewer.compareHow(how));
  }

  close(): void {
    if (this.store.get().name === null) return;
    this.request.abort();
    this.model = undefined;
    this.store.set({ name: null, isLoading: false, error: "" });
    void this.session.viewer.then(
      (viewer) => viewer.compare(null, "beside"),
      () => undefined,
    );
  }

  private async draw(viewer: PictureViewer, signal: AbortSignal): Promise<void> {
    // The decoder keeps what it is given.
    const picture = this.model && (await viewer.decode(this.model.slice()));
    if (signal.aborted) picture?.dispose();
    else if (picture) viewer.compare(picture, this.store.get().how);
  }
}
