import * as RadixDialog from "@radix-ui/react-dialog";
import { type ReactElement, type ReactNode, useState } from "react";
import { IconButton } from "./Button";

interface DialogProps {
  title: string;
  onClose(): void;
  children: ReactNode;
  /** Buttons at the end, beside Close. */
  actions?: ReactNode;
  className?: string;
}

/** A window over the page that keeps the focus until it is closed, open as long as it is drawn. */
export function Dialog({ title, onClose, children, actions, className = "" }: DialogProps): ReactElement {
  // Read before anything inside takes the focus.
  const [before] = useState(() => document.activeElement);
  return (
    <RadixDialog.Root open onOpenChange={(isOpen) => !isOpen && onClose()}>
      <RadixDialog.Portal>
        {/* Not the library's own shade: that locks scrolling with a style sheet, which the page's policy forbids. */}
        <div className="dialog-shade" />
        <RadixDialog.Content
          className={`dialog ${className}`}
          aria-describedby={undefined}
          onOpenAutoFocus={(event) => {
            // Not the first button: its tip would come up at once, and take the first Escape for itself.
            event.preventDefault();
            if (event.target instanceof HTMLElement) event.target.focus();
          }}
          onCloseAutoFocus={(event) => {
            event.preventDefault();
            const isLost = document.activeElement === null || document.activeElement === document.body;
            if (isLost && before instanceof HTMLElement) before.focus();
          }}
        >
          <header className="dialog-head">
            <RadixDialog.Title>{title}</RadixDialog.Title>
            {!actions && <IconButton label="Close" icon="close" onClick={onClose} />}
          </header>
          <div className="dialog-body">{children}</div>
          {actions && (
            <div className="dialog-actions">
              <button type="button" className="button quiet" onClick={onClose}>
                Close
              </button>
              {actions}
            </div>
          )}
        </RadixDialog.Content>
      </RadixDialog.Portal>
    </RadixDialog.Root>
  );
}
