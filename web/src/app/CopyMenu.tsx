import { useEffect, useRef, useState, type ReactElement } from "react";
import { commandLineText, curlText } from "./commands";
import { useCurrent, useCurrentSession } from "./context";
import { Icon } from "./icons";

const KINDS = [
  { title: "Copy as curl", text: curlText },
  { title: "Copy as dini eval", text: commandLineText },
] as const;

/** The open graph with its present values as a command, on the clipboard. */
export function CopyMenu(): ReactElement {
  const session = useCurrentSession();
  const ready = useCurrent((state) => state.document !== null);
  const [open, setOpen] = useState(false);
  const [note, setNote] = useState("");
  const element = useRef<HTMLDivElement>(null);

  useEffect(() => {
    if (!open) return undefined;
    const close = (event: Event): void => {
      const isInside = event.target instanceof Node && element.current?.contains(event.target);
      if (event instanceof KeyboardEvent ? event.key === "Escape" : !isInside) setOpen(false);
    };
    document.addEventListener("pointerdown", close);
    document.addEventListener("keydown", close);
    element.current?.querySelector<HTMLElement>("[role=menuitem]")?.focus();
    return () => {
      document.removeEventListener("pointerdown", close);
      document.removeEventListener("keydown", close);
    };
  }, [open]);

  const copy = async (text: string | undefined): Promise<void> => {
    setOpen(false);
    if (text === undefined) return;
    try {
      await navigator.clipboard.writeText(text);
      setNote("Copied");
    } catch {
      setNote("The browser did not allow copying");
    }
    window.setTimeout(() => setNote(""), 2500);
  };
  return (
    <div className="menu-place" ref={element}>
      {note && (
        <span className="menu-note" role="status">
          {note}
        </span>
      )}
      <button
        type="button"
        className="button"
        aria-haspopup="menu"
        aria-expanded={open}
        aria-label="Copy as a command"
        disabled={!ready}
        onClick={() => setOpen(!open)}
      >
        <Icon name="copy" />
        <span className="wide-only">Copy</span>
        <Icon name="chevron" />
      </button>
      {open && (
        <div className="menu" role="menu" aria-label="Copy as a command">
          {KINDS.map((kind) => (
            <button key={kind.title} type="button" role="menuitem" onClick={() => void copy(kind.text(session))}>
              {kind.title}
            </button>
          ))}
        </div>
      )}
    </div>
  );
}
