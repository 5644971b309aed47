// Drawing wires with the pointer: which sockets take the wire, what is done where it is let go.

import type { FinalConnectionState, Connection as FlowConnection } from "@xyflow/react";
import { type Connection, WireCheck } from "../model/check";
import { inOrder } from "../model/edit";
import { connect, disconnect } from "../model/edit_wires";
import type { ViewWire } from "../model/graph";
import type { Position } from "../model/ui";
import { type Editor, type SocketPlace, socketKey, type Wiring } from "../session/editor";

/** A wire from this socket is under the hand: every other socket says whether it takes it. */
export function startWiring(editor: Editor, start: SocketPlace): void {
  editor.store.set({ wiring: wiringFrom(editor, start), inspected: null });
}

/** For every socket of the other side the reason why it does not take a wire from `start`, if there is one. */
export function wiringFrom(editor: Editor, start: SocketPlace): Wiring {
  const { document, catalogue, view } = editor.session.store.get();
  const refusals = new Map<string, string>();
  if (!document || !catalogue || !view) return { start, refusals };
  const check = new WireCheck(document, catalogue);
  for (const node of view.nodes) {
    const side = start.side === "output" ? "input" : "output";
    for (const { name } of side === "input" ? node.rows : node.outputs) {
      const place: SocketPlace = { node: node.id, side, name };
      const reason = check.refusal(between(start, place));
      if (reason !== undefined) refusals.set(socketKey(place), reason);
    }
  }
  return { start, refusals };
}

export function between(a: SocketPlace, b: SocketPlace): Connection {
  const [from, to] = a.side === "output" ? [a, b] : [b, a];
  return { from: from.node, output: from.name, to: to.node, input: to.name };
}

export function isAllowed(editor: Editor, connection: Partial<FlowConnection>): boolean {
  const { wiring } = editor.store.get();
  if (!wiring) return true;
  const end = wiring.start.side === "output" ? inputOf(connection) : outputOf(connection);
  return !wiring.refusals.has(socketKey(end));
}

/** Draws a wire between two sockets, in the place of one that was pulled off. */
export function draw(editor: Editor, connection: Connection, pulled?: ViewWire): void {
  const { catalogue } = editor.session.store.get();
  if (!catalogue) return;
  const isSamePlace = pulled?.to === connection.to && pulled.input === connection.input;
  const edit = isSamePlace
    ? connect(catalogue, connection, { replaced: pulled.index })
    : inOrder(...(pulled ? [disconnect(pulled)] : []), connect(catalogue, connection));
  editor.session.edit("Connect", edit);
  editor.say(`Connected ${connection.from} to ${connection.input} of ${connection.to}`);
}

/** A wire was let go where no socket took it: over a node, over the canvas, or over a socket that refuses it. */
export function dropped(editor: Editor, state: FinalConnectionState, screen: Position, pulled?: ViewWire): void {
  const { wiring } = editor.store.get();
  if (!wiring || state.isValid === true) return;
  if (state.isValid === false) {
    const { toHandle } = state;
    const side = toHandle?.type === "target" ? "input" : "output";
    const key = toHandle ? socketKey({ node: toHandle.nodeId, side, name: toHandle.id ?? "" }) : "";
    const isSameSide = side === wiring.start.side;
    const reason = wiring.refusals.get(key) ?? (isSameSide ? `A wire runs from an output to an input.` : undefined);
    if (reason) editor.say(reason, "refused");
    return;
  }
  const element = document.elementFromPoint(screen.x, screen.y);
  const node = element?.closest<HTMLElement>(".react-flow__node-graph")?.dataset["id"];
  if (node !== undefined) {
    dropOnNode(editor, wiring, node, pulled);
    return;
  }
  if (pulled) {
    editor.session.edit("Disconnect", disconnect(pulled));
    editor.say(`Disconnected ${pulled.input} of ${pulled.to}`);
    return;
  }
  if (!element?.closest(".react-flow")) return;
  const { document: open, catalogue } = editor.session.store.get();
  if (!open || !catalogue) return;
  const { node: id, side, name } = wiring.start;
  const card = catalogue.nodes.get(open.nodes.get(id)?.type ?? "");
  const types =
    side === "output"
      ? new WireCheck(open, catalogue).types.possible(id, name)
      : (card?.inputs.find((input) => input.name === name)?.types ?? []);
  editor.openSearch({ screen, loose: { ...wiring.start, types } });
}

/** Let go on a node beside its sockets: the first free socket that takes the wire has it. */
function dropOnNode(editor: Editor, wiring: Wiring, id: string, pulled?: ViewWire): void {
  const node = editor.session.store.get().view?.byId.get(id);
  if (!node || id === wiring.start.node) return;
  const side = wiring.start.side === "output" ? "input" : "output";
  const rows = side === "input" ? [...node.rows].sort((a, b) => Number(a.linked) - Number(b.linked)) : node.outputs;
  const row = rows.find(({ name }) => !wiring.refusals.has(socketKey({ node: id, side, name })));
  if (row) draw(editor, between(wiring.start, { node: id, side, name: row.name }), pulled);
  else editor.say(`${node.title} has no socket for this wire.`, "refused");
}

/**
 * Pressing on an input that has a wire takes the wire's end in hand. The socket lies over the place where React Flow
 * hears that, so the press is passed on to it.
 */
export function pullWire(editor: Editor, event: MouseEvent): void {
  if (event.button !== 0 || !(event.target instanceof Element)) return;
  const socket = event.target.closest<HTMLElement>(".react-flow__handle.target");
  const { nodeid: node, handleid: input } = socket?.dataset ?? {};
  const wire = editor.session.store
    .get()
    .view?.wires.filter((item) => item.to === node && item.input === input)
    .at(-1);
  if (!wire) return;
  const anchor = document.querySelector(
    `.react-flow__edge[data-id="${CSS.escape(wire.id)}"] .react-flow__edgeupdater-target`,
  );
  if (!anchor) return;
  event.stopPropagation();
  event.preventDefault();
  const { clientX, clientY, button } = event;
  anchor.dispatchEvent(
    new MouseEvent("mousedown", { bubbles: true, cancelable: true, view: window, clientX, clientY, button }),
  );
}

function inputOf(connection: Partial<FlowConnection>): SocketPlace {
  return { node: connection.target ?? "", side: "input", name: connection.targetHandle ?? "" };
}

function outputOf(connection: Partial<FlowConnection>): SocketPlace {
  return { node: connection.source ?? "", side: "output", name: connection.sourceHandle ?? "" };
}
