import { type ReactElement, useRef, useState } from "react";
import { nameProblem, renameNode } from "../model/edit";
import { useCurrentSession, useEditor } from "./context";

/** The name of a node while it is typed. Enter takes it, Escape leaves it. */
export function NameField({ id }: { id: string }): ReactElement {
  const session = useCurrentSession();
  const editor = useEditor();
  const [text, setText] = useState(id);
  const problem = problemOf(text);
  function problemOf(name: string): string | undefined {
    if (name === id) return undefined;
    if (session.store.get().document?.nodes.has(name)) return "Another node has this name.";
    return nameProblem(name);
  }
  // Leaving the field, however it happens, counts once.
  const isDone = useRef(false);
  const close = (): void => {
    isDone.current = true;
    editor.store.set({ renaming: null });
    editor.canvas?.focusNode(session.store.get().selected ?? id);
  };
  const commit = (): void => {
    if (isDone.current) return;
    if (problem) {
      editor.say(problem, "refused");
    } else if (text !== id) {
      session.edit("Rename", renameNode(id, text));
      editor.unfold([text], editor.store.get().unfolded.has(id));
      session.select([text]);
      editor.say(`Renamed to ${text}`);
    }
    close();
  };
  return (
    <input
      className="name-field nodrag nokey"
      aria-label="Name of the node"
      aria-invalid={problem !== undefined}
      title={problem}
      autoFocus
      autoComplete="off"
      spellCheck={false}
      value={text}
      onFocus={(event) => event.currentTarget.select()}
      onChange={(event) => setText(event.currentTarget.value)}
      onBlur={commit}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") commit();
        if (event.key === "Escape") {
          event.preventDefault();
          close();
        }
      }}
    />
  );
}
