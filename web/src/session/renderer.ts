// Keeps the picture up with the session: asks the server for it, hands what comes to the viewer, waits for a server
// that is away.

import type { CameraPlace } from "../model/document";
import type { Store } from "../model/store";
import { evaluate, isAlive } from "../net/api";
import { failedChecks, withFailedChecks, withoutNodes } from "../net/checks";
import { Evaluator, type ModelAnswer, type Stamp } from "../net/evaluator";
import { localProblem } from "../net/problem";
import type { Answer, Effort, EvaluateBody } from "../net/requests";
import { ControlLoader } from "./control_loader";
import type { Picture, PictureViewer, SessionState, Shown } from "./state";

const PING_MILLISECONDS = 1500;

/** What one answer shows: the model, and what is drawn over it. */
interface Shape {
  model: Picture;
  control: Picture | null;
}

export class Renderer {
  private readonly evaluator: Evaluator<EvaluateBody, Shape>;
  private readonly supersedeKey = `page-${crypto.getRandomValues(new Uint32Array(2)).join("-")}`;
  private viewer: Promise<PictureViewer>;
  private giveViewer: (viewer: PictureViewer) => void = () => undefined;
  private refuseViewer: (reason: Error) => void = () => undefined;
  private shownViewer: PictureViewer | undefined;
  private pinging = false;
  private isFirst = true;
  /** Where the camera is to stand for the first picture, in place of the document's own. */
  private place: CameraPlace | null = null;
  private readonly control: ControlLoader;
  /** For which wish the control geometry of an answer was drawn. */
  private readonly wishes = new WeakMap<Answer, string>();

  constructor(private readonly store: Store<SessionState>) {
    this.viewer = new Promise((resolve, reject) => {
      this.giveViewer = resolve;
      this.refuseViewer = reject;
    });
    this.viewer.catch(() => undefined);
    this.control = new ControlLoader(store, this.viewer);
    this.evaluator = new Evaluator<EvaluateBody, Shape>({
      send: (body, effort, signal) => this.send(body, effort, signal),
      decode: async (answer) => {
        const viewer = await this.viewer;
        const [model, control] = await Promise.all([
          viewer.decode(answer.model),
          // A broken drawing of points must not keep the model from being shown.
          answer.preview && viewer.decode(answer.preview).catch(() => null),
        ]);
        return { model, control };
      },
      show: (shape, answer, stamp) => this.show(shape, answer, stamp),
      discard: ({ model, control }) => {
        model.dispose();
        control?.dispose();
      },
      fail: (problem) => {
        store.set({ problem, away: false });
        this.control.renew();
      },
      away: (isCrowded) => this.lost(isCrowded),
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
    const { names } = this.control.expect();
    return this.evaluator.input(names.length > 0 ? { ...body, preview: names } : body, moving);
  }

  /** There is nothing to ask for; what is under way is of no use. */
  rest(): void {
    this.evaluator.reset();
    this.store.set({ busy: false });
    this.control.renew();
  }

  /** Gives up what is under way. */
  stop(): void {
    this.evaluator.reset();
    const detail = "The evaluation was stopped. The next change starts it again.";
    this.store.set({ busy: false, problem: localProblem("Stopped", detail) });
  }

  /** Waits for no answer that is under way. */
  giveUp(): void {
    this.evaluator.reset();
  }

  /** Another document: the next picture is its first, seen from `place` if that is given. */
  reset(place: CameraPlace | null = null): void {
    this.evaluator.reset();
    this.shownViewer?.clear();
    this.isFirst = true;
    this.place = place;
  }

  /** Shows again what was shown last, unless something newer comes. */
  showAgain(): void {
    const { shown } = this.store.get();
    const viewer = this.shownViewer;
    if (!shown || !viewer) return;
    void viewer.decode(shown.model.slice()).then((picture) => {
      if (this.store.get().shown === shown) viewer.show(picture);
      else picture.dispose();
    });
  }

  /** The viewer, once there is one. Rejects where it cannot start. */
  get loaded(): Promise<PictureViewer> {
    return this.viewer;
  }

  /** Where the camera stands; null while that is where the document opens. */
  get cameraPlace(): CameraPlace | null {
    return this.isFirst ? this.place : (this.shownViewer?.camera ?? null);
  }

  /** The same as a document says it. */
  get pictureCamera(): CameraPlace | null {
    return this.isFirst ? null : (this.shownViewer?.pictureCamera ?? null);
  }

  /** Takes a viewer into use; one that replaces another is given what is shown. */
  viewerLoaded(viewer: PictureViewer): void {
    this.giveViewer(viewer);
    this.viewer = Promise.resolve(viewer);
    this.shownViewer = viewer;
    this.control.viewer = this.viewer;
    this.control.refresh();
    const { shown } = this.store.get();
    if (shown) void viewer.decode(shown.model).then((picture) => viewer.open(picture, this.camera(), this.place));
  }

  viewerFailed(reason: string): void {
    this.refuseViewer(new Error(reason));
  }

  private camera(): CameraPlace | null {
    return this.store.get().document?.camera ?? null;
  }

  private async send(body: EvaluateBody, effort: Effort, signal: AbortSignal): Promise<Answer> {
    // Only full evaluations supersede each other: a newer draft must not cancel the older one, or a slow graph would
    // show nothing while a slider moves.
    const key = effort.quality === "final" ? this.supersedeKey : undefined;
    const wish = this.control.key;
    const answer = await this.ask(body, (asked) => evaluate(asked, effort, signal, key));
    this.wishes.set(answer, wish);
    return answer;
  }

  /** Neither a node that is only looked at, nor a check that cannot run yet, may hide the model. */
  private async ask(body: EvaluateBody, send: (body: EvaluateBody) => Promise<Answer>): Promise<Answer> {
    const answer = await send(body);
    if (answer.kind !== "problem" || answer.problem.status !== 422) return answer;
    const failed = failedChecks(answer.problem);
    if (failed.length > 0) {
      const rest = await this.ask(withoutNodes(body, failed), send);
      return rest.kind === "model" ? withFailedChecks(rest, failed) : answer;
    }
    return body.preview ? this.ask({ ...body, preview: undefined }, send) : answer;
  }

  private show({ model: picture, control }: Shape, answer: ModelAnswer, stamp: Stamp): void {
    if (this.isFirst) this.shownViewer?.open(picture, this.camera(), this.place);
    else this.shownViewer?.show(picture);
    this.isFirst = false;
    this.control.shown(control, this.wishes.get(answer));
    const { triangles, vertices, decodeMilliseconds } = picture;
    const { report, model } = answer;
    const shown: Shown = { ...stamp, report, model, triangles, vertices, decodeMilliseconds };
    this.store.set({ shown, problem: null, away: false });
  }

  private lost(isCrowded: boolean): void {
    this.store.set({ away: true, isCrowded });
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
