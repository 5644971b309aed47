import type { ReactElement } from "react";
import type { InputCard } from "../model/catalogue";
import { lengthText } from "../model/format";

/** The unit of inputs that say how finely something is written. */
export const BITS = "bit";
const BITS_ENDING = /_bits$/;

/** By how much values may be off that are written with so many bits, as a report has told it. */
export interface Measured {
  bits: number;
  error: number;
}

interface PrecisionFieldProps {
  id: string;
  input: InputCard;
  value: number;
  /** Nothing where the model has no such values, or no report has come yet. */
  measured?: Measured;
  onChange(bits: number): void;
}

/** What a report calls the error of values that an input gives bits to: "position" for position_bits. */
export function errorName({ name }: InputCard): string {
  return name.replace(BITS_ENDING, "");
}

/** A choice among precisions: how far off a value may be, in its own unit, and not how many bits that takes. */
export function PrecisionField({ id, input, value, measured, onChange }: PrecisionFieldProps): ReactElement {
  const { minimum = value, maximum = value } = input;
  const choices = Array.from({ length: maximum - minimum + 1 }, (_, index) => minimum + index);
  return (
    <select
      id={id}
      className="select"
      value={value}
      title={input.description}
      onChange={(event) => onChange(Number(event.currentTarget.value))}
    >
      {choices.map((bits) => (
        <option key={bits} value={bits}>
          {precisionText(errorName(input), bits, measured)}
          {bits === input.fallback ? ", the usual" : ""}
        </option>
      ))}
    </select>
  );
}

/** "within 0.12 mm"; each bit more halves it. */
export function precisionText(name: string, bits: number, measured?: Measured): string {
  if (!measured || !(measured.error > 0)) return `${bits} bits`;
  const error = measured.error * 2 ** (measured.bits - bits);
  if (name === "position") return `within ${lengthText(error)}`;
  if (name === "normal") return `within ${Number(((error * 180) / Math.PI).toPrecision(2))}°`;
  return `within ${Number((100 * error).toPrecision(2))} %`;
}
