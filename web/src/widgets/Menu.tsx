import * as DropdownMenu from "@radix-ui/react-dropdown-menu";
import { Fragment, type ReactElement, type ReactNode, useState } from "react";
import type { Position } from "../model/ui";
import { keyText, type ShortcutId } from "../session/shortcuts";
import { Icon } from "./Icon";

export interface MenuItem {
  title: string;
  /** The key that does the same. */
  shortcut?: ShortcutId;
  isDisabled?: boolean;
  /** A line stands above it. */
  isNewGroup?: boolean;
  run(): void;
}

interface DropMenuProps {
  label: string;
  items: readonly MenuItem[];
  align?: "start" | "end";
  className?: string;
  /** What the button shows. */
  children: ReactNode;
}

/** A button that opens a list of actions. */
export function DropMenu({
  label,
  items,
  align = "start",
  className = "button",
  children,
}: DropMenuProps): ReactElement {
  return (
    // Not modal: that would lock scrolling with a style sheet of its own, which the page's policy forbids.
    <DropdownMenu.Root modal={false}>
      <DropdownMenu.Trigger className={className} aria-label={label}>
        {children}
        <Icon name="open" />
      </DropdownMenu.Trigger>
      <Items label={label} items={items} align={align} />
    </DropdownMenu.Root>
  );
}

interface PointMenuProps {
  label: string;
  items: readonly MenuItem[];
  /** Its corner on the screen. */
  screen: Position;
  onClose(): void;
}

/** A list of actions at a point of the page, open as long as it is drawn. */
export function PointMenu({ label, items, screen, onClose }: PointMenuProps): ReactElement {
  // Read before anything inside takes the focus.
  const [before] = useState(() => document.activeElement);
  return (
    <DropdownMenu.Root open modal={false} onOpenChange={(isOpen) => !isOpen && onClose()}>
      <DropdownMenu.Trigger asChild>
        <span className="menu-anchor" style={{ left: screen.x, top: screen.y }} aria-hidden />
      </DropdownMenu.Trigger>
      <Items label={label} items={items} align="start" offset={0} before={before} />
    </DropdownMenu.Root>
  );
}

interface ItemsProps {
  label: string;
  items: readonly MenuItem[];
  align: "start" | "end";
  offset?: number;
  /** What has the focus again after the menu; the button of the menu unless told. */
  before?: Element | null;
}

function Items({ label, items, align, offset = 6, before }: ItemsProps): ReactElement {
  return (
    <DropdownMenu.Portal>
      <DropdownMenu.Content
        className="menu"
        aria-label={label}
        align={align}
        sideOffset={offset}
        collisionPadding={8}
        loop
        onCloseAutoFocus={(event) => {
          // An action may have put the focus where it is wanted.
          const isTaken = document.activeElement !== null && document.activeElement !== document.body;
          if (!isTaken && before === undefined) return;
          event.preventDefault();
          if (!isTaken && before instanceof HTMLElement) before.focus({ preventScroll: true });
        }}
      >
        {items.map((item) => (
          <Fragment key={item.title}>
            {item.isNewGroup && <DropdownMenu.Separator className="menu-line" />}
            <DropdownMenu.Item className="menu-item" disabled={item.isDisabled} onSelect={() => item.run()}>
              <span>{item.title}</span>
              {item.shortcut !== undefined && <kbd>{keyText(item.shortcut)}</kbd>}
            </DropdownMenu.Item>
          </Fragment>
        ))}
      </DropdownMenu.Content>
    </DropdownMenu.Portal>
  );
}
