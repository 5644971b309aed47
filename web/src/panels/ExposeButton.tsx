import type { ReactElement } from "react";
import { conceal, expose, parameterTypeFor } from "../model/edit_parameters";
import type { InputRow } from "../model/graph";
import type { Json } from "../model/json";
import { parameterValue } from "../model/parameters";
import { useCurrentSession, useEditor } from "../widgets/context";

/** The diamond beside an input: puts it on the Controls form as a parameter of the graph, or takes it off again. */
export function ExposeButton({ row, id }: { row: InputRow; id: string }): ReactElement {
  const session = useCurrentSession();
  const editor = useEditor();
  const { card } = row;
  const isExposed = row.parameterName !== undefined;
  const value = row.literal ?? card?.fallback;
  const canExpose =
    card !== undefined && !row.linked && value !== undefined && value !== null && parameterTypeFor(card) !== undefined;
  if (!card || (!isExposed && !canExpose)) return <span />;
  const toggle = (): void => {
    const { document, values } = session.store.get();
    if (row.parameterName === undefined) {
      session.edit(`Expose ${row.title}`, expose(id, card, value));
      editor.say(`${row.title} is now a parameter on the Controls tab`);
      return;
    }
    const parameter = document?.parameters.find((item) => item.name === row.parameterName);
    const present = parameter ? (parameterValue(parameter, values) as Json) : card.fallback;
    session.edit(`Take ${row.title} off the controls`, conceal(id, row.name, row.parameterName, present));
    editor.say(`${row.title} is no longer a parameter`);
  };
  return (
    <button
      type="button"
      className="expose"
      aria-pressed={isExposed}
      aria-label={`Expose ${row.title} as a parameter`}
      title={isExposed ? "Take it off the Controls tab" : "Put it on the Controls tab, as a parameter of the graph"}
      onClick={toggle}
    >
      {isExposed ? "◈" : "◇"}
    </button>
  );
}
