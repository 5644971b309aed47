// What the server says of the whole graph without evaluating it, asked once changes have paused for a moment.

import type { Store } from "../model/store";
import { validate } from "../net/validation";
import type { SessionState } from "./state";

const PAUSE_MILLISECONDS = 150;

export class WholeCheck {
  private timer = 0;
  private request: AbortController | undefined;

  constructor(private readonly store: Store<SessionState>) {}

  soon(): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.ask(), PAUSE_MILLISECONDS);
  }

  private async ask(): Promise<void> {
    const { document, values } = this.store.get();
    if (!document) return;
    this.request?.abort();
    const request = new AbortController();
    this.request = request;
    const checked = await validate({ graph: document.json, parameters: values }, request.signal);
    if (checked && this.request === request && !request.signal.aborted) this.store.set({ checked });
  }
}
