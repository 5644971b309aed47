// Keeps the picture up with the session: asks the server for it, hands what comes to the viewer, waits for a server
// that is away.

import type { CameraPlace } from "../model/document";
import type { Store } from "../model/store";
import { evaluate, isAlive, type EvaluateBody } from "../net/api";
import { Evaluator, type ModelAnswer, type Stamp } from "../net/evaluator";
import { localProblem } from "../net/problem";
import type { Picture, PictureViewer, SessionState, Shown } from "./state";

const PING_MILLISECONDS = 1500;

export class Renderer {
  private readonly evaluator: Evaluator<EvaluateBody, Picture>;
  private readonly supersedeKey = `page-${crypto.getRandomValues(new Uint32Array(2)).join("-")}`;
  private viewer: Promise<PictureViewer>;
  private giveViewer: (viewer: PictureViewer) => void = () => undefined;
  private refuseViewer: (reason: Error) => void = () => undefined;
  private shownViewer: PictureViewer | undefined;
  private pinging = false;
  private isFirst = true;

  constructor(private readonly store: Store<SessionState>) {
    this.viewer = new Promise((resolve, reject) => {
      this.giveViewer = resolve;
      this.refuseViewer = reject;
    });
    this.viewer.catch(() => undefined);
    this.evaluator = new Evaluator<EvaluateBody, Picture>({
      // Only full evaluations supersede each other: a newer draft must not cancel the older one, or a slow graph
      // would show nothing while a slider moves.
      send: (body, quality, signal) =>
        evaluate(body, quality, signal, quality === "final" ? this.supersedeKey : undefined),
      decode: async (answer) => (await this.viewer).decode(answer.model),
      show: (picture, answer, stamp) => this.show(picture, answer, stamp),
      discard: (picture) => picture.dispose(),
      fail: (problem) => store.set({ problem, away: false }),
      away: () => this.lost(),
      busy: (busy) => store.set({ busy }),
      clock: {
        now: () => performance.now(),
        setTimeout: (run, milliseconds) => window.setTimeout(run, milliseconds),
        clearTimeout: (timer) => window.clearTimeout(timer as number | undefined),
      },
    });
  }

  /** Asks for the picture of a new input. Answers the revision it will have. */
  input(body: EvaluateBody, moving: boolean): number {
    return this.evaluator.input(body, moving);
  }

  /** There is nothing to ask for; what is under way is of no use. */
  rest(): void {
    this.evaluator.reset();
    this.store.set({ busy: false });
  }

  /** Gives up what is under way. */
  stop(): void {
    this.evaluator.reset();
    const detail = "The evaluation was stopped. The next change starts it again.";
    this.store.set({ busy: false, problem: localProblem("Stopped", detail) });
  }

  /** Another document: the next picture is its first. */
  reset(): void {
    this.evaluator.reset();
    this.shownViewer?.clear();
    this.isFirst = true;
  }

  /** Takes a viewer into use; one that replaces another is given what is shown. */
  viewerLoaded(viewer: PictureViewer): void {
    this.giveViewer(viewer);
    this.viewer = Promise.resolve(viewer);
    this.shownViewer = viewer;
    const { shown } = this.store.get();
    if (shown) void viewer.decode(shown.model).then((picture) => viewer.open(picture, this.camera()));
  }

  viewerFailed(reason: string): void {
    this.refuseViewer(new Error(reason));
  }

  private camera(): CameraPlace | null {
    return this.store.get().document?.camera ?? null;
  }

  private show(picture: Picture, answer: ModelAnswer, stamp: Stamp): void {
    if (this.isFirst) this.shownViewer?.open(picture, this.camera());
    else this.shownViewer?.show(picture);
    this.isFirst = false;
    const { triangles, vertices, decodeMilliseconds } = picture;
    const { report, model } = answer;
    const shown: Shown = { ...stamp, report, model, triangles, vertices, decodeMilliseconds };
    this.store.set({ shown, problem: null, away: false });
  }

  private lost(): void {
    this.store.set({ away: true });
    if (this.pinging) return;
    this.pinging = true;
    const ping = async (): Promise<void> => {
      if (!(await isAlive())) {
        window.setTimeout(() => void ping(), PING_MILLISECONDS);
        return;
      }
      this.pinging = false;
      this.store.set({ away: false });
      this.evaluator.resume();
    };
    window.setTimeout(() => void ping(), PING_MILLISECONDS / 3);
  }
}
