import { type ReactElement, useState } from "react";
import type { Example } from "../session/state";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Icon } from "../widgets/Icon";

/** Until the list is here. */
const PLACEHOLDERS = ["a", "b", "c", "d", "e", "f"];

/** The gallery: a card per built-in graph. `onOpened` is told when one was chosen. */
export function Examples({ onOpened }: { onOpened?(): void }): ReactElement {
  const session = useCurrentSession();
  const [query, setQuery] = useState("");
  const examples = useCurrent((state) => state.examples);
  const chosen = useCurrent((state) => state.exampleId);
  const shown = examples?.filter((example) => fits(example, query));
  return (
    <nav className="gallery" aria-label="Examples">
      <input
        className="text-field gallery-filter"
        type="search"
        aria-label="Find an example"
        placeholder="Find by title, text or figure"
        value={query}
        onChange={(event) => setQuery(event.currentTarget.value)}
      />
      <ul className="cards">
        {shown?.map((example) => (
          <li key={example.id}>
            <Card
              example={example}
              isChosen={example.id === chosen}
              onOpen={() => {
                session.openExample(example.id);
                onOpened?.();
              }}
            />
          </li>
        ))}
        {!examples && PLACEHOLDERS.map((key) => <li key={key} className="card card-empty" />)}
      </ul>
      {shown?.length === 0 && query && <p className="empty">No example says “{query}”.</p>}
      {examples?.length === 0 && <p className="empty">This server has no examples.</p>}
    </nav>
  );
}

/** Every word stands somewhere in what is said of the example. */
function fits({ title, description, figure }: Example, query: string): boolean {
  const text = `${title} ${description} ${figure && `fig. ${figure}`}`.toLowerCase();
  return query
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

function Card({ example, isChosen, onOpen }: { example: Example; isChosen: boolean; onOpen(): void }): ReactElement {
  return (
    <button type="button" className="card" aria-current={isChosen} onClick={onOpen}>
      <span className="card-picture">
        {example.image ? <img src={example.image} alt="" draggable={false} /> : <Icon name="gallery" />}
      </span>
      <span className="card-text">
        <span className="card-title">
          {example.title}
          {example.figure && <span className="card-figure">Fig. {example.figure}</span>}
        </span>
        {example.description && <span className="card-description">{example.description}</span>}
      </span>
    </button>
  );
}
