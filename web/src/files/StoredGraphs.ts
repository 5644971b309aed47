// Graphs that the server keeps: opening one, keeping the open one, and what to do when somebody else was quicker.

import { fileName } from "../model/format";
import type { Json } from "../model/json";
import { documentWithValues } from "../model/saved_values";
import { createStore, type Store } from "../model/store";
import { deleteGraph, listVersions, readGraph, type StoredVersion, writeGraph } from "../net/graph_store";
import { problemText } from "../net/problem";
import type { Session } from "../session/session";
import type { Origin } from "../session/state";
import { documentText } from "./document_text";
import { storedPlace } from "./drafts";

const NOT_FOUND = 404;
const PRECONDITION_FAILED = 412;

/** What the page's other files do for these. */
export interface StoredHost {
  say(text: string, tone: "good" | "bad"): void;
  show(dialog: "keep" | "conflict" | null): void;
  open(json: Json, origin: Origin, name: string): boolean;
  /** The document was kept and has not been changed since it was sent. */
  kept(origin: Origin): void;
}

export interface StoredState {
  /** The name that the dialog for keeping begins with. */
  name: string;
  /** The version that stands where the open document should go. */
  conflict: StoredVersion | null;
}

export class StoredGraphs {
  readonly store: Store<StoredState> = createStore<StoredState>({ name: "", conflict: null });

  constructor(
    private readonly session: Session,
    private readonly host: StoredHost,
  ) {}

  /** Opens a graph by its name, with its version as `name@3` or the current one. Answers whether it is open. */
  async open(name: string): Promise<boolean> {
    const found = await readGraph(name);
    if ("problem" in found) {
      this.host.say(`${name} was not opened. ${problemText(found.problem)}`, "bad");
      return false;
    }
    const { json, version } = found.value;
    if (!this.host.open(json, { kind: "stored", ...placeOf(version) }, name)) return false;
    this.host.show(null);
    return true;
  }

  /** Keeps the open document as the next version of what it was, or asks for a name. */
  async keep(): Promise<void> {
    const place = storedPlace(this.session.store.get().origin);
    if (place) await this.write(place.id, place.tag);
    else this.ask();
  }

  /** Asks for the name to keep the document under, beginning with a free one like this. */
  ask(name = idOf(this.session.store.get().document?.title ?? "")): void {
    this.store.set({ name });
    this.host.show("keep");
  }

  /** Keeps the open document under a name: in place of the version with this tag, or where nothing is yet. */
  async write(id: string, replaces?: string): Promise<void> {
    const { document, values, opened } = this.session.store.get();
    if (!document) return;
    const written = await writeGraph(id, documentText(documentWithValues(document, values)), replaces);
    if ("problem" in written) {
      this.host.say(`${id} was not saved. ${problemText(written.problem)}`, "bad");
      return;
    }
    if ("conflict" in written) {
      await this.meet(id);
      return;
    }
    const { value } = written;
    this.host.show(null);
    this.host.say(`Saved ${value.id} on the server, version ${value.version}`, "good");
    const now = this.session.store.get();
    // What was edited while the request was under way is not kept, but it is an edit of this version.
    if (now.opened === opened)
      this.keptAs({ kind: "stored", ...placeOf(value) }, now.document === document && now.values === values);
  }

  /** Takes a graph out of the server's list; the open one, if it was that, is unsaved then. Answers what went wrong. */
  async remove(version: StoredVersion): Promise<string> {
    const failed = await deleteGraph(version);
    if (failed) {
      const isOther = failed.problem.status === PRECONDITION_FAILED;
      return isOther
        ? `${version.id} was saved meanwhile. Look at it again before it is deleted.`
        : problemText(failed.problem);
    }
    if (storedPlace(this.session.store.get().origin)?.id === version.id) this.session.markUnkept();
    return "";
  }

  private keptAs(origin: Origin, isSame: boolean): void {
    if (isSame) this.host.kept(origin);
    else this.session.store.set({ origin });
  }

  /** Shows what stands under a name beside the open document. */
  private async meet(id: string): Promise<void> {
    const present = await readGraph(id);
    if ("problem" in present && present.problem.status === NOT_FOUND) {
      // Nothing stands there to be compared with, or to be replaced.
      this.host.say(`${id} was deleted on the server. Save it again under a name.`, "bad");
      this.ask(id);
      return;
    }
    const versions = await listVersions(id);
    const current = "value" in versions ? versions.value[0] : undefined;
    if (!current) {
      this.host.say(`${id} was not saved: the server keeps something else there by now.`, "bad");
      return;
    }
    this.store.set({ conflict: current });
    this.host.show("conflict");
  }
}

/** A name that the server takes, made of a title. */
export function idOf(title: string): string {
  const name = fileName(title).replace(/[^\w-]/g, "");
  return (/^[A-Za-z]/.test(name) ? name : `graph-${name}`).slice(0, 64);
}

export const STORED_NAME = /^[A-Za-z][\w-]{0,63}$/;

function placeOf({ id, version, tag }: StoredVersion): { id: string; version: number; tag: string } {
  return { id, version, tag };
}
