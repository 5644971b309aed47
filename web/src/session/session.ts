// The open graph and every way it changes: by editing, by its parameters, by opening another. Plain TypeScript: React
// reads the store, the viewer is handed in once it has loaded.

import { readCatalogue } from "../model/catalogue";
import {
  type CameraPlace,
  emptyDocument,
  type GraphDocument,
  isSameGraph,
  lookedAt,
  readDocument,
} from "../model/document";
import { type Edit, moveNodes, setInput } from "../model/edit";
import { changeParameter } from "../model/edit_parameters";
import { viewGraph } from "../model/graph";
import { History } from "../model/history";
import { asArray, asObject, type Json } from "../model/json";
import { layeredLayout } from "../model/layout";
import {
  type Parameter,
  type ParameterValue,
  type ParameterValues,
  sameValue,
  sameValues,
  withValue,
} from "../model/parameters";
import { type Inside, prefixOf } from "../model/scope";
import { createStore, type Store } from "../model/store";
import { getJson } from "../net/api";
import { localProblem } from "../net/problem";
import type { EvaluateBody } from "../net/requests";
import { Catalogues } from "./catalogues";
import { Drawing } from "./drawing";
import { finest, inOrderOfFigures, readExample } from "./examples";
import { placeInside, placeOf } from "./places";
import { Renderer } from "./renderer";
import { Sensitivity } from "./sensitivity";
import { EMPTY, type Origin, type PictureViewer, type SessionState, type Sight } from "./state";
import { Thumbnails } from "./thumbnails";
import { WholeCheck } from "./whole_check";

const RETRY_MILLISECONDS = 1500;

/** What undo brings back. */
interface Snapshot {
  document: GraphDocument;
  values: ParameterValues;
}

export interface EditOptions {
  /** Edits with the same key, one after the other, are one step of undo. */
  gesture?: string;
  /** More of its kind will follow at once: a draft is enough until then. */
  moving?: boolean;
  /** Values of parameters that come with the edit. */
  values?: ParameterValues;
}

export class Session {
  readonly store: Store<SessionState> = createStore(EMPTY);
  private readonly renderer = new Renderer(this.store);
  readonly thumbnails = new Thumbnails(this.store, () => this.renderer.loaded);
  readonly sensitivity = new Sensitivity(this.store, () => this.renderer.loaded);
  private readonly history = new History<Snapshot>();
  private saved: Json;
  private savedValues: ParameterValues = {};
  private readonly catalogues = new Catalogues();
  private readonly drawing = new Drawing(this.store, this.catalogues, this.renderer);
  private readonly check = new WholeCheck(this.store);
  /** How the document that is opened next is looked at. */
  private sight: Sight | undefined;

  /**
   * Loads catalogue and examples and opens a document: `first` if there is one, else the wanted example, else the first.
   * It is looked at as `sight` says. Tries again until the server answers.
   */
  async start(wanted: string | null, first?: { json: Json; origin: Origin }, sight?: Sight): Promise<void> {
    try {
      const [nodes, list] = await Promise.all([getJson("v1/nodes"), getJson("v1/examples")]);
      const examples = inOrderOfFigures(asArray(asObject(list)["examples"]).map(readExample));
      const catalogue = readCatalogue(nodes);
      this.catalogues.nodes = catalogue;
      this.store.set({ catalogue, examples, away: false });
      this.sight = sight;
      const isOpen = first && this.openDocument(first.json, first.origin) === undefined;
      const example = examples.find((item) => item.id === wanted) ?? finest(examples);
      if (isOpen) return;
      if (example) this.openExample(example.id);
      else this.newDocument();
    } catch {
      this.store.set({ away: true });
      window.setTimeout(() => void this.start(wanted, first, sight), RETRY_MILLISECONDS);
    }
  }

  openExample(id: string): void {
    const { examples, exampleId, isChanged } = this.store.get();
    const example = examples?.find((item) => item.id === id);
    if (!example || (exampleId === id && !isChanged)) return;
    const error = this.openDocument(example.graph, { kind: "example", id });
    if (error !== undefined) this.store.set({ problem: localProblem("This example cannot be opened", error) });
  }

  /** Opens a document in place of the present one. Answers a sentence for the person if it cannot be read. */
  openDocument(json: Json, origin: Origin): string | undefined {
    const result = readDocument(json);
    if ("error" in result) return result.error;
    this.open(result.document, origin, result.values);
    return undefined;
  }

  newDocument(): void {
    this.open(emptyDocument(), { kind: "new" });
  }

  /** The present document is what is kept under `origin`. */
  markSaved(origin: Origin): void {
    const { document, values } = this.store.get();
    this.saved = document?.json;
    this.savedValues = values;
    this.store.set({ origin, exampleId: exampleOf(origin), isChanged: false, isAdjusted: false });
  }

