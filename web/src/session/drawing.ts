// What of the document is evaluated and shown: all of it, whatever group of it is looked at.

import { type GraphDocument, lookedAt } from "../model/document";
import { type DrawnGraph, drawnGraph } from "../model/drawn_graph";
import { fileOutput, viewGraph } from "../model/graph";
import { asObject } from "../model/json";
import type { Store } from "../model/store";
import { localProblem } from "../net/problem";
import type { EvaluateBody } from "../net/requests";
import type { Catalogues } from "./catalogues";
import type { Renderer } from "./renderer";
import type { SessionState } from "./state";

export class Drawing {
  /** What is drawn in a graph that makes no file; empty in others. */
  private source = "";

  constructor(
    private readonly store: Store<SessionState>,
    private readonly catalogues: Catalogues,
    private readonly renderer: Renderer,
  ) {}

  /** Asks for the picture of the present state. */
  evaluate(moving: boolean): void {
    const { document, values } = this.store.get();
    const drawn = document && this.of(document);
    this.source = drawn && drawn.graph !== document.json ? sourceText(drawn) : "";
    this.store.set({ drawn: drawn?.output ?? null });
    if (drawn) {
      this.store.set({ revision: this.renderer.input({ ...drawn, parameters: values }, moving) });
      return;
    }
    this.renderer.rest();
    const isStale = this.store.get().shown !== null;
    this.store.set({
      problem: isStale ? localProblem("Nothing to show", "No node of this graph makes anything to be seen.") : null,
    });
  }

  /** In a graph that makes no file, the selected node is drawn. */
  followSelection(): void {
    const { document, selected } = this.store.get();
    if (!document || selected === null || this.fileOf(document) !== undefined) return;
    const drawn = this.of(document);
    if (drawn && sourceText(drawn) !== this.source) this.evaluate(false);
  }

  /** What evaluates the present state elsewhere; undefined where there is nothing that leaves the graph. */
  fileBody(): EvaluateBody | undefined {
    const { document, values } = this.store.get();
    const output = document ? this.fileOf(document) : undefined;
    return document && output !== undefined ? { graph: document.json, parameters: values, output } : undefined;
  }

  /** What is drawn now, as it is sent: also where no node of the document makes a file. */
  drawnBody(): EvaluateBody | undefined {
    const { document, values } = this.store.get();
    const drawn = document && this.of(document);
    return drawn ? { ...drawn, parameters: values } : undefined;
  }

  private fileOf(document: GraphDocument): string | undefined {
    const catalogue = this.catalogues.ofWhole(document);
    return catalogue && fileOutput(lookedAt(document, []), catalogue);
  }

  private of(document: GraphDocument): DrawnGraph | undefined {
    const { view, selected } = this.store.get();
    const whole = lookedAt(document, []);
    const catalogue = this.catalogues.ofWhole(document);
    if (!catalogue || !view) return undefined;
    if (whole === document) return drawnGraph(document, catalogue, view, selected);
    return drawnGraph(whole, catalogue, viewGraph(whole, catalogue), document.inside[0]?.id ?? null);
  }
}

/** From where what is drawn comes: the same for the same. */
function sourceText({ graph, output }: DrawnGraph): string {
  return JSON.stringify(asObject(graph["nodes"])[output]);
}
