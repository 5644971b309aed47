import {
  type CSSProperties,
  type ReactElement,
  type ReactNode,
  useEffect,
  useLayoutEffect,
  useRef,
  useState,
} from "react";
import type { Position } from "../model/ui";

interface PopupProps {
  screen: Position;
  label: string;
  className: string;
  onClose(): void;
  children: ReactNode;
}

const MARGIN = 8;

/** A box over the page at a point of the screen, kept inside the window. It closes with Escape, or a press beside it. */
export function Popup({ screen, label, className, onClose, children }: PopupProps): ReactElement {
  const element = useRef<HTMLDivElement>(null);
  const [place, setPlace] = useState(screen);
  // Read before anything inside takes the focus.
  const [before] = useState(() => document.activeElement);
  const close = useRef(onClose);
  close.current = onClose;

  useLayoutEffect(() => {
    const box = element.current;
    if (!box) return undefined;
    const fit = (): void => {
      const { offsetWidth: width, offsetHeight: height } = box;
      setPlace({
        x: Math.max(MARGIN, Math.min(screen.x, window.innerWidth - width - MARGIN)),
        y: Math.max(MARGIN, Math.min(screen.y, window.innerHeight - height - MARGIN)),
      });
    };
    fit();
    const observer = new ResizeObserver(fit);
    observer.observe(box);
    return () => observer.disconnect();
  }, [screen]);

  useEffect(() => {
    const onPress = (event: PointerEvent): void => {
      if (event.target instanceof Node && !element.current?.contains(event.target)) close.current();
    };
    // The press that opened it has passed by the time this listens.
    document.addEventListener("pointerdown", onPress, true);
    return () => {
      document.removeEventListener("pointerdown", onPress, true);
      const isLost = document.activeElement === null || document.activeElement === document.body;
      if (isLost && before instanceof HTMLElement) before.focus({ preventScroll: true });
    };
  }, [before]);

  return (
    <div
      ref={element}
      className={`popup ${className}`}
      role="dialog"
      aria-label={label}
      style={{ left: place.x, top: place.y } as CSSProperties}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        event.stopPropagation();
        onClose();
      }}
      onContextMenu={(event) => event.preventDefault()}
    >
      {children}
    </div>
  );
}
