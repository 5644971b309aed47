// Hears the keys of the table. What is typed into a field, or chosen in a menu, stays there.

import { nodeElement, stopsIn } from "../graph/focus";
import type { Editor } from "../session/editor";
import { enterOrLeave } from "../session/grouping";
import { type GraphKey, keyOf, type PageKey, shortcutOf } from "../session/shortcuts";
import { KEY_ACTIONS } from "./key_actions";

/** A press of Space that lasts longer, or comes with a press of the pointer, moves the canvas. */
const SPACE_MILLISECONDS = 400;
const CANVAS = ".graph-pane";

/** Starts to listen; answers what ends it. */
export function listen(editor: Editor): () => void {
  let space: { at: number } | undefined;
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.defaultPrevented) return;
    const target = event.target instanceof HTMLElement ? event.target : document.body;
    const key = keyOf(event);
    if (key === "Tab" || key === "Shift+Tab") {
      if (moveInNode(target, event.shiftKey)) event.preventDefault();
      else if (key === "Tab" && isOnCanvas(editor, target) && enterOrLeave(editor)) event.preventDefault();
      else if (key === "Tab" && opensSearch(editor, target)) {
        event.preventDefault();
        KEY_ACTIONS.add(editor);
      }
      return;
    }
    if (key === "Escape" && leaveNode(target)) {
      event.preventDefault();
      return;
    }
    const shortcut = wanted(editor, event, target);
    if (shortcut === undefined) return;
    if (key === "Space") {
      // Holding Space and dragging moves the canvas, so the search opens when the key comes up.
      event.preventDefault();
      if (!event.repeat) space = { at: event.timeStamp };
      return;
    }
    event.preventDefault();
    KEY_ACTIONS[shortcut](editor);
  };
  const onKeyUp = (event: KeyboardEvent): void => {
    if (event.key !== " " || !space) return;
    const isShort = event.timeStamp - space.at < SPACE_MILLISECONDS;
    space = undefined;
    if (isShort) editor.openSearch();
  };
  const onPointerDown = (): void => {
    space = undefined;
  };
  document.addEventListener("keydown", onKeyDown);
  document.addEventListener("keyup", onKeyUp);
  document.addEventListener("pointerdown", onPointerDown, true);
  return () => {
    document.removeEventListener("keydown", onKeyDown);
    document.removeEventListener("keyup", onKeyUp);
    document.removeEventListener("pointerdown", onPointerDown, true);
  };
}

/** The shortcut meant by a key: that of the graph where it has the pointer or the focus, or one of the whole page. */
function wanted(editor: Editor, event: KeyboardEvent, target: HTMLElement): PageKey | GraphKey | undefined {
  const isField = target.matches("input:not([type=checkbox]), textarea, select, [contenteditable=true]");
  if (target.closest("[role=menu], [role=dialog], [role=listbox]")) return undefined;
  const page = shortcutOf(event, "page");
  // A field whose text is not finished keeps its own undo.
  if (page) return !isField || (page.inFields && target.dataset["typing"] !== "true") ? page.id : undefined;
  if (isField) return undefined;
  // The pointer says which pane is meant; away from both, the focus does.
  const isUnderPointer = editor.canvas?.isUnderPointer() ?? false;
  if (!isUnderPointer && !target.closest(CANVAS)) return undefined;
  const key = keyOf(event);
  const isOverModel = document.querySelector(".view-pane:hover") !== null;
  if (isOverModel && !key.startsWith("Arrow") && shortcutOf(event, "model")) return undefined;
  // A button is pressed with Space and Enter, a control moved with the arrows.
  const isControl = target.closest("button, a, [role=button], [role=slider], [role=tab], [role=checkbox]") !== null;
  if (isControl && /^(Space|Enter|Arrow)/.test(key)) return undefined;
  if (key === "Space" && target.closest(".react-flow__node")) return undefined;
  return shortcutOf(event, "graph")?.id;
}

/** Where Tab would not move the focus on: without a focus, on the canvas, and on a node that is selected. */
function isOnCanvas(editor: Editor, target: HTMLElement): boolean {
  const node = target.closest<HTMLElement>(".react-flow__node");
  const isChosen = node === target && editor.session.store.get().selection.has(node.dataset["id"] ?? "");
  return isChosen || target.matches(CANVAS) || opensSearch(editor, target);
}

/** Tab opens the search only where it would not move the focus of someone who works without a pointer. */
function opensSearch(editor: Editor, target: HTMLElement): boolean {
  return (target === document.body || target.matches(CANVAS)) && (editor.canvas?.isUnderPointer() ?? false);
}

/** Tab goes from stop to stop inside a node that was opened, and leaves it behind the last. */
function moveInNode(target: HTMLElement, isBack: boolean): boolean {
  const node = target.closest<HTMLElement>(".react-flow__node");
  if (!node || target === node) return false;
  const stops = stopsIn(node);
  const at = stops.indexOf(target);
  if (at < 0) return false;
  const next = stops[at + (isBack ? -1 : 1)];
  if (next) next.focus();
  else node.focus();
  return true;
}

function leaveNode(target: HTMLElement): boolean {
  const node = target.closest<HTMLElement>(".react-flow__node");
  if (!node || node === target || target.closest("[role=menu], [role=dialog]")) return false;
  nodeElement(node.dataset["id"] ?? "")?.focus();
  return true;
}