  /** The present document is kept nowhere any more. */
  markUnkept(): void {
    this.saved = undefined;
    this.store.set({ origin: { kind: "new" }, exampleId: null, isChanged: true });
  }

  /** Changes the document. An edit that answers the document it was given changes nothing. */
  edit(label: string, change: Edit, { gesture, moving = false, values: given }: EditOptions = {}): void {
    const { document, values } = this.store.get();
    if (!document) return;
    const next = change(document);
    if (next === document) return;
    this.history.record({ document, values }, label, gesture);
    this.replace({ document: next, values: knownValues(given ? { ...values, ...given } : values, next) }, moving);
  }

  /** Writes a literal to a node's input; undefined brings its default back. */
  setInput(node: string, port: string, value: Json, options: EditOptions = {}): void {
    this.edit(`Change ${port}`, setInput(node, port, value), { gesture: `input ${node}.${port}`, ...options });
  }

  setParameter(
    parameter: Parameter,
    value: ParameterValue,
    moving: boolean,
    gesture = `parameter ${parameter.name}`,
  ): void {
    const { document, values } = this.store.get();
    if (!document) return;
    if (document.inside.length > 0) {
      // In a group an input has no value of its own, only what instances are given that leave it out.
      const change = changeParameter(parameter.name, { default: value as Json });
      this.edit(`Change ${parameter.label}`, change, { gesture, moving });
      return;
    }
    const next = withValue(values, parameter, value);
    if (sameValues(next, values)) return;
    this.history.record({ document, values }, `Change ${parameter.label}`, gesture);
    this.replace({ document, values: next }, moving);
  }

  resetParameters(): void {
    const { document, values } = this.store.get();
    if (!document) return;
    this.history.record({ document, values }, "Reset all parameters");
    this.replace({ document, values: {} }, true);
  }

  /** Gives the form other values, in one step. */
  takeValues(values: ParameterValues, label: string): void {
    const { document, values: present } = this.store.get();
    if (!document || sameValues(values, present)) return;
    this.history.record({ document, values: present }, label);
    this.replace({ document, values }, false);
  }

  undo(): void {
    this.travel((present) => this.history.undo(present));
  }

  redo(): void {
    this.travel((present) => this.history.redo(present));
  }

  /** Looks into the group that a node stands for. */
  enter(id: string): void {
    const { document } = this.store.get();
    const inside = document && placeInside(document, id);
    if (inside) this.lookAt(inside, []);
  }

  /** Looks at what is around the group, so many steps out; selects where it came from. */
  leave(steps = 1): void {
    const { document } = this.store.get();
    const inside = document?.inside.slice(0, -steps) ?? [];
    const left = document?.inside[inside.length];
    if (left) this.lookAt(inside, [left.id]);
  }

  /** Selects a node by its path, "ring/circle", in the group where it stands. False if there is none. */
  goTo(path: string): boolean {
    const { document } = this.store.get();
    const place = document && placeOf(document, path);
    if (!document || !place) return false;
    if (prefixOf(place.inside) === prefixOf(document.inside)) this.select([place.id]);
    else this.lookAt(place.inside, [place.id]);
    return true;
  }

  /** The hand has let go: the next change is a step of its own. */
  endGesture(): void {
    this.history.endGesture();
  }

  /** The gesture did not happen: everything is as before it, and nothing is left to undo or redo of it. */
  cancelGesture(gesture: string): void {
    this.travel(() => this.history.cancel(gesture));
  }

  /** Gives up waiting for the server; what is shown stays, marked as out of date. */
  stop(): void {
    this.renderer.stop();
  }

  /** Asks again for the picture, and waits for no answer to what was asked before. */
  retry(): void {
    if (!this.store.get().document) return;
    this.renderer.giveUp();
    this.drawing.evaluate(false);
    this.check.soon();
  }

  /** Selects nodes by their names, frames and notes by their keys, and nothing else. */
  select(ids: Iterable<string>): void {
    const { document, selection, areas, selected } = this.store.get();
    const wanted = [...ids];
    const nodes = new Set(wanted.filter((id) => document?.nodes.has(id)));
    const others = new Set(wanted.filter((id) => id.includes(":")));
    const last = wanted.filter((id) => nodes.has(id)).at(-1) ?? null;
    const kept = selected !== null && nodes.has(selected) && nodes.size > 1 ? selected : last;
    if (isSameSet(nodes, selection) && isSameSet(others, areas)) return;
    this.store.set({ selection: nodes, areas: others, selected: kept });
    this.drawing.followSelection();
  }

  /** What evaluates the present state elsewhere; undefined where there is nothing that leaves the graph. */
  body(): EvaluateBody | undefined {
    return this.drawing.fileBody();
  }

  /** What is drawn now, as it is sent: also where no node of the document makes a file. */
  drawnBody(): EvaluateBody | undefined {
    return this.drawing.drawnBody();
  }

