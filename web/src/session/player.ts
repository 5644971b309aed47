// Plays a parameter: the models of all its steps come from one batch of the server, are decoded a little ahead, and are
// shown in their order. A step that is not there yet is waited for and never left out.

import { type PlayMode, roundOf, stepValues } from "../model/steps";
import { createStore, type Store } from "../model/store";
import { evaluate } from "../net/api";
import { problemText } from "../net/problem";
import type { EvaluateBody } from "../net/requests";
import { fetchArtifact, type SweepLine, sweep } from "../net/sweeps";
import type { Session } from "./session";
import type { Picture, PictureViewer } from "./state";

const DRAFT = { quality: "draft", triangles: 20_000 } as const;
/** So many are decoded before their time has come. */
const AHEAD = 3;

export interface PlayerState {
  /** The parameter that is played; null while there is no player. */
  parameter: string | null;
  /** Its values, one for each step. */
  values: readonly number[];
  mode: PlayMode;
  /** Steps in a second. */
  speed: number;
  isPlaying: boolean;
  /** The step that is shown; -1 before the first. */
  step: number;
  /** How many steps have come from the server. */
  ready: number;
  error: string;
}

const players = new WeakMap<Session, Player>();

/** The one player of a session. */
export function playerOf(session: Session): Player {
  const player = players.get(session) ?? new Player(session);
  players.set(session, player);
  return player;
}

type Bytes = Uint8Array<ArrayBuffer>;

export class Player {
  readonly store: Store<PlayerState> = createStore<PlayerState>({
    ...{ parameter: null, values: [], mode: "loop", speed: 12, isPlaying: false, step: -1, ready: 0, error: "" },
  });
  private frames: Promise<Bytes>[] = [];
  private give: ((bytes: Bytes) => void)[] = [];
  private loading = new AbortController();
  private running = new AbortController();

  constructor(readonly session: Session) {
    let { document, values } = session.store.get();
    session.store.subscribe(() => {
      const state = session.store.get();
      const isSame = state.document === document && state.values === values;
      ({ document, values } = state);
      // Another graph has other steps.
      if (!isSame && this.store.get().parameter !== null) this.close();
    });
  }

  /** Asks for the steps of a parameter and waits to be started. */
  open(name: string, count: number): void {
    this.close();
    const parameter = this.session.store.get().document?.parameters.find((one) => one.name === name);
    const body = this.session.drawnBody();
    if (!parameter || !body) return;
    const values = stepValues(parameter, count);
    this.frames = values.map(
      (_, index) =>
        new Promise((done) => {
          this.give[index] = done;
        }),
    );
    this.loading = new AbortController();
    this.store.set({ parameter: name, values, step: -1, ready: 0, error: "" });
    void this.load(body, name, values).catch(() => undefined);
  }

  set(change: Partial<Pick<PlayerState, "mode" | "speed">>): void {
    this.store.set(change);
    if (!this.store.get().isPlaying) return;
    this.pause();
    this.play();
  }

  play(): void {
    if (this.store.get().parameter === null || this.store.get().isPlaying) return;
    this.store.set({ isPlaying: true });
    this.running = new AbortController();
    const { signal } = this.running;
    void this.run(signal).catch((error: unknown) => {
      if (!signal.aborted) this.fail(String(error));
    });
  }

  pause(): void {
    this.running.abort();
    this.store.set({ isPlaying: false });
  }

  /** Shows one step. */
  async show(step: number): Promise<void> {
    this.pause();
    this.running = new AbortController();
    const { signal } = this.running;
    const viewer = await this.session.viewer;
    const picture = await this.decode(viewer, step);
    if (signal.aborted) picture?.dispose();
    else if (picture) this.put(viewer, picture, step);
  }

  /** One round from the beginning, as quickly as it can be shown; `each` is waited for after every step. */
  async walk(each: (viewer: PictureViewer, step: number) => Promise<void>): Promise<void> {
    this.pause();
    this.running = new AbortController();
    const { signal } = this.running;
    const { values, mode } = this.store.get();
    const viewer = await this.session.viewer;
    this.store.set({ isPlaying: true });
    for (const step of roundOf(values.length, mode)) {
      const picture = await this.decode(viewer, step);
      if (!picture || signal.aborted) {
        picture?.dispose();
        throw new Error("The recording was stopped.");
      }
      this.put(viewer, picture, step);
      await each(viewer, step);
    }
    this.store.set({ isPlaying: false });
  }

