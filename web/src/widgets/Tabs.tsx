import * as RadixTabs from "@radix-ui/react-tabs";
import type { ReactElement, ReactNode } from "react";

export interface Tab {
  id: string;
  title: ReactNode;
  content: ReactNode;
}

interface TabsProps {
  label: string;
  tabs: Tab[];
  chosen: string;
  onChoose(id: string): void;
  className?: string;
  /** Keeps the content of hidden tabs alive: a 3D view that is taken away has to start again. */
  keep?: boolean;
}

/** A row of tabs and the chosen one's content. */
export function Tabs({ label, tabs, chosen, onChoose, className = "", keep = false }: TabsProps): ReactElement {
  return (
    <RadixTabs.Root className={`tabs ${className}`} value={chosen} onValueChange={onChoose}>
      <RadixTabs.List className="tab-row" aria-label={label}>
        {tabs.map((tab) => (
          <RadixTabs.Trigger
            key={tab.id}
            className="tab"
            value={tab.id}
            // The library gives a pressed tab the focus, which browsers take for a reason to show it.
            onMouseDown={({ currentTarget }) => currentTarget.setAttribute("data-pressed", "")}
            onKeyDown={({ currentTarget }) => currentTarget.removeAttribute("data-pressed")}
            onBlur={({ currentTarget }) => currentTarget.removeAttribute("data-pressed")}
          >
            {tab.title}
          </RadixTabs.Trigger>
        ))}
      </RadixTabs.List>
      {tabs.map((tab) => (
        <RadixTabs.Content
          key={tab.id}
          className="tab-content"
          value={tab.id}
          // A pane is not worth a stop of its own: what is in it has some.
          {...(keep && { forceMount: true, hidden: tab.id !== chosen, tabIndex: -1 })}
        >
          {tab.content}
        </RadixTabs.Content>
      ))}
    </RadixTabs.Root>
  );
}
