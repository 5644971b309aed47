import { memo, type ReactElement, useId } from "react";
import type { InputRow } from "../model/graph";
import { asParameter, controlKind, fieldValue, listText, readList, withinHard } from "../model/inputs";
import type { Json } from "../model/json";
import { useCurrentSession } from "./context";
import { LineField } from "./LineField";
import { ValueField } from "./ValueField";

interface InputFieldProps {
  node: string;
  /** What the node is called, for the field's name. */
  title: string;
  row: InputRow;
  look: "node" | "panel";
  /** Ids of what describes the field. */
  described?: string;
}

/** The field that edits the literal at an input of a node. Nothing where only a wire can stand. */
export const InputField = memo(function InputField(props: InputFieldProps): ReactElement | null {
  const { node, title, row, look, described } = props;
  const session = useCurrentSession();
  const id = useId();
  const { card } = row;
  const kind = card && controlKind(card, row.literal);
  if (!card || kind === undefined) return null;
  // Numbers on the node would look as if they were given; where one is needed, the panel takes it.
  if (look === "node" && row.required && row.isDefault && (kind === "number" || kind === "vector")) return null;
  const set = (value: Json, moving = false): undefined => {
    session.setInput(node, row.name, value, { moving });
  };
  const label = `${row.title} of ${title}`;
  if (kind === "list") {
    return (
      <LineField
        {...{ id, label, described }}
        isStop={look === "node"}
        text={listText(row.literal)}
        placeholder={card.required ? "1; 2; 3" : ""}
        onText={(text) => {
          const value = text.trim() === "" ? undefined : readList(text);
          if (value === undefined && text.trim() !== "") return `“${text}” is no list of numbers such as 1; 2; 3.`;
          return set(value);
        }}
      />
    );
  }
  const parameter = asParameter(card, kind);
  return (
    <ValueField
      {...{ id, label, look, described, parameter }}
      partLabel={(letter) => `${row.title} ${letter} of ${title}`}
      value={fieldValue(parameter, row.literal ?? undefined)}
      placeholder={card.emptyMeans}
      within={(next) => withinHard(card, next)}
      onChange={(value, moving) => set(kind === "text" && value === "" && !card.required ? undefined : value, moving)}
    />
  );
});
