import { type ReactElement, useRef, useState } from "react";
import { nameProblem } from "../model/edit";
import { nameNode } from "../model/edit_ui";
import { useCurrentSession, useEditor } from "./context";

/** The name of a node while it is typed: an id, or free text beside it. Enter takes it, Escape leaves it. */
export function NameField({ id }: { id: string }): ReactElement {
  const session = useCurrentSession();
  const editor = useEditor();
  const [before] = useState(() => session.store.get().document?.labels.get(id) ?? id);
  const [text, setText] = useState(before);
  const wanted = text.trim();
  const isTaken = wanted !== id && (session.store.get().document?.nodes.has(wanted) ?? false);
  const problem = isTaken ? "Another node has this name." : undefined;
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
    } else if (wanted !== before) {
      const isId = wanted !== "" && nameProblem(wanted) === undefined;
      session.edit("Rename", nameNode(id, wanted, session.store.get().catalogue));
      if (isId && wanted !== id) {
        editor.unfold([wanted], editor.store.get().unfolded.has(id));
        session.select([wanted]);
      }
      editor.say(
        isId ? `Renamed to ${wanted}` : wanted ? `Labeled “${wanted}”; its name stays ${id}` : "The label is gone",
      );
    }
    close();
  };
  return (
    <input
      className="name-field nodrag nokey"
      aria-label="Name of the node"
      aria-invalid={problem !== undefined}
      title={problem ?? "A name that others refer to, or any text as a label beside it"}
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
