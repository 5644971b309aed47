import { useEffect, useRef, type KeyboardEvent, type ReactElement } from "react";
import { useEditor } from "../app/context";
import type { Menu } from "../app/editor";
import { keyText } from "../app/shortcuts";
import { menuItems, type MenuItem } from "./menu_items";
import { Popup } from "./Popup";

const LABELS = { canvas: "Canvas", node: "Node", wire: "Wire", area: "Area" };

/** The menu of what was pressed with the right button, or for long. */
export function ContextMenu({ menu }: { menu: Menu }): ReactElement {
  const editor = useEditor();
  const close = (): void => editor.store.set({ menu: null });
  return (
    <Popup
      screen={menu.screen}
      label={`${LABELS[menu.target.kind]} menu`}
      className="context-menu"
      role="menu"
      onClose={close}
    >
      <MenuList items={menuItems(editor, menu)} onDone={close} />
    </Popup>
  );
}

/** Items of a menu: arrows move, Enter chooses. */
export function MenuList({ items, onDone }: { items: readonly MenuItem[]; onDone(): void }): ReactElement {
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => list.current?.querySelector<HTMLElement>("[role=menuitem]")?.focus({ preventScroll: true }), []);
  const onKeyDown = (event: KeyboardEvent): void => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const all = [...(list.current?.querySelectorAll<HTMLElement>("[role=menuitem]:not(:disabled)") ?? [])];
    const at = all.indexOf(document.activeElement as HTMLElement);
    all[(at + step + all.length) % all.length]?.focus();
  };
  return (
    <div className="menu-items" ref={list} onKeyDown={onKeyDown}>
      {items.map((item) => (
        <button
          key={item.title}
          type="button"
          role="menuitem"
          className="menu-item"
          data-group={item.isNewGroup}
          disabled={item.isDisabled}
          onClick={() => {
            onDone();
            item.run();
          }}
        >
          <span>{item.title}</span>
          {item.shortcut !== undefined && <kbd>{keyText(item.shortcut)}</kbd>}
        </button>
      ))}
    </div>
  );
}
