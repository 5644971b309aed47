import { useId, type KeyboardEvent, type ReactElement, type ReactNode } from "react";

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

/** A row of tabs and the chosen one's content. Arrow keys move between tabs. */
export function Tabs({ label, tabs, chosen, onChoose, className = "", keep = false }: TabsProps): ReactElement {
  const base = useId();
  const shown = tabs.some((tab) => tab.id === chosen) ? chosen : tabs[0]?.id;
  const onKeyDown = (event: KeyboardEvent): void => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (step === undefined) return;
    const at = tabs.findIndex((tab) => tab.id === shown);
    const next = tabs[(at + step + tabs.length) % tabs.length];
    if (!next) return;
    onChoose(next.id);
    document.getElementById(`${base}-${next.id}`)?.focus();
  };
  return (
    <div className={`tabs ${className}`}>
      <div className="tab-row" role="tablist" aria-label={label} onKeyDown={onKeyDown}>
        {tabs.map((tab) => (
          <button
            key={tab.id}
            id={`${base}-${tab.id}`}
            type="button"
            role="tab"
            className="tab"
            aria-selected={tab.id === shown}
            aria-controls={`${base}-${tab.id}-content`}
            tabIndex={tab.id === shown ? 0 : -1}
            onClick={() => onChoose(tab.id)}
          >
            {tab.title}
          </button>
        ))}
      </div>
      {tabs.map((tab) =>
        keep || tab.id === shown ? (
          <div
            key={tab.id}
            id={`${base}-${tab.id}-content`}
            className="tab-content"
            role="tabpanel"
            aria-labelledby={`${base}-${tab.id}`}
            hidden={tab.id !== shown}
          >
            {tab.content}
          </div>
        ) : null,
      )}
    </div>
  );
}
