// The one set of fields: values of a graph's parameters, and of nodes' inputs on the node and in the panel.

import type { ReactElement } from "react";
import { unitText } from "../model/catalogue";
import {
  colorText,
  colorValue,
  decimalsOf,
  type Parameter,
  type ParameterValue,
  snap,
  stepOf,
} from "../model/parameters";
import { LineField } from "./LineField";
import { NumberInput } from "./NumberInput";
import { SliderBar } from "./SliderBar";

export interface ValueFieldProps {
  /** Of the element that a label belongs to. */
  id: string;
  /** What the value is: type, range of the slider, step, unit, choices. */
  parameter: Parameter;
  value: ParameterValue;
  /** What the field is called, for those who hear the page. */
  label: string;
  /** What one of several numbers is called. */
  partLabel(letter: string): string;
  /** Small on a node, where Tab reaches it from within only; a row of the panel; or the form with its sliders. */
  look: "node" | "panel" | "form";
  placeholder?: string;
  invalid?: boolean;
  /** Ids of what describes it. */
  described?: string;
  /** Where a dragged or stepped number has to stay. */
  within?(value: number): number;
  /** `moving` where more of the kind will follow at once. */
  onChange(value: ParameterValue, moving: boolean): void;
  /** Whether a text that is no value stands in the field; it is not passed on. */
  onUnreadable?(isUnreadable: boolean): void;
}

/** The field for a value of any type. */
export function ValueField(props: ValueFieldProps): ReactElement {
  switch (props.parameter.type) {
    case "number":
    case "integer":
      return <NumberField {...props} />;
    case "vector":
      return <VectorField {...props} />;
    case "boolean":
      return <SwitchField {...props} />;
    case "choice":
      return <ChoiceField {...props} />;
    case "color":
      return <ColorField {...props} />;
    default:
      return <TextField {...props} />;
  }
}

/** A number: with a bar to drag beside it on the form, or behind it elsewhere, where it has a range. */
function NumberField(props: ValueFieldProps): ReactElement {
  const { id, parameter, value, label, look, described, within = (next) => next, onChange } = props;
  const number = typeof value === "number" ? value : 0;
  const { minimum, maximum } = parameter;
  const range = minimum !== undefined && maximum !== undefined && maximum > minimum ? { minimum, maximum } : undefined;
  const step = stepOf(parameter);
  const least = parameter.type === "integer" ? 1 : step / 10;
  const move = (next: number, scale: number): void => onChange(within(snap(next, Math.max(least, step * scale))), true);
  const input = (
    <NumberInput
      {...common(props)}
      id={id}
      label={look === "form" ? `${label} value` : label}
      value={number}
      unit={unitText(parameter.unit)}
      range={look === "form" ? undefined : range}
      onType={(next) => onChange(next, true)}
      onMove={move}
    />
  );
  if (look !== "form") return input;
  return (
    <div className="number-field" data-range={range !== undefined}>
      {range && (
        <SliderBar
          {...range}
          label={label}
          value={number}
          step={step}
          text={`${number}${unitText(parameter.unit)}`}
          described={described}
          onMove={move}
        />
      )}
      {input}
    </div>
  );
}

function VectorField(props: ValueFieldProps): ReactElement {
  const { id, parameter, value, label, partLabel, look, onChange } = props;
  const parts = Array.isArray(value) ? value : [0, 0, 0];
  const step = stepOf(parameter);
  const set = (index: number, next: number): void =>
    onChange(
      parts.map((part, at) => (at === index ? next : part)),
      true,
    );
  return (
    <span className="triple" role="group" aria-label={label}>
      {["x", "y", "z"].map((letter, index) => (
        <NumberInput
          {...common(props)}
          key={letter}
          id={index === 0 ? id : `${id}-${letter}`}
          label={partLabel(letter)}
          value={parts[index] ?? 0}
          // There is no room for the letter on a node.
          unit={look === "node" ? "" : letter}
          onType={(next) => set(index, next)}
          onMove={(next, scale) => set(index, snap(next, Math.max(step / 10, step * scale)))}
        />
      ))}
    </span>
  );
}

function SwitchField(props: ValueFieldProps): ReactElement {
  return (
    <input
      {...attributes(props)}
      type="checkbox"
      className="checkbox nodrag nokey"
      checked={props.value === true}
      onChange={(event) => props.onChange(event.currentTarget.checked, false)}
    />
  );
}

function ChoiceField(props: ValueFieldProps): ReactElement {
  return (
    <select
      {...attributes(props)}
      className="select nodrag nokey"
      value={String(props.value)}
      onChange={(event) => props.onChange(event.currentTarget.value, false)}
    >
      {props.parameter.choices.map((choice) => (
        <option key={choice} value={choice}>
          {choice.replaceAll("_", " ")}
        </option>
      ))}
    </select>
  );
}

function ColorField(props: ValueFieldProps): ReactElement {
  const text = colorText(props.value);
  const field = (
    <input
      {...attributes(props)}
      type="color"
      className="color-field nodrag nokey"
      value={text}
      onChange={(event) => props.onChange(colorValue(event.currentTarget.value, props.value), true)}
    />
  );
  if (props.look !== "form") return field;
  return (
    <span className="color-place">
      {field}
      <span className="color-text">{text}</span>
    </span>
  );
}

function TextField(props: ValueFieldProps): ReactElement {
  const { id, label, value, placeholder, look, invalid, described, onChange } = props;
  return (
    <LineField
      {...{ id, label, placeholder, invalid, described }}
      isStop={look === "node"}
      text={String(value)}
      onText={(text) => {
        onChange(text, false);
        return undefined;
      }}
    />
  );
}

/** What number fields of a value have in common. */
function common({ parameter, look, invalid = false, described, onUnreadable }: ValueFieldProps) {
  const step = stepOf(parameter);
  const decimals = look === "node" ? 3 : Math.min(6, decimalsOf(step) + 2);
  return { step, decimals, invalid, described, onUnreadable, isStop: look === "node" };
}

/** The attributes of a field that is one element. */
function attributes({ id, label, look, invalid, described }: ValueFieldProps) {
  return {
    id,
    "aria-label": label,
    "aria-invalid": invalid || undefined,
    "aria-describedby": described,
    tabIndex: look === "node" ? -1 : undefined,
    "data-stop": look === "node" || undefined,
  };
}
