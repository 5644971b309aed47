// What a document notes of the drawing of nodes that go into a group, and come out of it again: places, flags, frames.

import type { GraphDocument } from "./document";
import { type Edit, withUi } from "./edit";
import { freeName } from "./edit_ui";
import { asArray, asNumber, asObject, asString, type Json, type JsonObject } from "./json";
import type { Position } from "./ui";

/** The notes of nodes, with the frames around nothing but them; `edit` takes these frames away. */
export function drawingOf(document: GraphDocument, ids: ReadonlySet<string>): { ui: JsonObject; edit: Edit } {
  const all = asObject(document.scope["ui"]);
  const own = Object.entries(asObject(all["nodes"])).filter(([id]) => ids.has(id));
  const frames = new Set(
    document.frames.filter(({ nodes }) => nodes.length > 0 && nodes.every((id) => ids.has(id))).map(({ id }) => id),
  );
  const ui: JsonObject = { nodes: Object.fromEntries(own) as JsonObject };
  if (frames.size === 0) return { ui, edit: (same) => same };
  const isOwn = (frame: Json): boolean => frames.has(asString(asObject(frame)["id"]));
  const list = asArray(all["frames"]);
  ui["frames"] = list.filter(isOwn);
  const left = list.filter((frame) => !isOwn(frame));
  return { ui, edit: (changed) => withUi(changed, { frames: left.length > 0 ? left : undefined }) };
}

/** Puts the notes of a group into those of the document: flags of its nodes, its frames and its texts. */
export function withDrawing(drawn: JsonObject, renamed: (id: string) => string, shift: Position): Edit {
  return (document) => {
    const nodes: JsonObject = { ...asObject(asObject(document.scope["ui"])["nodes"]) };
    for (const [own, item] of Object.entries(asObject(drawn["nodes"]))) {
      const id = renamed(own);
      if (document.nodes.has(id)) nodes[id] = { ...asObject(item), ...asObject(nodes[id]) };
    }
    const members: JsonObject = { nodes };
    for (const [name, stem] of [
      ["frames", "frame"],
      ["notes", "note"],
    ] as const) {
      const list = asArray(asObject(document.scope["ui"])[name]);
      const taken = list.map((item) => ({ id: asString(asObject(item)["id"]) }));
      const added = asArray(drawn[name]).map((one) => {
        const item = asObject(one);
        const id = freeName(taken, stem);
        taken.push({ id });
        const place = moved({ x: asNumber(item["x"]) ?? 0, y: asNumber(item["y"]) ?? 0 }, shift);
        const inner = name === "frames" && { nodes: asArray(item["nodes"]).map((node) => renamed(asString(node))) };
        return { ...item, id, x: Math.round(place.x), y: Math.round(place.y), ...inner };
      });
      if (added.length > 0) members[name] = [...list, ...added];
    }
    return withUi(document, members);
  };
}

/** Where the nodes stand, of those that have a place. */
export function placesIn(ui: JsonObject): Map<string, Position> {
  const places = new Map<string, Position>();
  for (const [id, item] of Object.entries(asObject(ui["nodes"]))) {
    const [x, y] = [asNumber(asObject(item)["x"]), asNumber(asObject(item)["y"])];
    if (x !== undefined && y !== undefined) places.set(id, { x, y });
  }
  return places;
}

/** The middle of the box around places; the origin without any. */
export function middleOf(places: readonly Position[]): Position {
  if (places.length === 0) return { x: 0, y: 0 };
  const [xs, ys] = [places.map(({ x }) => x), places.map(({ y }) => y)];
  return { x: (Math.min(...xs) + Math.max(...xs)) / 2, y: (Math.min(...ys) + Math.max(...ys)) / 2 };
}

export function moved({ x, y }: Position, by: Position): Position {
  return { x: x + by.x, y: y + by.y };
}
