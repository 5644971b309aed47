import type { ReactElement } from "react";
import { renameGroup } from "../model/groups";
import { asObject, asString } from "../model/json";
import { sentenceCase } from "../model/parameters";
import { leave } from "../session/grouping";
import { useCurrent, useEditor } from "../widgets/context";
import { LineField } from "../widgets/LineField";

/** Where the canvas is: the groups around it, each a way out, and the name of the one that is looked at. */
export function GroupPath(): ReactElement | null {
  const editor = useEditor();
  const inside = useCurrent((state) => state.document?.inside);
  const groups = useCurrent((state) => state.document?.json["groups"]);
  const title = useCurrent((state) => state.document?.title ?? "");
  const last = inside?.at(-1);
  if (!inside || !last) return null;
  const labelOf = (group: string): string =>
    asString(asObject(asObject(groups)[group])["label"]) || sentenceCase(group);
  return (
    <nav className="group-path" aria-label="Groups around the canvas">
      {[title, ...inside.slice(0, -1).map(({ group }) => labelOf(group))].map((text, at) => (
        <span
          key={inside
            .slice(0, at)
            .map(({ id }) => id)
            .join("/")}
        >
          <button type="button" className="button quiet" onClick={() => leave(editor, inside.length - at)}>
            {text}
          </button>
          <span aria-hidden="true">›</span>
        </span>
      ))}
      <LineField
        id="group-label"
        label="Name of the group"
        text={labelOf(last.group)}
        onText={(text) => {
          if (text.trim() === "") return "A group needs a name.";
          editor.session.edit("Rename the group", renameGroup(last.group, text.trim()));
          return undefined;
        }}
      />
    </nav>
  );
}
