import { type ReactElement, useMemo } from "react";
import { beginningsOf, FIRST_TYPES } from "../model/beginnings";
import type { Catalogue, NodeCard } from "../model/catalogue";
import { addFinding } from "../session/adding";
import { useCurrent, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { Mark } from "../widgets/Mark";

/** What an empty canvas says: how to begin, and nodes to begin with. */
export function EmptyCanvas(): ReactElement {
  const editor = useEditor();
  const catalogue = useCurrent((state) => state.catalogue);
  const cards = useMemo(() => (catalogue ? beginnings(catalogue) : []), [catalogue]);
  return (
    <div className="empty-canvas">
      <p className="empty-title">An empty graph</p>
      <p>Double-click anywhere, or press Space, to add a node.</p>
      <div className="empty-choices">
        {cards.map((card) => (
          <button
            key={card.id}
            type="button"
            className="button quiet"
            onClick={() => {
              const screen = editor.canvas?.pointer() ?? { x: 0, y: 0 };
              const place = editor.canvas?.placeAt(screen) ?? { x: 0, y: 0 };
              addFinding(editor, { card }, { screen, place });
            }}
          >
            <Mark type={card.outputs[0]?.types[0]} />
            <span>{card.title}</span>
          </button>
        ))}
        <button type="button" className="button quiet" onClick={() => editor.openSearch()}>
          <Icon name="add" />
          <span>All nodes</span>
        </button>
      </div>
    </div>
  );
}

function beginnings(catalogue: Catalogue): NodeCard[] {
  return FIRST_TYPES.flatMap((type) => {
    const [simplest] = beginningsOf(catalogue, type).sort(
      (a, b) => a.inputs.length - b.inputs.length || a.title.length - b.title.length,
    );
    return simplest ? [simplest] : [];
  });
}
