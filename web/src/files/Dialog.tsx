import { useEffect, useRef, type ReactElement, type ReactNode } from "react";

interface DialogProps {
  title: string;
  onClose(): void;
  children: ReactNode;
  /** Buttons at the end, beside Close. */
  actions?: ReactNode;
}

/** A window over the page that keeps the focus until it is closed. */
export function Dialog({ title, onClose, children, actions }: DialogProps): ReactElement {
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const dialog = element.current;
    const before = document.activeElement;
    dialog?.showModal();
    return () => {
      dialog?.close();
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <dialog
      ref={element}
      role="dialog"
      className="dialog"
      aria-label={title}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
      onClick={(event) => {
        // A press beside the window falls on the dialog's own element.
        if (event.target === element.current) onClose();
      }}
    >
      <div className="dialog-body">
        <h2>{title}</h2>
        {children}
        <div className="dialog-actions">
          <button type="button" className="button quiet" onClick={onClose}>
            Close
          </button>
          {actions}
        </div>
      </div>
    </dialog>
  );
}
