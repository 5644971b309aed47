import { type ReactElement, useMemo, useState } from "react";
import { matchText } from "../model/search";
import { type Choice, Chooser } from "../widgets/Chooser";
import { useCurrent, useEditor } from "../widgets/context";
import { Mark } from "../widgets/Mark";
import { Popup } from "../widgets/Popup";

interface NodeChoice extends Choice {
  id: string;
}

/** Finds a node of the open graph by title or name, and shows it. */
export function FindNode(): ReactElement {
  const editor = useEditor();
  const view = useCurrent((state) => state.view);
  const [text, setText] = useState("");
  const choices = useMemo<NodeChoice[]>(
    () =>
      (view?.nodes ?? [])
        .filter((node) => matchText(`${node.label} ${node.title} ${node.id} ${node.type}`, text))
        .slice(0, 200)
        .map((node) => ({
          id: node.id,
          key: node.id,
          content: (
            <>
              <Mark type={node.outputs[0]?.type} />
              <span className="chooser-title">{node.label || node.title}</span>
              <span className="chooser-family">{node.id}</span>
            </>
          ),
        })),
    [view, text],
  );
  const close = (): void => editor.store.set({ finding: false });
  const middle = editor.canvas?.pointer() ?? { x: 100, y: 100 };
  const [screen] = useState({ x: middle.x - 140, y: 72 });
  return (
    <Popup screen={screen} label="Find a node" className="node-search" onClose={close}>
      <Chooser
        label="Find a node"
        placeholder="Find a node of this graph"
        choices={choices}
        text={text}
        onText={setText}
        empty="No node is called that."
        onChoose={({ id }) => {
          close();
          editor.session.select([id]);
          editor.canvas?.fit([id]);
          editor.canvas?.focusNode(id);
        }}
      />
    </Popup>
  );
}
