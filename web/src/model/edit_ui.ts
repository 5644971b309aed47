// Changes below `ui`: flags of nodes, frames and notes. None of them changes what is computed.

import type { Catalogue } from "./catalogue";
import type { GraphDocument } from "./document";
import { type Edit, inOrder, moveNodes, nameProblem, renameNode, withUi } from "./edit";
import { asArray, asObject, asString, type Json, type JsonObject } from "./json";
import type { Box, Frame, Note, Position } from "./ui";

const LONGEST_LABEL = 200;

export function setFlag(ids: Iterable<string>, flag: "preview" | "collapsed", on: boolean): Edit {
  return (document) => {
    const nodes: JsonObject = { ...asObject(asObject(document.scope["ui"])["nodes"]) };
    for (const id of ids) {
      if (!document.nodes.has(id)) continue;
      const { [flag]: _, ...rest } = asObject(nodes[id]);
      nodes[id] = on ? { ...rest, [flag]: true } : rest;
    }
    return withUi(document, { nodes });
  };
}

/** Gives nodes a color or a label; an empty one takes it away. */
export function setMark(ids: Iterable<string>, mark: "color" | "label", value: string): Edit {
  return (document) => {
    const nodes: JsonObject = { ...asObject(asObject(document.scope["ui"])["nodes"]) };
    for (const id of ids) {
      if (!document.nodes.has(id)) continue;
      const { [mark]: _, ...rest } = asObject(nodes[id]);
      nodes[id] = value ? { ...rest, [mark]: value } : rest;
    }
    return withUi(document, { nodes });
  };
}

/**
 * What was typed as the name of a node: its new id, if it can be one, or else its label, while the id stays what others
 * refer to. Without any text the label goes.
 */
export function nameNode(id: string, text: string, catalogue: Catalogue | null = null): Edit {
  const isId = text !== "" && nameProblem(text) === undefined;
  if (!isId) return setMark([id], "label", text.slice(0, LONGEST_LABEL));
  return inOrder(setMark([id], "label", ""), renameNode(id, text, catalogue));
}

export function addFrame(frame: Frame): Edit {
  return (document) => withUi(document, { frames: [...items(document, "frames"), { ...frame }] });
}

export function changeFrame(id: string, change: Partial<Omit<Frame, "id">>): Edit {
  return (document) => withUi(document, { frames: changed(document, "frames", id, { ...change }) });
}

/** Takes the frame away; its nodes stay. */
export function removeFrame(id: string): Edit {
  return (document) => withUi(document, { frames: without(document, "frames", id) });
}

/** Moves a frame with everything in it. */
export function moveFrame(id: string, to: Position): Edit {
  return (document) => {
    const frame = document.frames.find((item) => item.id === id);
    if (!frame) return document;
    const [dx, dy] = [to.x - frame.x, to.y - frame.y];
    const places = new Map<string, Position>();
    for (const node of frame.nodes) {
      const place = document.positions.get(node);
      if (place) places.set(node, { x: place.x + dx, y: place.y + dy });
    }
    return changeFrame(id, { x: Math.round(to.x), y: Math.round(to.y) })(moveNodes(places)(document));
  };
}

/** A frame's members are the nodes whose middle lies in it; told anew after nodes or frames were moved. */
export function collectMembers(ids: Iterable<string>, boxOf: (id: string) => Box | undefined): Edit {
  return (document) => {
    const moved = new Set(ids);
    if (document.frames.length === 0) return document;
    let result = document;
    for (const frame of document.frames) {
      // What is put over a frame that is closed would vanish.
      if (frame.collapsed) continue;
      const inside = [...moved].filter((id) => isInside(boxOf(id), frame));
      const members = [...frame.nodes.filter((id) => !moved.has(id)), ...inside];
      const isSame = members.length === frame.nodes.length && members.every((id) => frame.nodes.includes(id));
      if (!isSame) result = changeFrame(frame.id, { nodes: members })(result);
    }
    return result;
  };
}

export function addNote(note: Note): Edit {
  return (document) => withUi(document, { notes: [...items(document, "notes"), { ...note }] });
}

export function changeNote(id: string, change: Partial<Omit<Note, "id">>): Edit {
  return (document) => withUi(document, { notes: changed(document, "notes", id, { ...change }) });
}

export function removeNote(id: string): Edit {
  return (document) => withUi(document, { notes: without(document, "notes", id) });
}

/** A name for a frame or a note that is not taken. */
export function freeName(taken: readonly { id: string }[], stem: string): string {
  for (let number = 1; ; number++) {
    if (!taken.some(({ id }) => id === `${stem}${number}`)) return `${stem}${number}`;
  }
}

function isInside(box: Box | undefined, frame: Frame): boolean {
  if (!box) return false;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  return x > frame.x && x < frame.x + frame.width && y > frame.y && y < frame.y + frame.height;
}

function items(document: GraphDocument, name: string): Json[] {
  return asArray(asObject(document.scope["ui"])[name]);
}

function changed(document: GraphDocument, name: string, id: string, change: JsonObject): Json[] {
  return items(document, name).map((item) => (idOf(item) === id ? { ...asObject(item), ...change } : item));
}

/** The list without one item; undefined, so that the key goes, when it was the last. */
function without(document: GraphDocument, name: string, id: string): Json {
  const left = items(document, name).filter((item) => idOf(item) !== id);
  return left.length > 0 ? left : undefined;
}

function idOf(item: Json): string {
  return asString(asObject(item)["id"]);
}
