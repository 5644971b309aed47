// Keeps the picture up with the inputs: the newest input wins, no answer older than the shown one is shown, and the
// server never has more than two of our requests. Knows neither the page nor HTTP, so it runs against a fake clock.

import { localProblem, type Problem } from "./problem";
import type { Answer, Effort, Quality } from "./requests";

export type ModelAnswer = Extract<Answer, { kind: "model" }>;

export interface Clock {
  now(): number;
  setTimeout(run: () => void, milliseconds: number): unknown;
  clearTimeout(timer: unknown): void;
}

export interface Stamp {
  revision: number;
  quality: Quality;
}

/** What the evaluator asks of the page. `Body` is the request, `Model` a decoded picture. */
export interface EvaluatorHost<Body, Model> {
  send(body: Body, effort: Effort, signal: AbortSignal): Promise<Answer>;
  decode(answer: ModelAnswer): Promise<Model>;
  show(model: Model, answer: ModelAnswer, stamp: Stamp): void;
  discard(model: Model): void;
  fail(problem: Problem, stamp: Stamp): void;
  /** The server cannot be reached, or is crowded; the evaluator tries again by itself. */
  away(isCrowded: boolean): void;
  /** A picture is wanted that is not there yet, or no longer. */
  busy(isBusy: boolean): void;
  clock: Clock;
}

/** After this long without input the full quality is asked for. */
export const SETTLE_MILLISECONDS = 120;
const QUICK_ROUND_TRIP = 33;
const MOST_IN_FLIGHT = 2;
const SUPERSEDED = 409;
/** A draft that takes longer than this from asking to showing is halved the next time. */
const SLOW_DRAFT = 50;
/** A quicker one is doubled: twice as long still leaves time for 30 pictures a second. */
const QUICK_DRAFT = 12;
const DRAFTS_TO_JUDGE = 5;
const FIRST_BUDGET = 20_000;
const SMALLEST_BUDGET = 1250;
const LARGEST_BUDGET = 320_000;
const RETRY_MILLISECONDS = [500, 1000, 2000, 4000];

interface Flight extends Stamp {
  abort: AbortController;
}

interface Wanted<Body> extends Stamp {
  body: Body;
}

export class Evaluator<Body, Model> {
  private revision = 0;
  private newest: Body | undefined;
  private pending: Wanted<Body> | undefined;
  private flights = new Set<Flight>();
  private settleTimer: unknown;
  private retryTimer: unknown;
  private retries = 0;
  private roundTrip = 0;
  private budget = FIRST_BUDGET;
  /** Milliseconds of the last drafts of this budget. */
  private recent: number[] = [];
  /** Rank of the newest answer that is shown, being decoded or reported as failed. */
  private answered = -1;
  private settled = -1;

  constructor(private readonly host: EvaluatorHost<Body, Model>) {}

  /** A new input. While `moving`, drafts are asked for, and the full quality once inputs stop. Answers its revision. */
  input(body: Body, moving: boolean): number {
    this.revision++;
    this.newest = body;
    this.stopTimers();
    for (const flight of this.flights) {
      // A full evaluation that no longer matters only keeps the drafts waiting. Drafts run on: aborting each
      // superseded one would show nothing at all while the hand moves.
      if (flight.quality === "final") this.drop(flight);
    }
    this.pending = { body, revision: this.revision, quality: moving ? "draft" : "final" };
    if (moving) this.settleTimer = this.host.clock.setTimeout(() => this.settle(), SETTLE_MILLISECONDS);
    this.host.busy(true);
    this.pump();
    return this.revision;
  }

  /** Nothing that is under way is of use: another document was opened, or no answer is waited for any more. */
  reset(): void {
    this.stopTimers();
    this.host.clock.clearTimeout(this.retryTimer);
    this.retryTimer = undefined;
    this.retries = 0;
    for (const flight of this.flights) this.drop(flight);
    this.pending = undefined;
    this.answered = Math.max(this.answered, rank({ revision: this.revision, quality: "final" }));
  }

  /** The server is back: ask again for what is still wanted. */
  resume(): void {
    this.host.clock.clearTimeout(this.retryTimer);
    this.retryTimer = undefined;
    this.retries = 0;
    if (!this.pending && this.flights.size === 0 && !this.isSettled()) this.settle();
    this.pump();
  }

  get inFlight(): number {
    return this.flights.size;
  }

  private settle(): void {
    this.settleTimer = undefined;
    if (this.newest === undefined) return;
    this.pending = { body: this.newest, revision: this.revision, quality: "final" };
    this.pump();
  }

  private pump(): void {
    const most = this.roundTrip < QUICK_ROUND_TRIP ? 1 : MOST_IN_FLIGHT;
    if (!this.pending || this.retryTimer !== undefined || this.flights.size >= most) return;
    const wanted = this.pending;
    this.pending = undefined;
    const flight: Flight = { revision: wanted.revision, quality: wanted.quality, abort: new AbortController() };
    this.flights.add(flight);
    void this.fly(flight, wanted);
  }