  /** The view of the model, once there is one. Rejects where it cannot start. */
  get viewer(): Promise<PictureViewer> {
    return this.renderer.loaded;
  }

  /** Shows again what was evaluated last, after something else was shown in its place. */
  showAgain(): void {
    this.renderer.showAgain();
  }

  /** How the document is looked at now. */
  lookedAt(): Sight {
    return { camera: this.renderer.cameraPlace, selection: [...this.store.get().selection] };
  }

  /** The view as a document keeps it; null while it is the one that the document opens with. */
  view(): CameraPlace | null {
    return this.renderer.pictureCamera;
  }

  viewerLoaded(viewer: PictureViewer): void {
    this.renderer.viewerLoaded(viewer);
  }

  viewerFailed(reason: string): void {
    this.renderer.viewerFailed(reason);
  }

  private open(read: GraphDocument, origin: Origin, values: ParameterValues = {}): void {
    const { opened } = this.store.get();
    const catalogue = this.catalogues.of(read);
    if (!catalogue) return;
    const document = this.placed(read);
    this.saved = document.json;
    this.savedValues = values;
    this.history.clear();
    const { sight } = this;
    this.sight = undefined;
    this.renderer.reset(sight?.camera);
    this.store.set({
      ...{
        document,
        catalogue,
        origin,
        opened: opened + 1,
        exampleId: exampleOf(origin),
        view: viewGraph(document, catalogue),
      },
      ...{ values, isChanged: false, isAdjusted: false, shown: null, problem: null, checked: null },
      ...{ selection: new Set<string>(), areas: new Set<string>(), selected: null, ...this.steps() },
    });
    if (sight) this.select(sight.selection);
    this.drawing.evaluate(false);
    this.check.soon();
  }

  private travel(step: (present: Snapshot) => Snapshot | undefined): void {
    const { document, values } = this.store.get();
    const state = document && step({ document, values });
    if (state) this.replace(state, false);
  }

  private replace({ document, values }: Snapshot, moving: boolean): void {
    const before = this.store.get();
    const catalogue = this.catalogues.of(document);
    if (!catalogue || !before.document) return;
    // In another group the same names are other nodes.
    const isHere = prefixOf(document.inside) === prefixOf(before.document.inside);
    const isLeft = (id: string): boolean => isHere && document.nodes.has(id);
    const selection = new Set([...before.selection].filter(isLeft));
    this.store.set({
      ...{ document, values, catalogue, view: viewGraph(document, catalogue, before.view ?? undefined) },
      ...{ isChanged: document.json !== this.saved, isAdjusted: !sameValues(values, this.savedValues) },
      ...this.steps(),
      selection: selection.size === before.selection.size ? before.selection : selection,
      areas: isHere ? before.areas : new Set<string>(),
      selected: before.selected !== null && isLeft(before.selected) ? before.selected : null,
    });
    if (isSameGraph(document, before.document) && values === before.values) return;
    this.drawing.evaluate(moving);
    this.check.soon();
  }

  private steps(): Pick<SessionState, "canUndo" | "canRedo" | "undoLabel" | "redoLabel"> {
    const { undoLabel, redoLabel } = this.history;
    return { undoLabel, redoLabel, canUndo: undoLabel !== undefined, canRedo: redoLabel !== undefined };
  }

  /** The document with a place for every node. */
  private placed(document: GraphDocument): GraphDocument {
    const catalogue = this.catalogues.of(document);
    if (!catalogue || document.positions.size === document.nodes.size) return document;
    return moveNodes(layeredLayout(viewGraph(document, catalogue)))(document);
  }

  private lookAt(inside: readonly Inside[], selection: readonly string[]): void {
    const { document } = this.store.get();
    if (!document) return;
    const next = this.placed(lookedAt(document, inside));
    // Places that a group is given because it has none are no change of the person's.
    if (this.saved === document.json) this.saved = next.json;
    const catalogue = this.catalogues.of(next);
    if (!catalogue) return;
    this.store.set({
      ...{ document: next, catalogue, view: viewGraph(next, catalogue) },
      ...{ selection: new Set<string>(), areas: new Set<string>(), selected: null },
    });
    this.select(selection);
  }
}

function exampleOf(origin: Origin): string | null {
  return origin.kind === "example" ? origin.id : null;
}

/** The values of parameters that are still there and do not equal their default. */
function knownValues(values: ParameterValues, document: GraphDocument): ParameterValues {
  const { parameters } = lookedAt(document, []);
  const known = Object.entries(values).filter(([name, value]) => {
    const parameter = parameters.find((item) => item.name === name);
    return parameter && !sameValue(value, parameter.initial);
  });
  return known.length === Object.keys(values).length ? values : Object.fromEntries(known);
}

function isSameSet(a: ReadonlySet<string>, b: ReadonlySet<string>): boolean {
  return a.size === b.size && [...a].every((item) => b.has(item));
}
