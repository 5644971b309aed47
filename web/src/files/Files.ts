// Opening, saving, sharing and recovering the open document. Plain TypeScript; the components read its store.

import { setCamera } from "../model/edit";
import { fileName } from "../model/format";
import { asObject, type Json, parseJsonBytes } from "../model/json";
import { documentWithValues } from "../model/saved_values";
import { createStore, type Store } from "../model/store";
import { readGraph } from "../net/graph_store";
import { problemText } from "../net/problem";
import { addGroups } from "../session/grouping";
import type { Session } from "../session/session";
import type { Origin } from "../session/state";
import { Autosave } from "./autosave";
import { commandLineText, curlText } from "./commands";
import { askForFile, type FileHandle, writeFile } from "./disk";
import { documentText } from "./document_text";
import { openDraftDatabase } from "./draft_database";
import { type Draft, originOf, storedPlace } from "./drafts";
import { graphInGlb, parametersInGlb } from "./glb_graph";
import { addImport, MESH_FILE, uploadMesh } from "./import_mesh";
import { KeptDrafts } from "./kept_drafts";
import { meshName, rememberMesh } from "./mesh_names";
import { StoredGraphs } from "./StoredGraphs";
import { LONGEST_LINK, packGraph, unpackGraph } from "./share";
import { recallOpen, tabName } from "./tab";

export interface FilesState {
  dialog: "model-file" | "recover" | "share" | "open-stored" | "keep" | "conflict" | null;
  /** What was done, or went wrong, for a moment. */
  note: { text: string; tone: "good" | "bad"; action?: NoteAction } | null;
  link: string;
}

/** What may be done about what was said. */
export interface NoteAction {
  title: string;
  run(): void;
}

/** What a page begins with instead of an example. */
export interface Beginning {
  json: Json;
  origin: Origin;
}

const NOTE_MILLISECONDS = 6000;
const kept = new WeakMap<Session, Files>();

/** The files of a session; one for each. */
export function filesOf(session: Session): Files {
  const files = kept.get(session) ?? new Files(session);
  kept.set(session, files);
  return files;
}

export class Files {
  readonly store: Store<FilesState> = createStore<FilesState>({ dialog: null, note: null, link: "" });
  readonly drafts = new KeptDrafts(openDraftDatabase());
  private readonly tab = tabName();
  readonly autosave: Autosave;
  readonly stored: StoredGraphs;
  private handle: { file: FileHandle; opened: number } | undefined;
  private timer = 0;

  constructor(private readonly session: Session) {
    this.stored = new StoredGraphs(session, {
      say: (text, tone) => this.say(text, tone),
      show: (dialog) => this.show(dialog),
      open: (json, origin, name) => this.open(json, origin, name),
      kept: (origin) => {
        session.markSaved(origin);
        this.autosave.saved();
      },
    });
    this.autosave = new Autosave(session, this.drafts, this.tab, (draft) => this.sayKept(draft));
  }

  /** What this load of the page takes up: the graph in its address, else what was open in the same tab. */
  async beginning(): Promise<Beginning | undefined> {
    const packed = new URLSearchParams(location.hash.slice(1)).get("g");
    if (packed !== null) {
      const result = await unpackGraph(packed);
      if ("json" in result) return { json: result.json, origin: { kind: "shared" } };
      this.say(result.error, "bad");
      return undefined;
    }
    const name = new URLSearchParams(location.hash.slice(1)).get("graph");
    if (name !== null) {
      const found = await readGraph(name);
      if ("value" in found) {
        const { id, version, tag } = found.value.version;
        return { json: found.value.json, origin: { kind: "stored", id, version, tag } };
      }
      this.say(`${name} was not opened. ${problemText(found.problem)}`, "bad");
      return undefined;
    }
    const open = recallOpen();
    if (open && !open.draft) return open;
    const isMine = (draft: Draft): boolean => draft.tab === this.tab && draft.address === location.hash;
    const mine = open?.draft ?? (await this.drafts.list()).find(isMine);
    if (!mine) return undefined;
    // The address will not name an example any more, and another reload has to find it again.
    const { ancestor, ...draft } = mine;
    void this.drafts.put({ ...draft, address: "" });
    if (ancestor !== undefined) void this.drafts.remove(ancestor);
    this.say(`“${mine.title}” is open again with what was not saved.`);
    return { json: mine.json, origin: originOf(mine) };
  }

  recover(draft: Draft): void {
    this.open(draft.json, originOf(draft), draft.title);
    this.show(null);
  }

  async ask(): Promise<void> {
    const asked = await askForFile();
    if (asked) await this.take(asked.file, asked.handle);
  }

