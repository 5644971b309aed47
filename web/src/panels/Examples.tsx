import type { ReactElement } from "react";
import type { Example } from "../session/state";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Icon } from "../widgets/Icon";

/** Until the list is here. */
const PLACEHOLDERS = ["a", "b", "c", "d", "e", "f"];

/** The gallery: a card per built-in graph. */
export function Examples(): ReactElement {
  const session = useCurrentSession();
  const examples = useCurrent((state) => state.examples);
  const chosen = useCurrent((state) => state.exampleId);
  return (
    <nav className="gallery" aria-label="Examples">
      <div className="gallery-head">
        <h2>Examples</h2>
        <span>{examples ? examples.length : ""}</span>
      </div>
      <ul className="cards">
        {examples?.map((example) => (
          <li key={example.id}>
            <Card example={example} isChosen={example.id === chosen} onOpen={() => session.openExample(example.id)} />
          </li>
        ))}
        {!examples && PLACEHOLDERS.map((key) => <li key={key} className="card card-empty" />)}
      </ul>
      {examples?.length === 0 && <p className="empty">This server has no examples.</p>}
    </nav>
  );
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
