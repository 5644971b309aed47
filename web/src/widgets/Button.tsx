import type { MouseEvent, ReactElement, ReactNode } from "react";
import { keyText, type ShortcutId } from "../session/shortcuts";
import { Icon, type IconName } from "./Icon";
import { Tip } from "./Tip";

interface IconButtonProps {
  /** Its name, for screen readers and as its tip. */
  label: string;
  icon: IconName;
  /** More than the name, as the tip. */
  hint?: string;
  /** The key that does the same; the tip shows it. */
  shortcut?: ShortcutId;
  /** Of a button that switches something on and off. */
  pressed?: boolean;
  expanded?: boolean;
  disabled?: boolean;
  className?: string;
  /** Beside the icon. */
  children?: ReactNode;
  onClick(event: MouseEvent<HTMLButtonElement>): void;
}

/** A button that is an icon. Pointer and focus bring up what it does. */
export function IconButton(props: IconButtonProps): ReactElement {
  const { label, icon, hint, shortcut, pressed, expanded, disabled, className, children, onClick } = props;
  return (
    <Tip text={hint ?? label} keys={shortcut && keyText(shortcut)}>
      <button
        type="button"
        className={className ?? "button icon-button"}
        aria-label={label}
        aria-pressed={pressed}
        aria-expanded={expanded}
        disabled={disabled}
        onClick={onClick}
      >
        <Icon name={icon} />
        {children}
      </button>
    </Tip>
  );
}
