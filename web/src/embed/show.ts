// What an embedding page shows: one stored graph, the values of its sliders, and the newest model for them. Knows no
// React; the view comes when it is loaded.

import { type GraphDocument, readDocument } from "../model/document";
import {
  type Parameter,
  type ParameterValue,
  type ParameterValues,
  parameterValue,
  withValue,
} from "../model/parameters";
import { createStore, type Store } from "../model/store";
import { Evaluator } from "../net/evaluator";
import { localProblem, type Problem } from "../net/problem";
import { type Asked, fetchOutput, fetchStored, outputAddress, valuesFrom } from "../net/stored";
import type { Picture, PictureViewer } from "../session/state";

export interface ShowState {
  document: GraphDocument | null;
  /** What differs from the defaults. */
  values: ParameterValues;
  /** The values that the address of the page gives. */
  given: ParameterValues;
  problem: Problem | null;
  /** The server cannot be reached, or is busy; it is asked again. */
  away: boolean;
  busy: boolean;
  /** How many models were shown. */
  shown: number;
}

const RETRY_MILLISECONDS = 2000;

export class Show {
  readonly store: Store<ShowState> = createStore<ShowState>({
    ...{ document: null, values: {}, given: {}, problem: null, away: false, busy: true, shown: 0 },
  });
  private readonly evaluator: Evaluator<ParameterValues, Picture>;
  private graph = "";
  private output = "";
  private giveViewer: (viewer: PictureViewer) => void = () => undefined;
  private readonly viewer = new Promise<PictureViewer>((resolve) => (this.giveViewer = resolve));

  constructor() {
    const { store } = this;
    this.evaluator = new Evaluator<ParameterValues, Picture>({
      send: (values, { quality }, signal) =>
        fetchOutput(outputAddress(this.graph, this.output, values, quality), signal),
      decode: async ({ model }) => (await this.viewer).decode(model),
      show: (picture) => void this.viewer.then((viewer) => this.present(viewer, picture)),
      discard: (picture) => picture.dispose(),
      fail: (problem) => store.set({ problem, away: false }),
      away: () => store.set({ away: true }),
      busy: (busy) => store.set({ busy }),
      clock: {
        now: () => performance.now(),
        setTimeout: (run, milliseconds) => window.setTimeout(run, milliseconds),
        clearTimeout: (timer) => window.clearTimeout(timer as number | undefined),
      },
    });
  }

  viewerLoaded(viewer: PictureViewer): void {
    this.giveViewer(viewer);
  }

  viewerFailed(): void {
    this.fail(localProblem("The 3D view could not start", "It needs WebGL 2."));
  }

  /** Finds the graph and asks for its first model; again and again while the server cannot be reached. */
  async start(name: string, asked: Asked): Promise<void> {
    try {
      const found = await fetchStored(name);
      if ("problem" in found) return this.fail(found.problem);
      const read = readDocument(found.value.document);
      if ("error" in read) return this.fail(localProblem("The graph cannot be read", read.error));
      const { document } = read;
      const values = valuesFrom(asked.texts, document.parameters);
      if ("problem" in values) return this.fail(values.problem);
      const output = chosenOutput(asked.output, found.value.outputs);
      if (typeof output !== "string") return this.fail(output);
      [this.graph, this.output] = [found.value.name, output];
      const given = document.parameters.reduce<ParameterValues>(
        (all, parameter) => withValue(all, parameter, parameterValue(parameter, values.value)),
        {},
      );
      this.store.set({ document, values: given, given, away: false });
      this.evaluator.input(given, false);
    } catch {
      this.store.set({ away: true });
      window.setTimeout(() => void this.start(name, asked), RETRY_MILLISECONDS);
    }
  }

  set(parameter: Parameter, value: ParameterValue, moving: boolean): void {
    this.change(withValue(this.store.get().values, parameter, value), moving);
  }

  /** Back to what the address of the page gives. */
  reset(): void {
    this.change(this.store.get().given, false);
  }

  private change(values: ParameterValues, moving: boolean): void {
    this.store.set({ values });
    this.evaluator.input(values, moving);
  }

  private present(viewer: PictureViewer, picture: Picture): void {
    const { shown, document } = this.store.get();
    if (shown === 0) viewer.open(picture, document?.camera ?? null);
    else viewer.show(picture);
    this.store.set({ shown: shown + 1, problem: null, away: false });
  }

  private fail(problem: Problem): void {
    this.store.set({ problem, busy: false, away: false });
  }
}

/** The output to show: the one that is asked for, else the first. */
function chosenOutput(asked: string, outputs: readonly string[]): string | Problem {
  const title = "There is no such output";
  if (asked === "") return outputs[0] ?? localProblem(title, "This graph makes no model.");
  if (outputs.includes(asked)) return asked;
  return localProblem(title, `This graph has no output “${asked}”; it has ${outputs.join(", ") || "none"}.`);
}
