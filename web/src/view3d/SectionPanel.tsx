import type { ReactElement } from "react";
import { numberText } from "../model/format";
import { NumberInput } from "../panels/NumberInput";
import type { Section, SectionAxis } from "./section";
import { ToolIcon } from "./ToolIcon";

interface SectionPanelProps {
  section: Section;
  reach: { minimum: number; maximum: number };
  onChange(section: Section): void;
}

const LETTERS: readonly SectionAxis[] = ["x", "y", "z"];

/** The section's axis, place and side; the same plane can be dragged in the view. */
export function SectionPanel({ section, reach, onChange }: SectionPanelProps): ReactElement {
  const { minimum, maximum } = reach;
  const step = Number(((maximum - minimum) / 200).toPrecision(1));
  const set = (offset: number): void => onChange({ ...section, offset });
  return (
    <div className="section-panel" role="group" aria-label="Section">
      <div className="segments" role="radiogroup" aria-label="Section axis">
        {LETTERS.map((axis) => (
          <button
            key={axis}
            type="button"
            role="radio"
            aria-checked={section.axis === axis}
            onClick={() => onChange({ ...section, axis })}
          >
            {axis.toUpperCase()}
          </button>
        ))}
      </div>
      <input
        type="range"
        aria-label="Section offset"
        aria-valuetext={`${numberText(section.offset, 3)} m`}
        min={minimum}
        max={maximum}
        step={step}
        value={section.offset}
        onChange={(event) => set(Number(event.currentTarget.value))}
      />
      <NumberInput
        id="section-offset"
        label="Section offset value"
        value={section.offset}
        decimals={4}
        unit="m"
        step={step}
        invalid={false}
        onType={set}
        onMove={(value) => set(value)}
      />
      <button
        type="button"
        className="button icon-button"
        aria-pressed={section.flipped}
        aria-label="Keep the other side"
        title="Keep the other side"
        onClick={() => onChange({ ...section, flipped: !section.flipped })}
      >
        <ToolIcon name="flip" />
      </button>
    </div>
  );
}
