import { createContext, useContext } from "react";
import type { Editor, EditorState } from "./editor";
import { useSession, useStore } from "./hooks";
import type { Session, SessionState } from "./session";

export const SessionContext = createContext<Session | null>(null);
export const EditorContext = createContext<Editor | null>(null);

/** The session of the page around this component. */
export function useCurrentSession(): Session {
  const session = useContext(SessionContext);
  if (!session) throw new Error("This component stands outside the page.");
  return session;
}

/** A part of the session's state; renders again when that part changes. */
export function useCurrent<Part>(select: (state: SessionState) => Part): Part {
  return useSession(useCurrentSession(), select);
}

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
