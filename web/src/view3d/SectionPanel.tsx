import type { ReactElement } from "react";
import { numberText } from "../model/format";
import { snap } from "../model/parameters";
import { IconButton } from "../widgets/Button";
import { NumberInput } from "../widgets/NumberInput";
import { Segments } from "../widgets/Segments";
import { SliderBar } from "../widgets/SliderBar";
import type { Section, SectionAxis } from "./section";

interface SectionPanelProps {
  section: Section;
  reach: { minimum: number; maximum: number };
  onChange(section: Section): void;
}

const AXES: readonly { id: SectionAxis; title: string }[] = [
  { id: "x", title: "X" },
  { id: "y", title: "Y" },
  { id: "z", title: "Z" },
];

/** The section's axis, place and side; the same plane can be dragged in the view. */
export function SectionPanel({ section, reach, onChange }: SectionPanelProps): ReactElement {
  const { minimum, maximum } = reach;
  const step = Number(((maximum - minimum) / 200).toPrecision(1));
  const clamp = (value: number): number => Math.min(maximum, Math.max(minimum, value));
  const set = (offset: number): void => onChange({ ...section, offset });
  return (
    <div className="section-panel" role="group" aria-label="Section">
      <Segments
        label="Section axis"
        options={AXES}
        chosen={section.axis}
        onChoose={(axis) => onChange({ ...section, axis })}
      />
      <SliderBar
        label="Section offset"
        text={`${numberText(section.offset, 3)} m`}
        minimum={minimum}
        maximum={maximum}
        step={step}
        value={section.offset}
        onMove={(value, scale) => set(clamp(snap(value, step * Math.min(1, scale))))}
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
      <IconButton
        label="Keep the other side"
        icon="flip"
        pressed={section.flipped}
        onClick={() => onChange({ ...section, flipped: !section.flipped })}
      />
    </div>
  );
}
