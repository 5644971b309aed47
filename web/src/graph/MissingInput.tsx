import { type ReactElement, useMemo } from "react";
import { likelySource } from "../model/beginnings";
import type { ViewNode } from "../model/graph";
import { socketFor } from "../model/search";
import { addFinding } from "../session/adding";
import type { Search } from "../session/editor";
import { useCurrent, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";

/** How far left of a node what feeds it is put, in pixels. */
const GAP = 32;

/** What can be done about an input that lacks its wire: the likeliest node, or the search for all that fit. */
export function MissingInput({ node }: { node: ViewNode }): ReactElement | null {
  const editor = useEditor();
  const catalogue = useCurrent((state) => state.catalogue);
  const row = node.inputs.find(({ required, isDefault, hasSocket }) => required && isDefault && hasSocket);
  const card = useMemo(() => (catalogue && row ? likelySource(catalogue, row.types) : undefined), [catalogue, row]);
  if (!row) return null;
  const search = (): Search | undefined => {
    const at = editor.session.store.get().document?.positions.get(node.id);
    const place = at && { x: at.x - GAP, y: at.y };
    const screen = place && editor.canvas?.screenAt(place);
    return screen && { screen, place, loose: { node: node.id, side: "input", name: row.name, types: row.types } };
  };
  const add = (): void => {
    const wanted = search();
    const socket = card && socketFor(card, { side: "input", types: row.types })?.name;
    if (card && wanted) addFinding(editor, { card, socket }, wanted);
  };
  return (
    <div className="node-remedy nodrag">
      {card && (
        <button type="button" className="button" tabIndex={-1} data-stop onClick={add}>
          <Icon name="add" />
          <span>Add {card.title}</span>
        </button>
      )}
      <button
        type="button"
        className="button quiet"
        tabIndex={-1}
        data-stop
        aria-label={`Find a node for ${row.title} of ${node.title}`}
        onClick={() => {
          const wanted = search();
          if (wanted) editor.openSearch(wanted);
        }}
      >
        Others…
      </button>
    </div>
  );
}