  /** Ends it: the parameter keeps the value of the step that is shown, if that is wanted. */
  close(keep = false): void {
    const { parameter: name, step, values } = this.store.get();
    if (name === null) return;
    this.pause();
    this.loading.abort();
    this.frames = [];
    this.give = [];
    this.store.set({ parameter: null, values: [], step: -1, ready: 0 });
    const parameter = this.session.store.get().document?.parameters.find((one) => one.name === name);
    const value = values[step];
    if (keep && parameter && value !== undefined) this.session.setParameter(parameter, value, false);
    else if (step >= 0) this.session.showAgain();
  }

  private async load(body: EvaluateBody, name: string, values: readonly number[]): Promise<void> {
    const { signal } = this.loading;
    const { graph, parameters, output } = body;
    if (output === undefined) return;
    const { [name]: _, ...shared } = parameters;
    const waiting: Promise<void>[] = [];
    const take = (line: SweepLine): void => {
      const one = { ...body, parameters: { ...shared, [name]: values[line.index] ?? 0 } };
      // What is given up while the others still come is not waited for.
      waiting.push(this.fetch(line, one, signal).catch(() => undefined));
    };
    const grid = { [name]: values };
    const answer = await sweep({ graph, parameters: shared, grid, output, quality: "draft" }, take, signal);
    await Promise.all(waiting);
    if (answer.kind === "problem") this.fail(problemText(answer.problem));
    if (answer.kind === "away") this.fail("The server does not answer.");
  }

  private async fetch(line: SweepLine, body: EvaluateBody, signal: AbortSignal): Promise<void> {
    if (line.error) {
      this.fail(`Step ${line.index + 1} cannot be shown. ${line.error}`);
      return;
    }
    let bytes = line.sha256 ? await fetchArtifact(line.sha256, signal) : undefined;
    if (!bytes) {
      // The server has forgotten it already.
      const answer = await evaluate(body, DRAFT, signal);
      bytes = answer.kind === "model" ? answer.model : undefined;
    }
    if (!bytes) {
      this.fail(`Step ${line.index + 1} did not come.`);
      return;
    }
    this.give[line.index]?.(bytes);
    this.store.set({ ready: this.store.get().ready + 1 });
  }

  private async run(signal: AbortSignal): Promise<void> {
    const viewer = await this.session.viewer;
    const { values, mode, step, speed } = this.store.get();
    const round = roundOf(values.length, mode);
    // It goes on where it was, or from the beginning after the end.
    let at = Math.max(0, round.indexOf(step)) + (step < 0 ? 0 : 1);
    if (mode === "once" && at >= round.length) at = 0;
    const ahead: Promise<Picture | undefined>[] = [];
    const stepAt = (place: number): number => round[place % round.length] ?? 0;
    const isEnd = (place: number): boolean => mode === "once" && place >= round.length;
    let next = at;
    let due = performance.now();
    try {
      while (!isEnd(at)) {
        while (ahead.length < AHEAD && !isEnd(next)) ahead.push(this.decode(viewer, stepAt(next++)));
        const picture = await ahead.shift();
        await untilTime(due, signal);
        if (!picture || signal.aborted) {
          picture?.dispose();
          return;
        }
        this.put(viewer, picture, stepAt(at));
        at++;
        due = Math.max(performance.now(), due + 1000 / speed);
      }
      this.store.set({ isPlaying: false });
    } finally {
      for (const one of ahead) void one.then((picture) => picture?.dispose());
    }
  }

  private async decode(viewer: PictureViewer, step: number): Promise<Picture | undefined> {
    const bytes = await this.frames[step];
    // The decoder keeps what it is given.
    return bytes && viewer.decode(bytes.slice());
  }

  private put(viewer: PictureViewer, picture: Picture, step: number): void {
    viewer.show(picture);
    this.store.set({ step });
  }

  private fail(error: string): void {
    if (this.store.get().parameter === null) return;
    this.pause();
    this.store.set({ error });
  }
}

/** Resolves with the first frame of the page at or after a time, or when it is no longer waited for. */
function untilTime(time: number, signal: AbortSignal): Promise<void> {
  return new Promise((done) => {
    const look = (): void => {
      if (signal.aborted || performance.now() >= time) done();
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
}
