// What the page holds, as its parts read it.

import type { Catalogue } from "../model/catalogue";
import type { CameraPlace, GraphDocument } from "../model/document";
import type { ViewGraph } from "../model/graph";
import type { Json } from "../model/json";
import type { ParameterValues } from "../model/parameters";
import type { Stamp } from "../net/evaluator";
import type { Problem } from "../net/problem";
import type { Report } from "../net/report";
import type { Validation } from "../net/validation";

export interface Example {
  id: string;
  title: string;
  description: string;
  figure: string;
  image: string;
  graph: Json;
}

/** Where the open document came from. */
export type Origin =
  | { kind: "example"; id: string }
  | { kind: "file"; name: string }
  | { kind: "new" }
  | { kind: "shared" }
  | ({ kind: "stored" } & StoredPlace)
  | { kind: "draft"; id: string; stored?: StoredPlace };

/** The version of a graph that the server keeps. */
export interface StoredPlace {
  id: string;
  version: number;
  tag: string;
}

/** How a document is looked at: where the camera stands, and what is selected. */
export interface Sight {
  camera: CameraPlace | null;
  selection: readonly string[];
}

/** A decoded model, as far as the session needs to know it. */
export interface Picture {
  triangles: number;
  vertices: number;
  decodeMilliseconds: number;
  dispose(): void;
}

/** What the page says of the control geometry that it shows. */
export interface ControlInfo {
  /** Color of a wire type. */
  ofType(type: string): string;
  /** Nodes that are drawn fainter. */
  faint: ReadonlySet<string>;
}

export interface PictureViewer {
  decode(model: Uint8Array<ArrayBuffer>): Promise<Picture>;
  show(picture: Picture): void;
  /** Shows the first picture of a document, from `place`, else from its camera, to which Home leads, if it has one. */
  open(picture: Picture, camera: CameraPlace | null, place?: CameraPlace | null): void;
  /** Where the camera stands; null while that is where the document opens. */
  readonly camera: CameraPlace | null;
  /** The same as a document says it, for a picture of the usual shape. */
  readonly pictureCamera: CameraPlace | null;
  /** Shows control geometry over the model; null takes it away. */
  showControl(picture: Picture | null, info: ControlInfo): void;
  /** Shows a model in the colors of its motion in place of the shown one; null brings that back. */
  showSensitivity(picture: Picture | null): void;
  clear(): void;
  /** Shows another model together with the present one; null takes it away. */
  compare(picture: Picture | null, how: "beside" | "over"): void;
  compareHow(how: "beside" | "over"): void;
  /** What is seen, on its ground, drawn finely. */
  still(): HTMLCanvasElement;
  /** A small picture on a clear background, from a document's camera if it has one, as an address for an <img>. */
  thumbnail(picture: Picture, width: number, height: number, camera: CameraPlace | null): Promise<string>;
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
  /** The open example; null when the document came from elsewhere. */
  exampleId: string | null;
  origin: Origin;
  document: GraphDocument | null;
  /** Counts the documents that were opened: the same number, the same document in another state. */
  opened: number;
  view: ViewGraph | null;
  values: ParameterValues;
  /** The document differs from what was opened or saved. */
  isChanged: boolean;
  /** The form's values differ from those at the time it was opened or saved. */
  isAdjusted: boolean;
  canUndo: boolean;
  canRedo: boolean;
  /** What undo and redo would do, as a menu says it. */
  undoLabel: string | undefined;
  redoLabel: string | undefined;
  revision: number;
  shown: Shown | null;
  /** The node whose file is drawn; null where there is nothing to draw. */
  drawn: string | null;
  busy: boolean;
  away: boolean;
  /** While it is away: it answers, but has too much to do. */
  isCrowded: boolean;
  problem: Problem | null;
  /** What the server says of the whole graph without evaluating it; null before it has. */
  checked: Validation | null;
  /** The selected nodes. */
  selection: ReadonlySet<string>;
  /** Keys of the selected frames and notes. */
  areas: ReadonlySet<string>;
  /** The node selected last. */
  selected: string | null;
}

export const EMPTY: SessionState = {
  catalogue: null,
  examples: null,
  exampleId: null,
  origin: { kind: "new" },
  document: null,
  opened: 0,
  view: null,
  values: {},
  isChanged: false,
  isAdjusted: false,
  canUndo: false,
  canRedo: false,
  undoLabel: undefined,
  redoLabel: undefined,
  revision: 0,
  shown: null,
  drawn: null,
  busy: true,
  away: false,
  isCrowded: false,
  problem: null,
  checked: null,
  selection: new Set(),
  areas: new Set(),
  selected: null,
};
