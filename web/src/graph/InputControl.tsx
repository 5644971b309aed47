import { memo, useId, type ReactElement } from "react";
import { useCurrentSession } from "../app/context";
import { unitText } from "../model/catalogue";
import type { InputRow } from "../model/graph";
import { asParameter, controlKind, fieldValue, listText, readList, withinHard } from "../model/inputs";
import type { Json } from "../model/json";
import { colorText, colorValue, decimalsOf, snap, stepOf, type Parameter } from "../model/parameters";
import { LineField } from "../panels/LineField";
import { NumberInput } from "../panels/NumberInput";

interface InputControlProps {
  node: string;
  /** What the node is called, for the control's name. */
  title: string;
  row: InputRow;
  /** Small, on the node, and reached only from within it. */
  onNode: boolean;
  /** Ids of what describes the control. */
  describedBy?: string;
  invalid?: boolean;
}

/** The field that edits the literal at an input. Nothing where only a wire can stand. */
export const InputControl = memo(function InputControl(props: InputControlProps): ReactElement | null {
  const { node, title, row, onNode, describedBy, invalid = false } = props;
  const session = useCurrentSession();
  const id = useId();
  const { card } = row;
  const kind = card && controlKind(card, row.literal);
  if (!card || kind === undefined) return null;
  // Numbers on the node would look as if they were given; where one is needed, the panel takes it.
  if (onNode && row.required && row.isDefault && (kind === "number" || kind === "vector")) return null;
  const set = (value: Json, moving = false): void => {
    session.setInput(node, row.name, value, { moving });
  };
  const common = {
    id,
    "aria-label": `${row.name} of ${title}`,
    "aria-invalid": invalid || undefined,
    "aria-describedby": describedBy,
    tabIndex: onNode ? -1 : undefined,
    "data-stop": onNode || undefined,
  };
  const line = { id, label: common["aria-label"], invalid, described: describedBy, isStop: onNode };
  if (kind === "list") {
    return (
      <LineField
        {...line}
        text={listText(row.literal)}
        placeholder={card.required ? "1, 2, 3" : ""}
        onText={(text) => {
          const value = text.trim() === "" ? undefined : readList(text);
          if (value === undefined && text.trim() !== "") return `“${text}” is no list of numbers such as 1; 2; 3.`;
          return set(value);
        }}
      />
    );
  }
  const parameter = asParameter(card, kind);
  const value = fieldValue(parameter, row.literal ?? undefined);
  switch (kind) {
    case "number":
    case "integer":
      return (
        <NumberControl
          {...{ id, parameter, onNode, describedBy }}
          label={common["aria-label"]}
          value={typeof value === "number" ? value : 0}
          invalid={invalid}
          onValue={(next, moving) => set(moving ? withinHard(card, next) : next, true)}
        />
      );
    case "vector": {
      const parts = Array.isArray(value) ? value : [0, 0, 0];
      return (
        <span className="triple" role="group" aria-label={common["aria-label"]}>
          {["x", "y", "z"].map((letter, index) => (
            <NumberControl
              key={letter}
              {...{ parameter, onNode, describedBy }}
              id={`${id}-${letter}`}
              label={`${row.name} ${letter} of ${title}`}
              unit={onNode ? "" : letter}
              value={parts[index] ?? 0}
              invalid={invalid}
              onValue={(next) =>
                set(
                  parts.map((part, at) => (at === index ? next : part)),
                  true,
                )
              }
            />
          ))}
        </span>
      );
    }
    case "boolean":
      return (
        <input
          {...common}
          type="checkbox"
          className="checkbox nodrag nokey"
          checked={value === true}
          onChange={(event) => set(event.currentTarget.checked)}
        />
      );
    case "choice":
      return (
        <select
          {...common}
          className="select nodrag nokey"
          value={String(value)}
          onChange={(event) => set(event.currentTarget.value)}
        >
          {card.choices.map((choice) => (
            <option key={choice} value={choice}>
              {choice.replaceAll("_", " ")}
            </option>
          ))}
        </select>
      );
    case "color":
      return (
        <input
          {...common}
          type="color"
          className="color-field nodrag nokey"
          value={colorText(value)}
          onChange={(event) => set(colorValue(event.currentTarget.value, value) as Json, true)}
        />
      );
    default:
      return (
        <LineField
          {...line}
          text={typeof row.literal === "string" ? row.literal : ""}
          placeholder={placeholderOf(row)}
          onText={(text) => set(text === "" && !card.required ? undefined : text)}
        />
      );
  }
});

interface NumberControlProps {
  id: string;
  label: string;
  parameter: Parameter;
  value: number;
  unit?: string;
  onNode: boolean;
  invalid: boolean;
  describedBy?: string;
  onValue(value: number, moving: boolean): void;
}

function NumberControl(props: NumberControlProps): ReactElement {
  const { parameter, onNode, onValue } = props;
  const step = stepOf(parameter);
  const { minimum, maximum } = parameter;
  const hasRange = minimum !== undefined && maximum !== undefined && maximum > minimum && parameter.type !== "vector";
  const least = parameter.type === "integer" ? 1 : step / 10;
  return (
    <NumberInput
      {...props}
      described={props.describedBy}
      unit={props.unit ?? unitText(parameter.unit)}
      decimals={onNode ? 3 : Math.min(6, decimalsOf(step) + 2)}
      step={step}
      range={hasRange ? { minimum, maximum } : undefined}
      isStop={onNode}
      onType={(next) => onValue(next, false)}
      onMove={(next, scale) => onValue(snap(next, Math.max(least, step * scale)), true)}
    />
  );
}

/** What an empty text means, where the catalogue says so: "Name of the axis; empty means the id of this node." */
function placeholderOf(row: InputRow): string {
  return /;\s*empty means ([^.;]+)/.exec(row.doc)?.[1] ?? "";
}
