// The fields of parameters that are not single numbers.

import type { ReactElement } from "react";
import { colorText, colorValue, decimalsOf, snap, stepOf } from "../model/parameters";
import { NumberInput } from "./NumberInput";
import type { FieldProps } from "./ParameterRow";

export function SwitchField({ id, parameter, value, invalid, describedBy, onChange }: FieldProps): ReactElement {
  return (
    <span className="field">
      <input
        id={id}
        type="checkbox"
        className="checkbox"
        aria-label={parameter.label}
        aria-invalid={invalid}
        aria-describedby={describedBy}
        checked={value === true}
        onChange={(event) => onChange(event.currentTarget.checked, false)}
      />
    </span>
  );
}

export function ChoiceField({ id, parameter, value, invalid, describedBy, onChange }: FieldProps): ReactElement {
  return (
    <span className="field">
      <select
        id={id}
        className="select"
        aria-invalid={invalid}
        aria-describedby={describedBy}
        value={String(value)}
        onChange={(event) => onChange(event.currentTarget.value, false)}
      >
        {parameter.choices.map((choice) => (
          <option key={choice} value={choice}>
            {choice.replaceAll("_", " ")}
          </option>
        ))}
      </select>
    </span>
  );
}

export function VectorField({
  id,
  parameter,
  value,
  invalid,
  describedBy,
  onChange,
  onUnreadable,
}: FieldProps): ReactElement {
  const parts = Array.isArray(value) ? value : [0, 0, 0];
  const step = stepOf(parameter);
  const set = (index: number, next: number): void =>
    onChange(
      parts.map((part, at) => (at === index ? next : part)),
      true,
    );
  return (
    <span className="vector-field" role="group" aria-label={parameter.label}>
      {["x", "y", "z"].map((letter, index) => (
        <NumberInput
          key={letter}
          id={index === 0 ? id : `${id}-${letter}`}
          label={`${parameter.label} ${letter}`}
          value={parts[index] ?? 0}
          decimals={Math.min(6, decimalsOf(step) + 2)}
          unit={letter}
          step={step}
          invalid={invalid}
          described={describedBy}
          onType={(next) => set(index, next)}
          onMove={(next, scale) => set(index, snap(next, step * scale))}
          onUnreadable={onUnreadable}
        />
      ))}
    </span>
  );
}

export function ColorField({ id, value, invalid, describedBy, onChange }: FieldProps): ReactElement {
  const text = colorText(value);
  return (
    <span className="field">
      <input
        id={id}
        type="color"
        className="color-field"
        aria-invalid={invalid}
        aria-describedby={describedBy}
        value={text}
        onChange={(event) => onChange(colorValue(event.currentTarget.value, value), true)}
      />
      <span className="color-text">{text}</span>
    </span>
  );
}

export function TextField({ id, value, invalid, describedBy, onChange }: FieldProps): ReactElement {
  return (
    <span className="field">
      <input
        id={id}
        type="text"
        className="text-field"
        aria-invalid={invalid}
        aria-describedby={describedBy}
        value={String(value)}
        onChange={(event) => onChange(event.currentTarget.value, true)}
      />
    </span>
  );
}
