// Plays a parameter: the models of all its steps come from one batch of the server, are decoded a little ahead, and are
// shown in their order. A step that is not there yet is waited for and never left out.

import { isSameGraph, lookedAt } from "../model/document";
import type { Parameter } from "../model/parameters";
import { type PlayMode, roundOf, stepValues } from "../model/steps";
import { createStore, type Store } from "../model/store";
import { problemText } from "../net/problem";
import type { EvaluateBody } from "../net/requests";
import { type SweepLine, sweep } from "../net/sweeps";
import { modelOf } from "./batch";
import type { Session } from "./session";
import type { Picture, PictureViewer } from "./state";

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
  /** How many steps there is no model of; they are left out. */
  missing: number;
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
    ...{
      parameter: null,
      values: [],
      mode: "loop",
      speed: 12,
      isPlaying: false,
      step: -1,
      ready: 0,
      missing: 0,
      error: "",
    },
  });
  private frames: Promise<Bytes | undefined>[] = [];
  private give: ((bytes: Bytes | undefined) => void)[] = [];
  /** Where it is in the round: on the way there or back. */
  private place = -1;
  /** The batch has ended before its time. */
  private isBroken = false;
  private loading = new AbortController();
  private running = new AbortController();

  constructor(readonly session: Session) {
    let { document, values } = session.store.get();
    session.store.subscribe(() => {
      const state = session.store.get();
      const isSame = isSameGraph(state.document, document) && state.values === values;
      ({ document, values } = state);
      // Another graph has other steps.
      if (!isSame && this.store.get().parameter !== null) this.close();
    });
  }

  /** Asks for the steps of a parameter and waits to be started. */
  open(name: string, count: number): void {
    this.close();
    const parameter = parametersOf(this.session).find((one) => one.name === name);
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
    [this.place, this.isBroken] = [-1, false];
    this.store.set({ parameter: name, values, step: -1, ready: 0, missing: 0, error: "" });
    void this.load(body, name, values).catch(() => undefined);
  }

  set(change: Partial<Pick<PlayerState, "mode" | "speed">>): void {
    this.store.set(change);
    if (!this.store.get().isPlaying) return;
    this.pause();
    this.play();
  }

  play(): void {
    const { parameter, isPlaying, values } = this.store.get();
    if (parameter === null || isPlaying) return;
    // What did not come is asked for again.
    if (this.isBroken) this.open(parameter, values.length);
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
    this.place = step;
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
    if (!signal.aborted) this.store.set({ isPlaying: true });
    try {
      for (const step of roundOf(values.length, mode)) {
        const picture = await this.decode(viewer, step);
        if (signal.aborted) {
          picture?.dispose();
          throw new Stopped();
        }
        if (!picture) continue;
        this.put(viewer, picture, step);
        await each(viewer, step);
        if (signal.aborted) throw new Stopped();
      }
    } finally {
      // Whoever stopped it may play already.
      if (!signal.aborted) this.store.set({ isPlaying: false });
    }
  }

  /** Ends it: the parameter keeps the value of the step that is shown, if that is wanted. */
  close(keep = false): void {
    const { parameter: name, step, values } = this.store.get();
    if (name === null) return;
    this.pause();
    this.loading.abort();
    this.giveUp();
    this.frames = [];
    this.give = [];
    this.store.set({ parameter: null, values: [], step: -1, ready: 0, missing: 0, error: "" });
    const parameter = parametersOf(this.session).find((one) => one.name === name);
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
    const found = await modelOf(line, body, signal);
    if ("error" in found) {
      this.miss(line.index, `Step ${line.index + 1} cannot be shown. ${found.error}`);
      return;
    }
    this.give[line.index]?.(found.bytes);
    this.store.set({ ready: this.store.get().ready + 1 });
  }

  private async run(signal: AbortSignal): Promise<void> {
    const viewer = await this.session.viewer;
    const { values, mode, step, speed } = this.store.get();
    const round = roundOf(values.length, mode);
    // It goes on where it was, or from the beginning after the end.
    const last = round[this.place] === step ? this.place : round.indexOf(step);
    let at = last + 1;
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
        if (signal.aborted) {
          picture?.dispose();
          return;
        }
        const shown = at++;
        if (!picture) {
          if (this.isBroken || this.store.get().missing === values.length) break;
          continue;
        }
        this.put(viewer, picture, stepAt(shown));
        this.place = shown % round.length;
        due = Math.max(performance.now(), due + 1000 / speed);
      }
      this.store.set({ isPlaying: false });
    } finally {
      for (const one of ahead) {
        void one.then(
          (picture) => picture?.dispose(),
          () => undefined,
        );
      }
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

  /** One step has no model: it is left out, and said once. */
  private miss(step: number, why: string): void {
    const { parameter, missing, error } = this.store.get();
    if (parameter === null) return;
    this.give[step]?.(undefined);
    this.store.set({ missing: missing + 1, error: error || why });
  }

  /** Nothing more will come. */
  private fail(error: string): void {
    if (this.store.get().parameter === null) return;
    this.isBroken = true;
    this.pause();
    this.giveUp();
    this.store.set({ error });
  }

  /** Nobody waits any longer for what has not come. */
  private giveUp(): void {
    for (const give of this.give) give(undefined);
  }
}

/** A recording that a person has ended, or whose graph has changed. */
export class Stopped extends Error {}

/** The parameters of the whole graph, whatever of it is looked at. */
function parametersOf(session: Session): readonly Parameter[] {
  const { document } = session.store.get();
  return document ? lookedAt(document, []).parameters : [];
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
