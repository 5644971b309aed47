// What the pointer does on the canvas, as React Flow and the pane around it report it.

import type {
  EdgeChange,
  FinalConnectionState,
  Connection as FlowConnection,
  OnConnectStartParams,
} from "@xyflow/react";
import {
  type FocusEvent as ReactFocusEvent,
  type MouseEvent as ReactMouseEvent,
  type PointerEvent as ReactPointerEvent,
  type TouchEvent as ReactTouchEvent,
  useMemo,
  useRef,
} from "react";
import { type Edit, inOrder, moveNodes } from "../model/edit";
import { changeNote, collectMembers, moveFrame } from "../model/edit_ui";
import { insertOnWire } from "../model/edit_wires";
import type { ViewWire } from "../model/graph";
import type { Position } from "../model/ui";
import { toggleFlag } from "../session/actions";
import type { Editor, MenuTarget } from "../session/editor";
import { useEditor } from "../widgets/context";
import { wireUnder } from "./drop_on_wire";
import type { Flow } from "./flow";
import type { FlowNode } from "./flow_nodes";
import type { WireEdge } from "./WireView";
import { draw, dropped, isAllowed, pullWire, startWiring } from "./wiring";

const LONG_PRESS_MILLISECONDS = 550;
const LONG_PRESS_REACH = 8;

type AnyMouse = MouseEvent | TouchEvent;

// The types of what is handed to <ReactFlow> follow from its properties.
// eslint-disable-next-line @typescript-eslint/explicit-function-return-type
export function useHandlers(flow: Flow | null) {
  const editor = useEditor();
  const pulled = useRef<ViewWire | undefined>(undefined);
  const press = useRef<{ timer: number; at: Position } | null>(null);
  const isLongPress = useRef(false);
  return useMemo(() => {
    const openMenu = (
      event: { clientX: number; clientY: number; preventDefault(): void },
      target: MenuTarget,
    ): void => {
      event.preventDefault();
      editor.openMenu({ screen: { x: event.clientX, y: event.clientY }, target });
    };
    const cancelPress = (): void => {
      if (press.current) window.clearTimeout(press.current.timer);
      press.current = null;
    };
    return {
      flow: {
        isValidConnection: (connection: FlowConnection | WireEdge) => isAllowed(editor, connection as FlowConnection),
        onConnectStart: (_: AnyMouse, { nodeId, handleId, handleType }: OnConnectStartParams) => {
          const side = handleType === "source" ? "output" : "input";
          startWiring(editor, { node: nodeId ?? "", side, name: handleId ?? "" });
        },
        onConnect: (connection: FlowConnection) => draw(editor, connectionOf(connection)),
        onConnectEnd: (event: AnyMouse, state: FinalConnectionState) => {
          // The end of a pulled wire is reported here too, before it is reported as one.
          if (pulled.current) return;
          dropped(editor, state, screenOf(event));
          editor.store.set({ wiring: null });
        },
        onReconnectStart: (_: ReactMouseEvent, edge: WireEdge) => {
          pulled.current = edge.data?.wire;
        },
        onReconnect: (edge: WireEdge, connection: FlowConnection) => {
          const wire = edge.data?.wire;
          const isSame = wire?.to === connection.target && wire.input === connection.targetHandle;
          if (wire && !isSame) draw(editor, connectionOf(connection), wire);
        },
        onReconnectEnd: (event: AnyMouse, _: WireEdge, __: unknown, state: FinalConnectionState) => {
          dropped(editor, state, screenOf(event), pulled.current);
          pulled.current = undefined;
          editor.store.set({ wiring: null });
        },
        onEdgesChange: (changes: EdgeChange<WireEdge>[]) => selectWires(editor, changes),
        onNodeClick: (event: ReactMouseEvent, node: FlowNode) => {
          if (event.altKey && node.type === "graph") toggleFlag(editor, "preview", [node.id]);
          // A plain press on one of several selected nodes means this one.
          if (!event.shiftKey && !event.ctrlKey && !event.metaKey) editor.session.select([node.id]);
        },
        onNodeDragStart: () => editor.closeAll(),
        onNodeDrag: (_: unknown, node: FlowNode, dragged: FlowNode[]) => {
          const wire = dragged.length === 1 && node.type === "graph" ? wireBelow(editor, flow, node) : undefined;
          if (editor.store.get().target !== (wire?.id ?? null)) editor.store.set({ target: wire?.id ?? null });
        },
        onNodeDragStop: (_: unknown, node: FlowNode, dragged: FlowNode[]) => settle(editor, flow, node, dragged),
        onPaneContextMenu: (event: ReactMouseEvent | MouseEvent) =>
          openMenu(event, { kind: "canvas", place: flow?.screenToFlowPosition(pointOf(event)) ?? { x: 0, y: 0 } }),
        onNodeContextMenu: (event: ReactMouseEvent, node: FlowNode) => {
          if (node.type === "graph") {
            if (!editor.session.store.get().selection.has(node.id)) editor.session.select([node.id]);
            openMenu(event, { kind: "node", id: node.id });
          } else {
            editor.session.select([node.id]);
            openMenu(event, { kind: "area", key: node.id });
          }
        },
        onEdgeContextMenu: (event: ReactMouseEvent, edge: WireEdge) => {
          if (edge.data) openMenu(event, { kind: "wire", wire: edge.data.wire });
        },
        onMove: () => {
          const { search, menu } = editor.store.get();
          if (search || menu) editor.closeAll();
        },
      },
      pane: {
        onFocus: ({ target }: ReactFocusEvent) => {
          // Who goes from node to node with the keyboard acts on the node that has the focus.
          const id =
            target instanceof HTMLElement && target.matches(".react-flow__node:focus-visible") && target.dataset["id"];
          if (id && !editor.session.store.get().selection.has(id)) editor.session.select([id]);
        },
        onMouseDownCapture: (event: ReactMouseEvent) => pullWire(editor, event.nativeEvent),
        onDoubleClick: (event: ReactMouseEvent) => {
          if (!isPane(event.target)) return;
          editor.openSearch({ screen: pointOf(event) });
        },
        onPointerDown: (event: ReactPointerEvent) => {
          cancelPress();
          isLongPress.current = false;
          if (event.pointerType !== "touch") return;
          const { target, currentTarget, clientX, clientY } = event;
          const timer = window.setTimeout(() => {
            isLongPress.current = true;
            const options = { bubbles: true, cancelable: true, view: window, clientX, clientY, button: 2 };
            if (target instanceof Element && currentTarget.contains(target)) {
              target.dispatchEvent(new MouseEvent("contextmenu", options));
              if (isPane(target))
                openMenu(event, {
                  kind: "canvas",
                  place: flow?.screenToFlowPosition(pointOf(event)) ?? { x: 0, y: 0 },
                });
            }
          }, LONG_PRESS_MILLISECONDS);
          press.current = { timer, at: { x: clientX, y: clientY } };
        },
        onPointerMove: (event: ReactPointerEvent) => {
          const at = press.current?.at;
          if (at && Math.hypot(event.clientX - at.x, event.clientY - at.y) > LONG_PRESS_REACH) cancelPress();
        },
        onPointerUp: cancelPress,
        onPointerCancel: cancelPress,
        onTouchEndCapture: (event: ReactTouchEvent) => {
          // The press of a mouse that browsers make of a lifted finger would take the focus from the menu and close it.
          if (isLongPress.current && event.cancelable) event.preventDefault();
          isLongPress.current = false;
        },
      },
    };
  }, [editor, flow]);
}

