// Looking into a socket: what flows there, asked of the server a moment after the pointer or the focus came to rest.

import { grouped, numberText } from "../model/format";
import { isNumber, isObject, type Json } from "../model/json";
import { prefixOf } from "../model/scope";
import { axesText } from "../net/report";
import { boundsOf, type Inspection, inspect } from "../net/validation";
import type { Editor } from "../session/editor";

export interface InspectedSocket {
  node: string;
  side: "input" | "output";
  name: string;
  /** The name as people read it. */
  title: string;
  type: string;
  description: string;
}

const REST_MILLISECONDS = 350;

let timer = 0;
let request: AbortController | undefined;

/** Shows what flows at a socket beside it; null takes it away. */
export function inspectSocket(editor: Editor, socket: InspectedSocket | null, element?: Element): void {
  window.clearTimeout(timer);
  request?.abort();
  if (!socket || !element) {
    if (editor.store.get().inspected) editor.store.set({ inspected: null });
    return;
  }
  if (editor.store.get().wiring) return;
  timer = window.setTimeout(() => void look(editor, socket, element), REST_MILLISECONDS);
}

async function look(editor: Editor, socket: InspectedSocket, element: Element): Promise<void> {
  const box = element.getBoundingClientRect();
  const screen = { x: box.left + box.width / 2, y: box.top };
  const title = `${socket.title}: ${socket.type || "unknown type"}`;
  editor.store.set({ inspected: { screen, side: socket.side, title, description: socket.description, lines: [] } });
  const place = sourceOf(editor, socket);
  const { document, values } = editor.session.store.get();
  if (!place || !document) return;
  const node = prefixOf(document.inside) + place.node;
  const mine = new AbortController();
  request = mine;
  const answer = await inspect({ graph: document.json, parameters: values }, node, place.output, mine.signal);
  const { inspected } = editor.store.get();
  if (mine.signal.aborted || !answer || !inspected || inspected.title !== title) return;
  const lines = "errors" in answer ? [answer.errors[0]?.detail ?? answer.detail] : valueLines(answer);
  editor.store.set({ inspected: { ...inspected, lines } });
}

/** The output whose value stands at a socket. */
function sourceOf(editor: Editor, { node, side, name }: InspectedSocket): { node: string; output: string } | undefined {
  if (side === "output") return { node, output: name };
  const wire = editor.session.store.get().view?.wires.find((item) => item.to === node && item.input === name);
  return wire && { node: wire.from, output: wire.output };
}

/** Type and axes, the first value, and how far points reach. */
export function valueLines({ type, axes, values }: Inspection): string[] {
  const lines = [axesText(type, axes)];
  const first = values[0];
  if (first !== undefined) lines.push(values.length > 1 ? `first ${valueText(first)}` : valueText(first));
  const bounds = values.length > 1 ? boundsOf(values) : undefined;
  if (bounds) lines.push(`from ${valueText(bounds[0])} to ${valueText(bounds[1])}`);
  if (values.length > 1 && values.every(isNumber)) {
    const [low, high] = [Math.min(...(values as number[])), Math.max(...(values as number[]))];
    lines.push(`from ${numberText(low)} to ${numberText(high)}`);
  }
  return lines;
}

/** One value in one line. */
function valueText(value: Json): string {
  if (isNumber(value)) return numberText(value);
  if (value === null) return "at infinity";
  if (Array.isArray(value)) return `(${value.map((part) => valueText(part)).join(", ")})`;
  if (!isObject(value)) return String(value);
  if (isNumber(value["vertices"]) && isNumber(value["triangles"])) {
    const bounds = Array.isArray(value["bounds"]) ? value["bounds"] : [];
    const box = bounds.length === 2 ? `, ${valueText(bounds[0])} to ${valueText(bounds[1])}` : "";
    return `${grouped(value["vertices"])} vertices, ${grouped(value["triangles"])} triangles${box}`;
  }
  return Object.entries(value)
    .map(([name, part]) => (part === true ? name : `${MEMBERS[name] ?? name} ${valueText(part)}`))
    .join(", ");
}

/** Coefficients of a generator as they are written in the formulas. */
const MEMBERS: Readonly<Record<string, string>> = { no_e: "nₒ∧e", e_e: "e∧e", no_ni: "nₒ∧n∞", e_ni: "e∧n∞" };
