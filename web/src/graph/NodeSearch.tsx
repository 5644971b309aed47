import { type ReactElement, useMemo, useState } from "react";
import { listed } from "../model/check";
import { socketsFor } from "../model/edit_wires";
import { type Finding, findNodes } from "../model/search";
import { addFinding } from "../session/adding";
import { looseEnd, type Search } from "../session/editor";
import { type Choice, Chooser } from "../widgets/Chooser";
import { useCurrent, useEditor } from "../widgets/context";
import { Mark } from "../widgets/Mark";
import { Popup } from "../widgets/Popup";

interface FoundChoice extends Choice {
  finding: Finding;
}

/** The search for a node to add. Without a text it lists everything by family. */
export function NodeSearch({ search }: { search: Search }): ReactElement {
  const editor = useEditor();
  const catalogue = useCurrent((state) => state.catalogue);
  const document = useCurrent((state) => state.document);
  const [text, setText] = useState("");
  const choices = useMemo<FoundChoice[]>(() => {
    if (!catalogue || !document) return [];
    const end = looseEnd(search);
    let found = findNodes(catalogue, text, end, editor.habits());
    const { wire } = search;
    if (wire) found = found.filter(({ card }) => socketsFor(document, catalogue, card, wire));
    // Without a text the families are headings; with one the best match comes first.
    const isList = text.trim() === "" && !end;
    if (isList) {
      const order = [...catalogue.families.keys()];
      found = [...found].sort((a, b) => order.indexOf(a.card.family) - order.indexOf(b.card.family));
    }
    return found.map((finding, index) => {
      const { card } = finding;
      const family = catalogue.families.get(card.family) ?? card.family;
      const isFirst = found[index - 1]?.card.family !== card.family;
      return {
        finding,
        key: `${card.id}-${finding.title ?? ""}`.replace(/[^\w-]/g, "_"),
        heading: isList && isFirst ? family : undefined,
        content: (
          <>
            <Mark type={card.outputs[0]?.types.length === 1 ? card.outputs[0].types[0] : undefined} />
            <span className="chooser-title">{finding.title ?? card.title}</span>
            {finding.word !== undefined && <span className="chooser-socket">{finding.word}</span>}
            {finding.socket !== undefined && card.inputs.length + card.outputs.length > 2 && (
              <span className="chooser-socket">{socketTitle(finding)}</span>
            )}
            {!isList && <span className="chooser-family">{family}</span>}
          </>
        ),
      };
    });
  }, [catalogue, document, editor, search, text]);
  const { loose } = search;
  const note = loose && `${loose.side === "output" ? "takes" : "gives"} ${listed(loose.types)}`;
  const label = search.replaced !== undefined ? "Replace by" : search.wire ? "Insert a node" : "Add a node";
  const close = (): void => editor.store.set({ search: null });
  return (
    <Popup screen={search.screen} label={label} className="node-search" onClose={close}>
      <Chooser
        label={label}
        placeholder={loose || search.wire ? "Search" : "Search, or type 3.2 · 0<5<10 · 1,2,3"}
        note={note}
        choices={choices}
        text={text}
        onText={setText}
        empty="Nothing is called that here."
        foot={({ finding }) => finding.card.description}
        onChoose={({ finding }) => {
          close();
          const id = addFinding(editor, finding, search);
          if (id !== undefined) editor.canvas?.focusNode(id);
        }}
      />
    </Popup>
  );
}

/** What the socket is called that the wire would end at. */
function socketTitle({ card, socket }: Finding): string | undefined {
  return [...card.inputs, ...card.outputs].find(({ name }) => name === socket)?.title;
}
