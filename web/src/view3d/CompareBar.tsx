import type { ReactElement } from "react";
import { lengthText } from "../model/format";
import { type ComparedHow, comparisonOf } from "../session/comparison";
import { IconButton } from "../widgets/Button";
import { useCurrentSession } from "../widgets/context";
import { useStore } from "../widgets/hooks";
import { Segments } from "../widgets/Segments";
import { DEVIATION_COLORS } from "./deviation_colors";

const HOWS: readonly { id: ComparedHow; title: string; hint: string }[] = [
  { id: "beside", title: "Side by side", hint: "Both, from the same place" },
  { id: "over", title: "Distance", hint: "The present model, colored by how far it is from the other one" },
];

/** What is compared with what, and how; `deviation` is the largest distance, where that is shown. */
export function CompareBar({ deviation }: { deviation: number | undefined }): ReactElement | null {
  const comparison = comparisonOf(useCurrentSession());
  const { name, how, isLoading, error } = useStore(comparison.store, (state) => state);
  if (name === null) return null;
  // Lines and points have no surface to be far from.
  const isBare = how === "over" && deviation === undefined;
  const stateText = isLoading
    ? `Making ${name}…`
    : isBare
      ? "There are no surfaces to compare"
      : `Compared with ${name}`;
  const gradient = DEVIATION_COLORS.map((color) => `color(srgb-linear ${color.join(" ")})`).join(", ");
  return (
    <>
      {how === "beside" && (
        <div className="compare-names" aria-hidden="true">
          <span>Present values</span>
          <span>{name}</span>
        </div>
      )}
      <section className="compare-bar" aria-label="Comparison">
        <span role="status">{error || stateText}</span>
        <Segments label="Compare" options={HOWS} chosen={how} onChoose={(next) => comparison.set(next)} />
        {how === "over" && deviation !== undefined && (
          <span className="compare-scale">
            <span>0</span>
            <span
              className="palette-bar"
              aria-hidden="true"
              style={{ background: `linear-gradient(to right in srgb-linear, ${gradient})` }}
            />
            <span>{lengthText(deviation)}</span>
          </span>
        )}
        <IconButton label="End the comparison" icon="close" onClick={() => comparison.close()} />
      </section>
    </>
  );
}
