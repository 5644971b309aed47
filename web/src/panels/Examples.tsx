import { type ReactElement, type RefObject, useEffect, useRef, useState } from "react";
import type { Example } from "../session/state";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { GraphPicture } from "../widgets/GraphPicture";
import { Icon } from "../widgets/Icon";

/** Until the list is here. */
const PLACEHOLDERS = ["a", "b", "c", "d", "e", "f"];

/** The gallery: a card per built-in graph. `onOpened` is told when one was chosen. */
export function Examples({ light, onOpened }: { light: boolean; onOpened?(): void }): ReactElement {
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
              light={light}
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

interface CardProps {
  example: Example;
  light: boolean;
  isChosen: boolean;
  onOpen(): void;
}

function Card({ example, light, isChosen, onOpen }: CardProps): ReactElement {
  return (
    <button type="button" className="card" aria-current={isChosen} onClick={onOpen}>
      <span className="card-picture">
        {example.image && <img src={example.image} alt="" draggable={false} />}
        {!example.image && !light && <Icon name="gallery" />}
        {light && <LightPicture example={example} />}
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

/** The server's pictures are dark. In the light theme the cards in sight are drawn again, on a clear ground. */
function LightPicture({ example }: { example: Example }): ReactElement {
  const place = useRef<HTMLSpanElement>(null);
  const isSeen = useSeen(place);
  return (
    <span className="card-light" ref={place}>
      {isSeen && <GraphPicture id={`example ${example.id}`} read={() => Promise.resolve(example.graph)} />}
    </span>
  );
}

/** True from when the element is in sight for the first time. */
function useSeen(place: RefObject<HTMLElement | null>): boolean {
  const [isSeen, setIsSeen] = useState(false);
  useEffect(() => {
    const element = place.current;
    if (!element) return undefined;
    const observer = new IntersectionObserver((entries) => {
      if (entries.some(({ isIntersecting }) => isIntersecting)) setIsSeen(true);
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [place]);
  return isSeen;
}
