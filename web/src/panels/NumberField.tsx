import type { ReactElement } from "react";
import { unitText } from "../model/catalogue";
import { clamp, decimalsOf, snap, stepOf } from "../model/parameters";
import { NumberInput } from "./NumberInput";
import type { FieldProps } from "./ParameterRow";
import { SliderBar } from "./SliderBar";

/** A number: a bar to drag where it has a range, and a field to type or drag. */
export function NumberField({
  id,
  parameter,
  value,
  invalid,
  describedBy,
  onChange,
  onUnreadable,
}: FieldProps): ReactElement {
  const number = typeof value === "number" ? value : 0;
  const step = stepOf(parameter);
  const least = parameter.type === "integer" ? 1 : step / 10;
  const { minimum, maximum } = parameter;
  const hasRange = minimum !== undefined && maximum !== undefined && maximum > minimum;
  /** Drags and arrows stay inside the bounds. */
  const move = (next: number, scale: number): void =>
    onChange(clamp(parameter, snap(next, Math.max(least, step * scale))), true);
  return (
    <div className="number-field" data-range={hasRange}>
      {hasRange && (
        <SliderBar
          label={parameter.label}
          value={number}
          minimum={minimum}
          maximum={maximum}
          step={step}
          text={`${number}${unitText(parameter.unit)}`}
          describedBy={describedBy}
          onMove={move}
        />
      )}
      <NumberInput
        id={id}
        label={`${parameter.label} value`}
        value={number}
        decimals={Math.min(6, decimalsOf(step) + 2)}
        unit={unitText(parameter.unit)}
        step={step}
        invalid={invalid}
        described={describedBy}
        onType={(next) => onChange(next, true)}
        onMove={move}
        onUnreadable={onUnreadable}
      />
    </div>
  );
}
