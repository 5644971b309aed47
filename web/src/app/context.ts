import { createContext, useContext } from "react";
import { useSession } from "./hooks";
import type { Session, SessionState } from "./session";

export const SessionContext = createContext<Session | null>(null);

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
