// While the hand rests on the label of a parameter, the model shows how it moves with that parameter: dark where it
// rests, yellow where it is fastest.

import { isSameGraph } from "../model/document";
import type { Store } from "../model/store";
import { fetchSensitivity } from "../net/api";
import type { PictureViewer, SessionState } from "./state";

/** A hand that only passes over labels asks for nothing. */
const PAUSE_MILLISECONDS = 250;

export class Sensitivity {
  private timer = 0;
  private request: AbortController | undefined;
  private isShown = false;

  constructor(
    private readonly store: Store<SessionState>,
    private readonly viewer: () => Promise<PictureViewer>,
  ) {
    let [document, values] = [store.get().document, store.get().values];
    store.subscribe(() => {
      const state = store.get();
      const isSame = isSameGraph(state.document, document) && state.values === values;
      [document, values] = [state.document, state.values];
      // What is shown would be that of another model.
      if (!isSame) this.hide();
    });
  }

  /** Shows how the model moves with a parameter, soon. */
  show(parameter: string): void {
    this.hide();
    this.timer = window.setTimeout(() => void this.load(parameter), PAUSE_MILLISECONDS);
  }

  /** Shows the model as it is again. */
  hide(): void {
    window.clearTimeout(this.timer);
    this.request?.abort();
    this.request = undefined;
    if (!this.isShown) return;
    this.isShown = false;
    void this.viewer().then((viewer) => viewer.showSensitivity(null));
  }

  private async load(parameter: string): Promise<void> {
    const { document, values } = this.store.get();
    if (!document) return;
    const request = new AbortController();
    this.request = request;
    try {
      const bytes = await fetchSensitivity(
        { graph: document.json, parameters: values, by: [parameter] },
        request.signal,
      );
      if (!bytes || request.signal.aborted) return;
      const viewer = await this.viewer();
      const picture = await viewer.decode(bytes);
      if (request.signal.aborted) {
        picture.dispose();
        return;
      }
      this.isShown = true;
      viewer.showSensitivity(picture);
    } catch {
      // It was given up, or cannot be drawn: the model stays as it is.
    }
  }
}