/** Writes the places of what was dragged: one step, with the wire the node was put into and the frames it is now in. */
function settle(editor: Editor, flow: Flow | null, node: FlowNode, dragged: readonly FlowNode[]): void {
  const { session } = editor;
  const { catalogue, view, document } = session.store.get();
  const target = view?.wires.find((wire) => wire.id === editor.store.get().target);
  editor.store.set({ target: null });
  if (!document || !catalogue) return;
  const edits: Edit[] = [];
  const carried = new Set<string>();
  for (const item of dragged) {
    if (item.type === "frame") {
      edits.push(moveFrame(item.data.id, item.position));
      for (const id of document.frames.find(({ id }) => id === item.data.id)?.nodes ?? []) carried.add(id);
    }
    if (item.type === "note") {
      edits.push(changeNote(item.data.id, { x: Math.round(item.position.x), y: Math.round(item.position.y) }));
    }
  }
  const moved = dragged.filter((item) => item.type === "graph" && !carried.has(item.id));
  if (moved.length > 0) {
    edits.push(moveNodes(new Map(moved.map((item) => [item.id, item.position]))));
    const boxOf = (id: string): (Position & { width: number; height: number }) | undefined => {
      const item = moved.find((one) => one.id === id);
      return item && { ...item.position, width: item.measured?.width ?? 0, height: item.measured?.height ?? 0 };
    };
    edits.push(
      collectMembers(
        moved.map(({ id }) => id),
        boxOf,
      ),
    );
  }
  if (target && flow) edits.push(insertOnWire(catalogue, node.id, target));
  session.edit(target ? "Insert on wire" : "Move", inOrder(...edits));
  if (target) editor.say(`Inserted ${node.id} between ${target.from} and ${target.to}`);
}

function wireBelow(editor: Editor, flow: Flow | null, node: FlowNode): ViewWire | undefined {
  if (!flow) return undefined;
  const box = { ...node.position, width: node.measured?.width ?? 0, height: node.measured?.height ?? 0 };
  return wireUnder(editor, node.id, box, (wire) => {
    const ends = [socketAt(flow, wire.from, "source", wire.output), socketAt(flow, wire.to, "target", wire.input)];
    return ends[0] && ends[1] ? [ends[0], ends[1]] : undefined;
  });
}

function socketAt(flow: Flow, id: string, side: "source" | "target", name: string): Position | undefined {
  const node = flow.getInternalNode(id);
  const bounds = node?.internals.handleBounds?.[side]?.find((item) => item.id === name);
  if (!node || !bounds) return undefined;
  const { x, y } = node.internals.positionAbsolute;
  return { x: x + bounds.x + bounds.width / 2, y: y + bounds.y + bounds.height / 2 };
}

function selectWires(editor: Editor, changes: readonly EdgeChange<WireEdge>[]): void {
  const chosen = new Set(editor.store.get().wires);
  for (const change of changes) {
    if (change.type !== "select") continue;
    if (change.selected) chosen.add(change.id);
    else chosen.delete(change.id);
  }
  editor.store.set({ wires: chosen });
}

function connectionOf({ source, sourceHandle, target, targetHandle }: FlowConnection): Parameters<typeof draw>[1] {
  return { from: source, output: sourceHandle ?? "", to: target, input: targetHandle ?? "" };
}

function screenOf(event: AnyMouse): Position {
  return pointOf("changedTouches" in event ? (event.changedTouches[0] ?? { clientX: 0, clientY: 0 }) : event);
}

function pointOf({ clientX, clientY }: { clientX: number; clientY: number }): Position {
  return { x: clientX, y: clientY };
}

function isPane(target: EventTarget | null): boolean {
  return target instanceof Element && target.matches(".react-flow__pane");
}
