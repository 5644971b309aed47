// What the page holds: catalogue, examples, the open graph with its parameter values, and what is shown of it.
// Plain TypeScript: React reads the store, the viewer is handed in once it has loaded.

import { readCatalogue, type Catalogue } from "../model/catalogue";
import { readDocument, type CameraPlace, type GraphDocument, type Position } from "../model/document";
import { fileOutput, viewGraph, type ViewGraph } from "../model/graph";
import { asArray, asObject, asString, type Json } from "../model/json";
import { layeredLayout } from "../model/layout";
import { withValue, type Parameter, type ParameterValue, type ParameterValues } from "../model/parameters";
import { createStore, type Store } from "../model/store";
import { evaluate, getJson, isAlive, type EvaluateBody } from "../net/api";
import { Evaluator, type ModelAnswer, type Stamp } from "../net/evaluator";
import { localProblem, type Problem } from "../net/problem";
import type { Report } from "../net/report";

export interface Example {
  id: string;
  title: string;
  description: string;
  figure: string;
  image: string;
  graph: Json;
}

/** A decoded model, as far as the session needs to know it. */
export interface Picture {
  triangles: number;
  vertices: number;
  decodeMilliseconds: number;
  dispose(): void;
}

export interface PictureViewer {
  decode(model: Uint8Array<ArrayBuffer>): Promise<Picture>;
  show(picture: Picture): void;
  /** Shows the first picture of a document, from its camera if it has one. */
  open(picture: Picture, camera: CameraPlace | null): void;
  clear(): void;
  /** A small picture on a clear background, as an address for an <img>. */
  thumbnail(picture: Picture, width: number, height: number): Promise<string>;
}

export interface Shown extends Stamp {
  report: Report;
  model: Uint8Array<ArrayBuffer>;
  triangles: number;
  vertices: number;
  decodeMilliseconds: number;
}

export interface SessionState {
  catalogue: Catalogue | null;
  examples: Example[] | null;
  exampleId: string | null;
  document: GraphDocument | null;
  view: ViewGraph | null;
  positions: Map<string, Position>;
  values: ParameterValues;
  revision: number;
  shown: Shown | null;
  busy: boolean;
  away: boolean;
  problem: Problem | null;
  selected: string | null;
}

const PING_MILLISECONDS = 1500;

const EMPTY: SessionState = {
  catalogue: null,
  examples: null,
  exampleId: null,
  document: null,
  view: null,
  positions: new Map(),
  values: {},
  revision: 0,
  shown: null,
  busy: true,
  away: false,
  problem: null,
  selected: null,
};

export class Session {
  readonly store: Store<SessionState> = createStore(EMPTY);
  private readonly evaluator: Evaluator<EvaluateBody, Picture>;
  private readonly supersedeKey = `page-${crypto.getRandomValues(new Uint32Array(2)).join("-")}`;
  private viewer: Promise<PictureViewer>;
  private giveViewer: (viewer: PictureViewer) => void = () => undefined;
  private refuseViewer: (reason: Error) => void = () => undefined;
  private shownViewer: PictureViewer | undefined;
  private pinging = false;
  private isFirst = true;

  constructor() {
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
      fail: (problem) => this.store.set({ problem, away: false }),
      away: () => this.lost(),
      busy: (busy) => this.store.set({ busy }),
      clock: {
        now: () => performance.now(),
        setTimeout: (run, milliseconds) => window.setTimeout(run, milliseconds),
        clearTimeout: (timer) => window.clearTimeout(timer as number | undefined),
      },
    });
  }

  /** Loads catalogue and examples and opens one: the wanted, else the first. Tries again until the server answers. */
  async start(wanted: string | null): Promise<void> {
    try {
      const [nodes, list] = await Promise.all([getJson("v1/nodes"), getJson("v1/examples")]);
      const examples = asArray(asObject(list)["examples"]).map(readExample);
      this.store.set({ catalogue: readCatalogue(nodes), examples, away: false });
      const example = examples.find((item) => item.id === wanted) ?? finest(examples);
      if (example) this.openExample(example.id);
      else this.store.set({ busy: false });
    } catch {
      this.store.set({ away: true });
      window.setTimeout(() => void this.start(wanted), PING_MILLISECONDS);
    }
  }

  openExample(id: string): void {
    const example = this.store.get().examples?.find((item) => item.id === id);
    if (!example || this.store.get().exampleId === id) return;
    const result = readDocument(example.graph);
    if ("error" in result) this.store.set({ problem: localProblem("This example cannot be opened", result.error) });
    else this.open(result.document, id);
  }

  setParameter(parameter: Parameter, value: ParameterValue, moving: boolean): void {
    const values = withValue(this.store.get().values, parameter, value);
    this.evaluate(values, moving);
  }

  resetParameters(): void {
    this.evaluate({}, true);
  }

  select(node: string | null): void {
    if (node !== this.store.get().selected) this.store.set({ selected: node });
  }

  /** What would be sent for the present state; undefined before a graph is open. */
  body(): EvaluateBody | undefined {
    const { document, catalogue, values } = this.store.get();
    if (!document || !catalogue) return undefined;
    return { graph: document.json, parameters: values, output: fileOutput(document, catalogue) };
  }

  /** Takes a viewer into use; one that replaces another is given what is shown. */
  viewerLoaded(viewer: PictureViewer): void {
    this.giveViewer(viewer);
    this.viewer = Promise.resolve(viewer);
    this.shownViewer = viewer;
    const { shown, document } = this.store.get();
    if (shown) void viewer.decode(shown.model).then((picture) => viewer.open(picture, document?.camera ?? null));
  }

  viewerFailed(reason: string): void {
    this.refuseViewer(new Error(reason));
  }

  private open(document: GraphDocument, exampleId: string): void {
    const { catalogue } = this.store.get();
    if (!catalogue) return;
    const view = viewGraph(document, catalogue);
    const placed = document.positions.size === document.nodes.size;
    const positions = placed ? document.positions : layeredLayout(view);
    this.evaluator.reset();
    this.shownViewer?.clear();
    this.isFirst = true;
    this.store.set({ document, view, positions, exampleId, shown: null, problem: null, selected: null });
    this.evaluate({}, false);
  }

  private evaluate(values: ParameterValues, moving: boolean): void {
    this.store.set({ values });
    const body = this.body();
    if (body) this.store.set({ revision: this.evaluator.input(body, moving) });
  }

  private show(picture: Picture, answer: ModelAnswer, stamp: Stamp): void {
    if (this.isFirst) this.shownViewer?.open(picture, this.store.get().document?.camera ?? null);
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

function readExample(json: Json): Example {
  const item = asObject(json);
  return {
    id: asString(item["id"]),
    title: asString(item["title"]) || asString(item["id"]),
    description: asString(item["description"]),
    figure: typeof item["figure"] === "number" ? String(item["figure"]) : asString(item["figure"]),
    image: asString(item["image"]),
    graph: item["graph"],
  };
}

/** The example shown to someone who asked for none: the twisted surface of figure 5, else the first. */
function finest(examples: Example[]): Example | undefined {
  return examples.find((item) => item.figure === "5") ?? examples[0];
}
