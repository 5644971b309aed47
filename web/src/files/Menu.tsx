import { useEffect, useRef, useState, type ReactElement, type ReactNode } from "react";
import { Icon } from "../app/icons";

export interface MenuItem {
  title: string;
  /** The key that does the same, as it is shown. */
  keys?: string;
  disabled?: boolean;
  run(): void;
}

interface MenuProps {
  label: string;
  /** What the button shows. */
  children: ReactNode;
  /** A gap stands where an entry is null. */
  items: readonly (MenuItem | null)[];
  align?: "left" | "right";
}

/** A button that opens a list of actions; arrow keys go through it. */
export function Menu({ label, children, items, align = "left" }: MenuProps): ReactElement {
  const [open, setOpen] = useState(false);
  const element = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);

  useEffect(() => {
    if (!open) return undefined;
    const close = (event: Event): void => {
      if (!(event.target instanceof Node && element.current?.contains(event.target))) setOpen(false);
    };
    document.addEventListener("pointerdown", close);
    element.current?.querySelector<HTMLElement>("[role=menuitem]:enabled")?.focus();
    return () => document.removeEventListener("pointerdown", close);
  }, [open]);

  const onKeyDown = (event: React.KeyboardEvent): void => {
    if (event.key === "Escape" && open) {
      event.preventDefault();
      setOpen(false);
      button.current?.focus();
    }
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step === undefined || !open) return;
    event.preventDefault();
    const all = [...(element.current?.querySelectorAll<HTMLElement>("[role=menuitem]:enabled") ?? [])];
    const at = all.indexOf(document.activeElement as HTMLElement);
    all[(at + step + all.length) % all.length]?.focus();
  };
  return (
    <div className="menu-place" ref={element} onKeyDown={onKeyDown}>
      <button
        ref={button}
        type="button"
        className="button"
        aria-haspopup="menu"
        aria-expanded={open}
        aria-label={label}
        onClick={() => setOpen(!open)}
      >
        {children}
        <Icon name="chevron" />
      </button>
      {open && (
        <div className="menu file-menu" role="menu" aria-label={label} data-align={align}>
          {items.map((item, index) =>
            item ? (
              <button
                key={item.title}
                type="button"
                role="menuitem"
                disabled={item.disabled}
                onClick={() => {
                  setOpen(false);
                  button.current?.focus();
                  item.run();
                }}
              >
                <span>{item.title}</span>
                {item.keys && <kbd>{item.keys}</kbd>}
              </button>
            ) : (
              <hr key={index} />
            ),
          )}
        </div>
      )}
    </div>
  );
}
