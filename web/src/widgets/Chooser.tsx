import { type ReactElement, type ReactNode, useEffect, useId, useRef, useState } from "react";

export interface Choice {
  key: string;
  content: ReactNode;
  /** Heading above this choice, where a group begins. */
  heading?: string;
  isDisabled?: boolean;
}

interface ChooserProps<Item extends Choice> {
  label: string;
  placeholder: string;
  /** Said at the right of the field, as what the list is limited to. */
  note?: string;
  choices: readonly Item[];
  text: string;
  onText(text: string): void;
  onChoose(item: Item): void;
  /** What is shown when nothing is found. */
  empty: string;
  /** Something about the active choice, at the foot. */
  foot?(item: Item): ReactNode;
}

/** A field with a list below it: typing filters, arrows move, Enter chooses. */
export function Chooser<Item extends Choice>(props: ChooserProps<Item>): ReactElement {
  const { label, placeholder, note, choices, text, onText, onChoose, empty, foot } = props;
  const base = useId();
  const list = useRef<HTMLDivElement>(null);
  const [active, setActive] = useState(0);
  const shown = Math.min(active, Math.max(0, choices.length - 1));
  useEffect(() => setActive(0), [text]);
  useEffect(() => {
    list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" });
  }, [shown, choices]);

  const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 } as Record<string, number>;
  const current = choices[shown];
  return (
    <>
      <div className="chooser-field">
        <input
          type="text"
          role="combobox"
          aria-label={label}
          aria-expanded
          aria-controls={`${base}-list`}
          aria-activedescendant={current && `${base}-${current.key}`}
          autoComplete="off"
          spellCheck={false}
          autoFocus
          placeholder={placeholder}
          value={text}
          onChange={(event) => onText(event.currentTarget.value)}
          onKeyDown={(event) => {
            const move = step[event.key];
            if (move !== undefined) {
              event.preventDefault();
              setActive(Math.min(choices.length - 1, Math.max(0, shown + move)));
            }
            if (event.key === "Enter" && current && !current.isDisabled) {
              event.preventDefault();
              onChoose(current);
            }
            if (event.key === "Tab") event.preventDefault();
          }}
        />
        {note && <span className="chooser-note">{note}</span>}
      </div>
      <div id={`${base}-list`} className="chooser-list nowheel" role="listbox" aria-label={label} ref={list}>
        {choices.map((item, index) => (
          <div key={item.key} role="presentation">
            {item.heading !== undefined && <span className="chooser-heading">{item.heading}</span>}
            {/* biome-ignore lint/a11y/useKeyWithClickEvents: the field above hears the keys for all of them. */}
            <div
              id={`${base}-${item.key}`}
              role="option"
              tabIndex={-1}
              className="chooser-item"
              aria-selected={index === shown}
              aria-disabled={item.isDisabled}
              // The focus stays in the field.
              onMouseDown={(event) => event.preventDefault()}
              onPointerMove={() => setActive(index)}
              onClick={() => {
                if (!item.isDisabled) onChoose(item);
              }}
            >
              {item.content}
            </div>
          </div>
        ))}
      </div>
      {choices.length === 0 && <p className="chooser-empty">{empty}</p>}
      {current && foot && <div className="chooser-foot">{foot(current)}</div>}
    </>
  );
}
