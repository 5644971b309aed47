// The state of the editor that is not the graph: what is open over the canvas, which wire is being drawn, what is said.

import type { ViewWire } from "../model/graph";
import { Habits } from "../model/habits";
import type { LooseEnd } from "../model/search";
import { createStore, type Store } from "../model/store";
import type { Box, Position } from "../model/ui";
import { recall, remember } from "./remembered";
import type { Session } from "./session";

/** A socket of a node. */
export interface SocketPlace {
  node: string;
  side: "output" | "input";
  name: string;
}

/** The search for a node type: where it stands on the screen, where the node goes, what is done with it. */
export interface Search {
  screen: Position;
  place: Position;
  /** A wire was dropped here. */
  loose?: SocketPlace & { types: readonly string[] };
  /** The node goes into this wire. */
  wire?: ViewWire;
  /** The node takes the place of this one. */
  replaced?: string;
}

export type MenuTarget =
  | { kind: "canvas"; place: Position }
  | { kind: "node"; id: string }
  | { kind: "wire"; wire: ViewWire }
  | { kind: "area"; key: string };

export interface Menu {
  screen: Position;
  target: MenuTarget;
}

/** A wire under the hand: every socket it may not end at, with the reason; sockets that are not listed take it. */
export interface Wiring {
  start: SocketPlace;
  refusals: ReadonlyMap<string, string>;
}

/** What is said of a socket beside it. */
export interface Inspected {
  screen: Position;
  side: "output" | "input";
  title: string;
  description: string;
  lines: readonly string[];
}

export interface EditorState {
  search: Search | null;
  menu: Menu | null;
  /** A list of sockets that the given one can be connected to. */
  connecting: (SocketPlace & { screen: Position }) | null;
  inspected: Inspected | null;
  finding: boolean;
  help: boolean;
  wiring: Wiring | null;
  /** The wire that a dragged node would be put into. */
  target: string | null;
  /** Selected wires. */
  wires: ReadonlySet<string>;
  /** Nodes all of whose inputs are shown. */
  unfolded: ReadonlySet<string>;
  /** The node whose name is being typed. */
  renaming: string | null;
  /** What was done or refused last, said aloud and shown for a moment. */
  notice: { text: string; tone: "said" | "refused"; count: number } | null;
  /** The left button moves the canvas instead of drawing a box. */
  leftPans: boolean;
  /** Times are shown on every node. */
  times: boolean;
}

/** What the canvas does for others. */
export interface Canvas {
  /** A point of the screen as a place in the graph. */
  placeAt(screen: Position): Position;
  screenAt(place: Position): Position;
  /** Where the pointer is over the canvas, or the canvas's middle, on the screen. */
  pointer(): Position;
  isUnderPointer(): boolean;
  /** The measured boxes of nodes, by name. */
  boxes(): Map<string, Box>;
  /** Brings the nodes into view; all without any. */
  fit(ids?: Iterable<string>): void;
  focusNode(id: string): void;
  focusSocket(socket: SocketPlace): void;
}

const LEFT_PANS = "dini.canvas.leftPans";
const TIMES = "dini.canvas.times";

export class Editor {
  readonly store: Store<EditorState>;
  canvas: Canvas | undefined;
  /** What is given the focus once the next canvas is there: a node, or the canvas itself. */
  nextFocus: { node: string | null } | undefined;
  private notices = 0;
  private learned: Habits | undefined;

  constructor(readonly session: Session) {
    // A finger cannot hold another button or a key, so it moves the canvas.
    const isCoarse = matchMedia("(pointer: coarse)").matches;
    this.store = createStore<EditorState>({
      ...{
        search: null,
        menu: null,
        connecting: null,
        inspected: null,
        finding: false,
        help: false,
        wiring: null,
        target: null,
      },
      ...{ wires: new Set<string>(), unfolded: new Set<string>(), renaming: null, notice: null },
      leftPans: (recall(LEFT_PANS) ?? (isCoarse ? "yes" : "no")) === "yes",
      times: recall(TIMES) !== "no",
    });
    let opened = session.store.get().opened;
    session.store.subscribe(() => {
      const state = session.store.get();
      if (state.opened === opened) return;
      opened = state.opened;
      this.store.set({
        wires: new Set(),
        unfolded: new Set(),
        renaming: null,
        search: null,
        menu: null,
        connecting: null,
      });
    });
  }

  /** What is usually connected to what: in the examples. */
  habits(): Habits | undefined {
    const { catalogue, examples } = this.session.store.get();
    if (!this.learned && catalogue && examples) {
      this.learned = new Habits(
        catalogue,
        examples.map(({ graph }) => graph),
      );
    }
    return this.learned;
  }

  /** Says what was done; screen readers hear it, and it is shown at the foot of the canvas. */
  say(text: string, tone: "said" | "refused" = "said"): void {
    this.store.set({ notice: { text, tone, count: ++this.notices } });
  }

  openSearch(search: Partial<Search> = {}): void {
    const canvas = this.canvas;
    if (!canvas) return;
    const screen = search.screen ?? canvas.pointer();
    this.closeAll();
    this.store.set({ search: { place: canvas.placeAt(screen), ...search, screen } });
  }

  openMenu(menu: Menu): void {
    this.closeAll();
    this.store.set({ menu });
  }

  openConnect(socket: SocketPlace, screen: Position): void {
    this.closeAll();
    this.store.set({ connecting: { ...socket, screen } });
  }

  /** Closes what is open over the canvas. True if something was. */
  closeAll(): boolean {
    const { search, menu, connecting, finding } = this.store.get();
    if (!search && !menu && !connecting && !finding) return false;
    this.store.set({ search: null, menu: null, connecting: null, finding: false });
    return true;
  }

  unfold(ids: Iterable<string>, on: boolean): void {
    const unfolded = new Set(this.store.get().unfolded);
    for (const id of ids) {
      if (on) unfolded.add(id);
      else unfolded.delete(id);
    }
    this.store.set({ unfolded });
  }

  setLeftPans(on: boolean): void {
    remember(LEFT_PANS, on ? "yes" : "no");
    this.store.set({ leftPans: on });
  }

  setTimes(on: boolean): void {
    remember(TIMES, on ? "yes" : "no");
    this.store.set({ times: on });
  }
}

/** A socket as a key of maps. */
export function socketKey({ node, side, name }: SocketPlace): string {
  return `${node} ${side} ${name}`;
}

/** The loose end of a wire as the search takes it. */
export function looseEnd(search: Search): LooseEnd | undefined {
  return search.loose && { side: search.loose.side, types: search.loose.types };
}
