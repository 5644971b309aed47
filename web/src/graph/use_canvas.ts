// The canvas as the editor's actions use it, and the rule that a graph nobody moved stays in view.

import type { FitViewOptions } from "@xyflow/react";
import { type RefObject, useCallback, useEffect, useRef } from "react";
import { fileOutput } from "../model/graph";
import { nodeHeight, nodeWidth } from "../model/layout";
import { type Box, hiddenIn, type Position } from "../model/ui";
import { toggleFrame } from "../session/actions";
import type { Editor, SocketPlace } from "../session/editor";
import type { SessionState } from "../session/state";
import { useEditor } from "../widgets/context";
import type { Flow } from "./flow";
import { nodeElement } from "./focus";
import { LEAST_ZOOM, OPENING_PADDING, openingNodes, READABLE_ZOOM } from "./opening";

/** A canvas that was not moved for so long stands still. */
const REST_MILLISECONDS = 200;
const FOCUS_MILLISECONDS = 20_000;
/** Where hands are busy typing, the focus is not taken away. */
const FIELDS = "input, select, textarea";
const FIT = { padding: 0.09, maxZoom: 1, minZoom: LEAST_ZOOM };

/** What React Flow is to fit into the pane when a graph opens. */
export function openingFit({ view, document, catalogue }: SessionState, pane: HTMLElement | null): FitViewOptions {
  const boxes = new Map<string, Box>();
  for (const node of view?.nodes ?? []) {
    const place = document?.positions.get(node.id);
    if (place) boxes.set(node.id, { ...place, width: nodeWidth(node), height: nodeHeight(node) });
  }
  const end = document && catalogue ? fileOutput(document, catalogue) : undefined;
  const { clientWidth: width, clientHeight: height } = pane ?? window.document.documentElement;
  const driven = (view?.nodes ?? []).filter(({ rows }) => rows.some((row) => row.parameterName !== undefined));
  const wanted = new Set(driven.map(({ id }) => id));
  const nodes = openingNodes(boxes, end, wanted, { width, height })?.map((id) => ({ id }));
  return nodes ? { nodes, padding: OPENING_PADDING, maxZoom: FIT.maxZoom, minZoom: READABLE_ZOOM } : FIT;
}

interface CanvasUse {
  /** The person moves the canvas: it is left where it is. To be told of every step. */
  noteMove(event: unknown): void;
  fitAll(): void;
}

