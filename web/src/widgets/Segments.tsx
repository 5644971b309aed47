import * as RadioGroup from "@radix-ui/react-radio-group";
import type { ReactElement } from "react";
import { Tip } from "./Tip";

interface SegmentsProps<Id extends string> {
  label: string;
  options: readonly { id: Id; title: string; hint?: string }[];
  chosen: Id;
  onChoose(id: Id): void;
}

/** A row of which one is chosen. */
export function Segments<Id extends string>({ label, options, chosen, onChoose }: SegmentsProps<Id>): ReactElement {
  return (
    <RadioGroup.Root className="segments" aria-label={label} value={chosen} onValueChange={(id) => onChoose(id as Id)}>
      {options.map(({ id, title, hint }) => {
        const button = (
          <RadioGroup.Item key={id} value={id}>
            {title}
          </RadioGroup.Item>
        );
        return hint === undefined ? (
          button
        ) : (
          <Tip key={id} text={hint}>
            {button}
          </Tip>
        );
      })}
    </RadioGroup.Root>
  );
}
