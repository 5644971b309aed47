// What components know of the page around them: the session with the open graph, and the state of the editor.

import { createContext, useContext } from "react";
import { lookedAt } from "../model/document";
import type { Parameter } from "../model/parameters";
import type { Editor, EditorState } from "../session/editor";
import type { Session } from "../session/session";
import type { SessionState } from "../session/state";
import { useStore } from "./hooks";

export const EditorContext = createContext<Editor | null>(null);

/** The editor of the page around this component. */
export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (!editor) throw new Error("This component stands outside the page.");
  return editor;
}

/** A part of the editor's state; renders again when that part changes. */
export function useEditing<Part>(select: (state: EditorState) => Part): Part {
  return useStore(useEditor().store, select);
}

/** The session of the page around this component. */
export function useCurrentSession(): Session {
  return useEditor().session;
}

/** A part of the session's state; renders again when that part changes. */
export function useCurrent<Part>(select: (state: SessionState) => Part): Part {
  return useStore(useCurrentSession().store, select);
}

const NO_PARAMETERS: readonly Parameter[] = [];

/** The parameters of the whole graph, also while one of its groups is looked at. */
export function useWholeParameters(): readonly Parameter[] {
  return useCurrent(({ document }) => (document ? lookedAt(document, []).parameters : NO_PARAMETERS));
}
