// What a document says of its own drawing, below `ui`: places of nodes, flags, frames and notes. It never influences
// evaluation. Keys that are not known here are kept.

import { asArray, asNumber, asObject, asString, type Json, type JsonObject } from "./json";

export interface Position {
  x: number;
  y: number;
}

export interface Box extends Position {
  width: number;
  height: number;
}

/** A titled area behind nodes; moving it moves its members. */
export interface Frame extends Box {
  id: string;
  title: string;
  /** Name of a tint of the style sheet. */
  color: string;
  nodes: string[];
  /** Only its head is shown, in place of its nodes. */
  collapsed?: boolean;
}

export interface Note extends Box {
  id: string;
  text: string;
}

export interface UiState {
  positions: ReadonlyMap<string, Position>;
  /** Nodes whose value is drawn in the 3D view. */
  previews: ReadonlySet<string>;
  /** Nodes of which only the title is shown. */
  collapsed: ReadonlySet<string>;
  /** Names of tints of the style sheet, by node. */
  colors: ReadonlyMap<string, string>;
  /** What nodes are called for people, beside the ids that everything else refers to. */
  labels: ReadonlyMap<string, string>;
  frames: readonly Frame[];
  notes: readonly Note[];
}

export const FRAME_COLORS = ["blue", "green", "amber", "violet", "gray"] as const;

/** The collapsed frame that a node is drawn within, by node. */
export function hiddenIn(frames: readonly Frame[]): Map<string, string> {
  const hidden = new Map<string, string>();
  for (const { id, collapsed, nodes } of frames) {
    for (const node of collapsed ? nodes : []) if (!hidden.has(node)) hidden.set(node, id);
  }
  return hidden;
}

/** Frames and notes are selected beside nodes; no node's name holds a colon. */
export function frameKey(id: string): string {
  return `frame:${id}`;
}

export function noteKey(id: string): string {
  return `note:${id}`;
}

/** Reads `ui`; what belongs to nodes that are not there is left out. */
export function readUi(ui: JsonObject, nodes: ReadonlySet<string>): UiState {
  const positions = new Map<string, Position>();
  const [previews, collapsed] = [new Set<string>(), new Set<string>()];
  const [colors, labels] = [new Map<string, string>(), new Map<string, string>()];
  for (const [id, item] of Object.entries(asObject(ui["nodes"]))) {
    if (!nodes.has(id)) continue;
    const place = asObject(item);
    const [x, y] = Array.isArray(item) ? asArray(item).map(asNumber) : [asNumber(place["x"]), asNumber(place["y"])];
    if (x !== undefined && y !== undefined) positions.set(id, { x, y });
    if (place["preview"] === true) previews.add(id);
    if (place["collapsed"] === true) collapsed.add(id);
    const [color, label] = [asString(place["color"]), asString(place["label"])];
    if (color) colors.set(id, color);
    if (label) labels.set(id, label);
  }
  const frames = asArray(ui["frames"]).map((item) => readFrame(asObject(item), nodes));
  const notes = asArray(ui["notes"]).map((item) => readNote(asObject(item)));
  return { positions, previews, collapsed, colors, labels, frames: withId(frames), notes: withId(notes) };
}

function readFrame(item: JsonObject, nodes: ReadonlySet<string>): Frame {
  const members = asArray(item["nodes"]).map(asString);
  return {
    id: asString(item["id"]),
    title: asString(item["title"]),
    color: asString(item["color"]) || FRAME_COLORS[0],
    ...readBox(item, 240, 160),
    nodes: members.filter((id) => nodes.has(id)),
    ...(item["collapsed"] === true && { collapsed: true }),
  };
}

function readNote(item: JsonObject): Note {
  return { id: asString(item["id"]), text: asString(item["text"]), ...readBox(item, 200, 96) };
}

function readBox(item: JsonObject, width: number, height: number): Box {
  const number = (value: Json, otherwise: number): number => asNumber(value) ?? otherwise;
  return {
    x: number(item["x"], 0),
    y: number(item["y"], 0),
    width: Math.max(40, number(item["width"], width)),
    height: Math.max(30, number(item["height"], height)),
  };
}

function withId<Item extends { id: string }>(items: Item[]): Item[] {
  return items.filter((item, index) => item.id && items.findIndex((other) => other.id === item.id) === index);
}