  /** Opens a graph, or imports a mesh, by what the file is. */
  async take(file: File, handle?: FileHandle): Promise<void> {
    if (/\.glb$/i.test(file.name)) return this.takeGlb(file);
    if (MESH_FILE.test(file.name)) return this.importMesh(file);
    let json: Json;
    try {
      json = parseJsonBytes(await file.arrayBuffer());
    } catch (error) {
      const what = error instanceof TypeError ? "text in UTF-8" : "JSON";
      this.say(`${file.name} is no graph: it is not ${what}.`, "bad");
      return;
    }
    const added = addGroups(this.session, json);
    if (added !== undefined) {
      this.say(added);
      return;
    }
    if (this.open(json, { kind: "file", name: file.name }, file.name) && handle) {
      this.handle = { file: handle, opened: this.session.store.get().opened };
    }
  }

  /** Writes the document to where it came from, the server or its file, or asks for a file. */
  async save(elsewhere = false): Promise<void> {
    const { document, values, origin, opened } = this.session.store.get();
    if (!document) return;
    if (!elsewhere && storedPlace(origin)) {
      await this.stored.keep();
      return;
    }
    const name = origin.kind === "file" ? origin.name : `${fileName(document.title)}.json`;
    const known = !elsewhere && this.handle?.opened === opened ? this.handle.file : undefined;
    const written = await writeFile(documentText(documentWithValues(document, values)), name, known);
    if (!written) return;
    const now = this.session.store.get();
    const isSame = now.document === document && now.values === values;
    if (written !== "download") this.handle = { file: written, opened };
    const kept = written === "download" ? name : written.name;
    // What was edited while the dialog was open is not in the file.
    if (isSame) {
      this.session.markSaved({ kind: "file", name: kept });
      this.autosave.saved();
    }
    this.say(`Saved ${kept}`);
  }

  /** Puts a link with the whole graph on the clipboard; one that is too long is not offered. */
  async share(): Promise<void> {
    const { document, values } = this.session.store.get();
    if (!document) return;
    const camera = this.session.view();
    const seen = camera ? setCamera(camera)(document) : document;
    const packed = await packGraph(documentWithValues(seen, values));
    const address = new URL(location.href);
    address.search = "";
    address.hash = `g=${packed}`;
    this.store.set({ link: address.href.length > LONGEST_LINK ? "" : address.href, dialog: "share" });
  }

  async copy(text: string | undefined, what: string): Promise<void> {
    if (text === undefined) {
      this.say("No node of this graph makes a file, so there is no command for it.", "bad");
      return;
    }
    try {
      await navigator.clipboard.writeText(text);
      this.say(`Copied ${what}`);
    } catch {
      this.say("The browser did not allow copying.", "bad");
    }
  }

  curl(): string | undefined {
    return curlText(this.session);
  }

  commandLine(): string | undefined {
    return commandLineText(this.session, meshName);
  }

  show(dialog: FilesState["dialog"]): void {
    this.store.set({ dialog });
  }

  say(text: string, tone: "good" | "bad" = "good", action?: NoteAction): void {
    window.clearTimeout(this.timer);
    this.store.set({ note: { text, tone, action } });
    const milliseconds = action ? 2 * NOTE_MILLISECONDS : NOTE_MILLISECONDS;
    this.timer = window.setTimeout(() => this.store.set({ note: null }), milliseconds);
  }

  /** Another document was opened over one that was not saved. */
  private sayKept(draft: Draft): void {
    this.say(`“${draft.title}” was not saved. It is kept under File, Recover.`, "good", {
      title: "Go back to it",
      run: () => this.recover(draft),
    });
  }

  private open(json: Json, origin: Parameters<Session["openDocument"]>[1], name: string): boolean {
    const error = this.session.openDocument(json, origin);
    if (error === undefined) return true;
    this.say(`${name} was not opened. ${error}`, "bad");
    return false;
  }

  private async takeGlb(file: File): Promise<void> {
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const content = graphInGlb(bytes);
      if (content.kind === "foreign") return await this.importMesh(file);
      if (content.kind === "graph") {
        // Whoever made it elsewhere gave the values beside the graph.
        const ui = { values: parametersInGlb(bytes), ...asObject(content.json["ui"]) };
        this.open({ ...content.json, ui }, { kind: "file", name: file.name.replace(/\.glb$/i, ".json") }, file.name);
        return;
      }
      const short = content.hash.slice(0, 12);
      this.say(
        `${file.name} names its graph only by its hash ${short}…; a model exported here with “Graph inside” can be opened.`,
        "bad",
      );
    } catch (error) {
      this.say(`${file.name} was not opened. ${error instanceof Error ? error.message : ""}`, "bad");
    }
  }

  private async importMesh(file: File): Promise<void> {
    this.say(`Sending ${file.name}…`);
    const result = await uploadMesh(file);
    const { document, catalogue } = this.session.store.get();
    if ("error" in result) this.say(`${file.name} was not imported. ${result.error}`, "bad");
    if ("error" in result || !document || !catalogue) return;
    rememberMesh(result.sha256, file.name);
    const added = addImport(document, catalogue, result.sha256);
    if (!added) {
      this.say("This server has no node for meshes.", "bad");
      return;
    }
    this.session.edit(`Import ${file.name}`, added.edit);
    this.session.select([added.id]);
    this.say(`Imported ${file.name}`);
  }
}
