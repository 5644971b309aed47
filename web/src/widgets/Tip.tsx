import * as Tooltip from "@radix-ui/react-tooltip";
import type { ReactElement } from "react";

const DELAY_MILLISECONDS = 500;

/** Around the page: after one tip the next ones come at once. */
export const Tips = ({ children }: { children: ReactElement | ReactElement[] }): ReactElement => (
  <Tooltip.Provider delayDuration={DELAY_MILLISECONDS}>{children}</Tooltip.Provider>
);

interface TipProps {
  text: string;
  /** The key that does the same. */
  keys?: string;
  /** The element it belongs to, which the pointer or the focus comes to. */
  children: ReactElement;
}

/** What something does, beside it while the pointer or the focus is there. */
export function Tip({ text, keys, children }: TipProps): ReactElement {
  return (
    <Tooltip.Root>
      <Tooltip.Trigger asChild>{children}</Tooltip.Trigger>
      <Tooltip.Portal>
        <Tooltip.Content className="tip" side="bottom" sideOffset={6} collisionPadding={8}>
          {text}
          {keys !== undefined && <kbd>{keys}</kbd>}
        </Tooltip.Content>
      </Tooltip.Portal>
    </Tooltip.Root>
  );
}
