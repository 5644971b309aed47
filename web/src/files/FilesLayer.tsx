import { type ReactElement, useEffect, useRef, useState } from "react";
import { useCurrentSession } from "../widgets/context";
import { useStore } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";
import { ConflictDialog } from "./ConflictDialog";
import { ExportDialog } from "./ExportDialog";
import { filesOf } from "./Files";
import { KeepDialog } from "./KeepDialog";
import { OpenStoredDialog } from "./OpenStoredDialog";
import { RecoverDialog } from "./RecoverDialog";
import { ShareDialog } from "./ShareDialog";
import { TokenDialog } from "./TokenDialog";

/** What files bring over the page: dialogs, a place to drop, and what was done. */
export function FilesLayer(): ReactElement {
  const files = filesOf(useCurrentSession());
  const dialog = useStore(files.store, (state) => state.dialog);
  const note = useStore(files.store, (state) => state.note);
  const dropping = useDrop((file) => void files.take(file));
  return (
    <>
      {dialog === "model-file" && <ExportDialog />}
      {dialog === "recover" && <RecoverDialog />}
      {dialog === "share" && <ShareDialog />}
      {dialog === "open-stored" && <OpenStoredDialog />}
      {dialog === "keep" && <KeepDialog />}
      {dialog === "conflict" && <ConflictDialog />}
      <TokenDialog />
      {dropping && (
        <div className="drop-place">
          <p>Drop a graph (.json), a model of Dini (.glb) or a mesh (.obj, .ply, .stl, .glb)</p>
        </div>
      )}
      <div className="files-note-place" role="status">
        {note && (
          <p className="files-note" data-tone={note.tone}>
            <Icon name={note.tone === "good" ? "check" : "alert"} />
            <span>{note.text}</span>
            {note.action && (
              <button
                type="button"
                className="button"
                onClick={() => {
                  files.store.set({ note: null });
                  note.action?.run();
                }}
              >
                {note.action.title}
              </button>
            )}
            <button type="button" className="button quiet" onClick={() => files.store.set({ note: null })}>
              Dismiss
            </button>
          </p>
        )}
      </div>
    </>
  );
}

/** True while files are dragged over the page; `take` gets what is dropped. */
function useDrop(take: (file: File) => void): boolean {
  const [over, setOver] = useState(false);
  const newest = useRef(take);
  newest.current = take;
  useEffect(() => {
    // Entering and leaving are told for every element on the way.
    let depth = 0;
    const hasFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
    const onEnter = (event: DragEvent): void => {
      if (hasFiles(event)) setOver(++depth > 0);
    };
    const onLeave = (event: DragEvent): void => {
      if (hasFiles(event)) setOver(--depth > 0);
    };
    const onOver = (event: DragEvent): void => {
      if (hasFiles(event)) event.preventDefault();
    };
    const onDrop = (event: DragEvent): void => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      depth = 0;
      setOver(false);
      for (const file of event.dataTransfer?.files ?? []) newest.current(file);
    };
    const listeners = { dragenter: onEnter, dragleave: onLeave, dragover: onOver, drop: onDrop };
    for (const [name, run] of Object.entries(listeners)) document.addEventListener(name, run as EventListener);
    return () => {
      for (const [name, run] of Object.entries(listeners)) document.removeEventListener(name, run as EventListener);
    };
  }, []);
  return over;
}