  private async fly(flight: Flight, wanted: Wanted<Body>): Promise<void> {
    const started = this.host.clock.now();
    try {
      const effort = { quality: wanted.quality, triangles: this.budget };
      const answer = await this.host.send(wanted.body, effort, flight.abort.signal);
      if (this.flights.has(flight)) await this.receive(answer, flight, wanted);
      if (answer.kind !== "away") this.measured(this.host.clock.now() - started, answer, effort);
    } catch (error) {
      // A dropped request ends here; its place is already free.
      if (!flight.abort.signal.aborted) throw error;
    } finally {
      this.flights.delete(flight);
      this.pump();
    }
  }

  /** What a round trip teaches: how many to have under way, and how fine a draft may be. */
  private measured(milliseconds: number, answer: Answer, effort: Effort): void {
    this.roundTrip = milliseconds;
    // Only drafts of the present budget count, and several of them: one that was held up by other work must not
    // change what is seen.
    if (answer.kind !== "model" || effort.quality !== "draft" || effort.triangles !== this.budget) return;
    this.recent.push(milliseconds);
    if (this.recent.length < DRAFTS_TO_JUDGE) return;
    const typical = this.recent.sort((a, b) => a - b)[DRAFTS_TO_JUDGE >> 1] ?? 0;
    this.recent = [];
    if (typical > SLOW_DRAFT) this.budget = Math.max(SMALLEST_BUDGET, this.budget / 2);
    // A draft below its budget is as fine as the model; a larger budget changes nothing but the next surprise.
    else if (typical < QUICK_DRAFT && answer.report.triangles > this.budget / 2) {
      this.budget = Math.min(LARGEST_BUDGET, this.budget * 2);
    }
  }

  private async receive(answer: Answer, flight: Flight, wanted: Wanted<Body>): Promise<void> {
    if (answer.kind === "away") {
      this.waitAndRetry(wanted, answer);
      return;
    }
    this.retries = 0;
    if (rank(flight) <= this.answered) return;
    if (answer.kind === "problem" && answer.problem.status === SUPERSEDED) {
      // The server dropped it for another request of ours. If that was an older one that came late, ask again.
      const isNewest = wanted.revision === this.revision && wanted.quality === "final";
      if (isNewest && !this.pending) this.pending = wanted;
      return;
    }
    if (answer.kind === "problem") {
      this.answered = rank(flight);
      this.conclude(answer.problem, flight);
      return;
    }
    this.answered = rank(flight);
    let model: Model;
    try {
      model = await this.host.decode(answer);
    } catch (error) {
      const detail = error instanceof Error ? error.message : String(error);
      if (this.answered === rank(flight)) this.conclude(localProblem("The model could not be shown", detail), flight);
      return;
    }
    // A newer answer may have come, or the document may have gone, while this one was decoded.
    if (rank(flight) < this.settled || !this.flights.has(flight)) {
      this.host.discard(model);
      return;
    }
    this.settled = rank(flight);
    this.host.show(model, answer, { revision: flight.revision, quality: flight.quality });
    this.reportRest();
  }

  private conclude(problem: Problem, flight: Flight): void {
    this.settled = Math.max(this.settled, rank(flight));
    this.host.fail(problem, { revision: flight.revision, quality: flight.quality });
    this.reportRest();
  }

  private reportRest(): void {
    if (this.isSettled()) this.host.busy(false);
  }

  private isSettled(): boolean {
    return this.settled >= rank({ revision: this.revision, quality: "final" });
  }

  private waitAndRetry(wanted: Wanted<Body>, { retryAfter, isCrowded }: Extract<Answer, { kind: "away" }>): void {
    if (!this.pending || rank(wanted) > rank(this.pending)) this.pending = wanted;
    this.host.away(isCrowded ?? false);
    if (this.retryTimer !== undefined) return;
    const wait = retryAfter ?? RETRY_MILLISECONDS[Math.min(this.retries, RETRY_MILLISECONDS.length - 1)] ?? 1000;
    this.retries++;
    this.retryTimer = this.host.clock.setTimeout(() => {
      this.retryTimer = undefined;
      this.pump();
    }, wait);
  }

  private drop(flight: Flight): void {
    this.flights.delete(flight);
    flight.abort.abort();
  }

  private stopTimers(): void {
    this.host.clock.clearTimeout(this.settleTimer);
    this.settleTimer = undefined;
  }
}

/** Order of answers: by revision, and the full quality of one after its draft. */
function rank(stamp: Stamp): number {
  return 2 * stamp.revision + (stamp.quality === "final" ? 1 : 0);
}