export function useCanvas(flow: Flow | null, element: RefObject<HTMLElement | null>): CanvasUse {
  const editor = useEditor();
  /** What is kept in sight while the pane changes its size. */
  const sight = useRef<"opening" | "all" | "moved">("opening");
  const pointer = useRef<(Position & { isOver: boolean }) | null>(null);

  // Heard all the time, also while one graph's canvas takes the place of another's.
  useEffect(() => {
    const onMove = (event: PointerEvent): void => {
      const isOver = event.target instanceof Node && (element.current?.contains(event.target) ?? false);
      pointer.current = { x: event.clientX, y: event.clientY, isOver };
    };
    document.addEventListener("pointermove", onMove, { passive: true });
    document.addEventListener("pointerdown", onMove, { passive: true, capture: true });
    return () => {
      document.removeEventListener("pointermove", onMove);
      document.removeEventListener("pointerdown", onMove, { capture: true });
    };
  }, [element]);

  useEffect(() => {
    const pane = element.current;
    if (!flow || !pane) return undefined;
    sight.current = flow.getNodes().length === 0 ? "moved" : "opening";
    const middle = (): Position => {
      const box = pane.getBoundingClientRect();
      return { x: box.left + box.width / 2, y: box.top + box.height / 2 };
    };
    const boxes = (): Map<string, Box> => {
      const found = new Map<string, Box>();
      for (const node of flow.getNodes()) {
        if (node.type !== "graph" || node.hidden) continue;
        const { width = node.width ?? 0, height = 120 } = node.measured ?? {};
        found.set(node.id, { ...node.position, width, height });
      }
      return found;
    };
    let attempts = 0;
    const focusSoon = (find: () => HTMLElement | null | undefined): void => {
      // A node that has just been added is not drawn at once, and hidden until it is measured; on a slow machine that
      // takes a while. A press of the pointer, a newer wish or another field that is typed in ends the attempts.
      const mine = ++attempts;
      const until = performance.now() + FOCUS_MILLISECONDS;
      const before = document.activeElement;
      const attempt = (): void => {
        const active = document.activeElement;
        if (mine !== attempts || performance.now() > until) return;
        if (active !== before && active?.matches(FIELDS)) return;
        const found = find();
        found?.focus({ preventScroll: true });
        if (!found || document.activeElement !== found) requestAnimationFrame(attempt);
      };
      attempt();
    };
    const endAttempts = (): void => void attempts++;
    editor.canvas = {
      placeAt: (screen) => flow.screenToFlowPosition(screen),
      screenAt: (place) => flow.flowToScreenPosition(place),
      pointer: () => (pointer.current?.isOver ? { x: pointer.current.x, y: pointer.current.y } : middle()),
      isUnderPointer: () => pointer.current?.isOver ?? false,
      boxes,
      fit: (ids) => {
        reveal(editor, ids ?? []);
        const nodes = [...(ids ?? [])].map((id) => ({ id }));
        sight.current = nodes.length > 0 ? "moved" : "all";
        void flow.fitView(nodes.length > 0 ? { ...FIT, padding: 0.25, nodes } : FIT);
      },
      focusNode: (id) => {
        reveal(editor, [id]);
        const box = boxes().get(id);
        if (box && !isInside(box, flow, pane)) {
          void flow.setCenter(box.x + box.width / 2, box.y + box.height / 2, { zoom: flow.getZoom() });
        }
        focusSoon(() => nodeElement(id));
      },
      focusSocket: (socket) => focusSoon(() => socketElement(socket)),
    };
    const { nextFocus } = editor;
    editor.nextFocus = undefined;
    if (nextFocus && (document.activeElement === document.body || pane.contains(document.activeElement))) {
      if (nextFocus.node === null) pane.focus({ preventScroll: true });
      else editor.canvas.focusNode(nextFocus.node);
    }
    document.addEventListener("pointerdown", endAttempts, { passive: true, capture: true });
    const observer = new ResizeObserver(() => {
      if (sight.current === "opening") void flow.fitView(openingFit(editor.session.store.get(), pane));
      if (sight.current === "all") void flow.fitView(FIT);
    });
    observer.observe(pane);
    return () => {
      document.removeEventListener("pointerdown", endAttempts, { capture: true });
      observer.disconnect();
      endAttempts();
      editor.canvas = undefined;
    };
  }, [editor, flow, element]);

  const rest = useRef(0);
  const noteMove = useCallback(
    (event: unknown) => {
      if (!event) return;
      sight.current = "moved";
      element.current?.setAttribute("data-moving", "true");
      window.clearTimeout(rest.current);
      rest.current = window.setTimeout(() => element.current?.removeAttribute("data-moving"), REST_MILLISECONDS);
    },
    [element],
  );
  const fitAll = useCallback(() => editor.canvas?.fit(), [editor]);
  return { noteMove, fitAll };
}

/** Opens the frames that hide what is looked for. */
function reveal(editor: Editor, ids: Iterable<string>): void {
  const { document, selection } = editor.session.store.get();
  const hidden = hiddenIn(document?.frames ?? []);
  const frames = new Set([...ids].flatMap((id) => hidden.get(id) ?? []));
  for (const frame of frames) toggleFrame(editor, frame);
  if (frames.size > 0) editor.session.select(selection);
}

function socketElement({ node, side, name }: SocketPlace): HTMLElement | undefined {
  const sockets = nodeElement(node)?.querySelectorAll<HTMLElement>(
    `.react-flow__handle.${side === "input" ? "target" : "source"}`,
  );
  return [...(sockets ?? [])].find((item) => item.dataset["handleid"] === name);
}

function isInside(box: Box, flow: Flow, pane: HTMLElement): boolean {
  const area = pane.getBoundingClientRect();
  const [from, to] = [
    flow.flowToScreenPosition({ x: box.x, y: box.y }),
    flow.flowToScreenPosition({ x: box.x + box.width, y: box.y + box.height }),
  ];
  return from.x >= area.left && from.y >= area.top && to.x <= area.right && to.y <= area.bottom;
}
