// The nodes as React Flow holds them: places, selection and measures. What is on a node's face is read from the session
// by the node itself, so that a changed value renders that node only.

import { applyNodeChanges, type NodeChange } from "@xyflow/react";
import { useCallback, useEffect, useRef, useState } from "react";
import { isPill, NODE_WIDTH, PILL_WIDTH } from "../model/layout";
import { prefixOf } from "../model/scope";
import { type Box, frameKey, hiddenIn, noteKey, type Position } from "../model/ui";
import type { SessionState } from "../session/state";
import { useCurrentSession } from "../widgets/context";
import { type AreaNode, FRAME_HEAD } from "./areas";
import type { GraphNodeData } from "./NodeView";

export type FlowNode = GraphNodeData | AreaNode;

const BEHIND = -10;

/** The nodes, and what takes the canvas's changes of them. */
export function useFlowNodes(): [FlowNode[], (changes: NodeChange<FlowNode>[]) => void] {
  const session = useCurrentSession();
  const [nodes, setNodes] = useState<FlowNode[]>(() => flowNodes([], session.store.get()));
  const last = useRef(session.store.get());

  useEffect(() => {
    const follow = (): void => {
      const [before, state] = [last.current, session.store.get()];
      last.current = state;
      const isSame =
        before.document === state.document && before.selection === state.selection && before.areas === state.areas;
      if (isSame) return;
      // In a group the same names are other nodes.
      const isSamePlace = before.opened === state.opened && placeText(before) === placeText(state);
      setNodes((present) => flowNodes(isSamePlace ? present : [], state));
    };
    last.current = session.store.get();
    setNodes((present) => flowNodes(present, last.current));
    return session.store.subscribe(follow);
  }, [session]);

  const onChange = useCallback(
    (changes: NodeChange<FlowNode>[]) => {
      const { selection, areas } = session.store.get();
      const chosen = new Set([...selection, ...areas]);
      let isSelection = false;
      for (const change of changes) {
        if (change.type !== "select") continue;
        isSelection = true;
        if (change.selected) chosen.add(change.id);
        else chosen.delete(change.id);
      }
      if (isSelection) session.select(chosen);
      const others = changes.filter((change) => change.type === "position" || change.type === "dimensions");
      if (others.length === 0) return;
      setNodes((present) => applyNodeChanges([...others, ...carried(present, others, last.current)], present));
    },
    [session],
  );
  return [nodes, onChange];
}

function placeText({ document }: SessionState): string {
  return prefixOf(document?.inside ?? []);
}

/** React Flow's nodes for a state; those that are as before stay the same objects, and the array too if all do. */
export function flowNodes(before: readonly FlowNode[], state: SessionState): FlowNode[] {
  const { document, view, selection, areas } = state;
  const known = new Map(before.map((node) => [node.id, node]));
  const next: FlowNode[] = [];
  const put = (node: FlowNode, box?: Box): void => {
    const old = known.get(node.id);
    const isSame =
      old !== undefined &&
      old.selected === node.selected &&
      old.ariaLabel === node.ariaLabel &&
      (old.hidden ?? false) === (node.hidden ?? false) &&
      (old.dragging || (old.position.x === node.position.x && old.position.y === node.position.y)) &&
      (box ? old.width === box.width && old.height === box.height : old.width === node.width);
    if (isSame) next.push(old);
    else next.push({ ...old, ...node, position: old?.dragging ? old.position : node.position } as FlowNode);
  };
  for (const frame of document?.frames ?? []) {
    const key = frameKey(frame.id);
    const box = frame.collapsed ? { ...frame, height: FRAME_HEAD } : frame;
    put(area("frame", key, box, areas.has(key), `Frame ${frame.title}`), box);
  }
  for (const note of document?.notes ?? []) {
    const key = noteKey(note.id);
    put(area("note", key, note, areas.has(key), `Note ${note.text.slice(0, 60)}`), note);
  }
  const hidden = hiddenIn(document?.frames ?? []);
  for (const node of view?.nodes ?? []) {
    put({
      hidden: hidden.has(node.id),
      id: node.id,
      type: "graph",
      position: document?.positions.get(node.id) ?? { x: 0, y: 0 },
      // A pill is as wide as it is drawn: opened, it is as wide as others.
      ...(isPill(node) ? { width: undefined, initialWidth: PILL_WIDTH } : { width: NODE_WIDTH }),
      selected: selection.has(node.id),
      data: { id: node.id },
      ariaLabel: `${node.label || node.title}, ${node.id}`,
      domAttributes: { "aria-roledescription": "node" },
    });
  }
  const isSame = next.length === before.length && next.every((node, index) => node === before[index]);
  return isSame ? (before as FlowNode[]) : next;
}

function area(
  type: "frame" | "note",
  key: string,
  box: Box & { id: string },
  selected: boolean,
  name: string,
): AreaNode {
  return {
    id: key,
    type,
    position: { x: box.x, y: box.y },
    width: box.width,
    height: box.height,
    zIndex: type === "frame" ? BEHIND : 0,
    selected,
    data: { id: box.id },
    ariaLabel: name,
    domAttributes: { "aria-roledescription": type },
  };
}

/** Moves the members of a moved frame along with it. */
function carried(
  nodes: readonly FlowNode[],
  changes: readonly NodeChange<FlowNode>[],
  state: SessionState,
): NodeChange<FlowNode>[] {
  const moved = new Set(changes.flatMap((change) => (change.type === "position" ? [change.id] : [])));
  const result: NodeChange<FlowNode>[] = [];
  for (const change of changes) {
    if (change.type !== "position" || !change.position) continue;
    const node = nodes.find(({ id }) => id === change.id);
    const frame =
      node?.type === "frame" ? state.document?.frames.find(({ id }) => frameKey(id) === node.id) : undefined;
    if (!node || !frame) continue;
    const [dx, dy] = [change.position.x - node.position.x, change.position.y - node.position.y];
    for (const id of frame.nodes) {
      const member = nodes.find((item) => item.id === id);
      if (!member || moved.has(id)) continue;
      moved.add(id);
      const position: Position = { x: member.position.x + dx, y: member.position.y + dy };
      result.push({ type: "position", id, position, dragging: change.dragging });
    }
  }
  return result;
}
