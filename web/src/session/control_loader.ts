// Control geometry for what is selected or flagged. It comes with every evaluation; when only the selection changes, it
// is asked for alone.

import { wireType } from "../model/catalogue";
import { type PreviewWish, previewWish } from "../model/preview";
import { firstOf, prefixOf } from "../model/scope";
import type { Store } from "../model/store";
import { fetchPreview } from "../net/api";
import type { ControlInfo, Picture, PictureViewer, SessionState } from "./state";

const NOTHING: PreviewWish = { names: [], faint: new Set() };
/** Going through nodes with the arrow keys should not ask for each. */
const PAUSE_MILLISECONDS = 60;

export class ControlLoader {
  private wish = NOTHING;
  private wished = "";
  private request: AbortController | undefined;
  private timer = 0;

  constructor(
    private readonly store: Store<SessionState>,
    public viewer: Promise<PictureViewer>,
  ) {
    let [before, view, opened] = [store.get().selection, store.get().view, store.get().opened];
    store.subscribe(() => {
      const state = store.get();
      const isSame = state.selection === before && state.view === view && state.opened === opened;
      [before, view, opened] = [state.selection, state.view, state.opened];
      if (!isSame) this.refresh();
    });
  }

  /** An evaluation that brings control geometry begins: it is not asked for alone. */
  expect(): PreviewWish {
    this.cancel();
    this.take(this.wanted());
    return this.wish;
  }

  /** The same for the same wish. */
  get key(): string {
    return this.wished;
  }

  /** Control geometry is here, drawn for the wish `key`. With nothing wanted, or nothing drawable, the last one goes. */
  shown(control: Picture | null, key: string | undefined): void {
    // What is wanted now is on its own way.
    if (key !== this.wished) control?.dispose();
    else void this.viewer.then((viewer) => viewer.showControl(control, this.info()));
  }

  /** Asks for what is wanted now, if that is something else than before. */
  refresh(): void {
    if (keyOf(this.wanted()) !== this.wished) this.renew();
  }

  /** Asks for what is wanted now: no answer brings it, and what is shown may be of old values. */
  renew(): void {
    const wish = this.wanted();
    this.take(wish);
    this.cancel();
    if (wish.names.length === 0) this.shown(null, this.wished);
    else this.timer = window.setTimeout(() => void this.load(wish), PAUSE_MILLISECONDS);
  }

  private async load(wish: PreviewWish): Promise<void> {
    const { document, values } = this.store.get();
    if (!document) return;
    const request = new AbortController();
    this.request = request;
    try {
      const body = { graph: document.json, parameters: values, preview: wish.names };
      const bytes = await fetchPreview(body, request.signal);
      const control = bytes && (await (await this.viewer).decode(bytes));
      if (request.signal.aborted) control?.dispose();
      else this.shown(control, keyOf(wish));
    } catch {
      // Superseded, or not readable; the next selection or evaluation brings another.
    }
  }

  private cancel(): void {
    window.clearTimeout(this.timer);
    this.request?.abort();
    this.request = undefined;
  }

  private take(wish: PreviewWish): void {
    this.wish = wish;
    this.wished = keyOf(wish);
  }

  private wanted(): PreviewWish {
    const { document, view, selection, problem, checked } = this.store.get();
    const prefix = prefixOf(document?.inside ?? []);
    const errors = [...(problem?.errors ?? []), ...(checked?.errors ?? [])];
    const broken = [...errors.map((error) => error.node), ...(problem?.blocked ?? [])]
      .filter((path) => path.startsWith(prefix))
      // What is broken within a group breaks its instance.
      .map((path) => firstOf(path.slice(prefix.length)));
    if (!view) return NOTHING;
    const { names, faint } = previewWish(view, selection, new Set(broken));
    const placed = (name: string): string => prefix + name;
    return { names: names.map(placed), faint: new Set([...faint].map(placed)) };
  }

  private info(): ControlInfo {
    const { catalogue } = this.store.get();
    const ofType = (type: string): string => (catalogue ? wireType(catalogue, type).color : "#8b94a3");
    return { ofType, faint: this.wish.faint };
  }
}

function keyOf({ names, faint }: PreviewWish): string {
  return `${names.join()} ${[...faint].join()}`;
}
