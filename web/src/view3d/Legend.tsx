import type { ReactElement } from "react";
import { numberText } from "../model/format";
import { Segments } from "../widgets/Segments";
import type { CurvatureKind } from "./curvature";
import type { CurvatureScale } from "./model_look";

const KINDS: readonly { id: CurvatureKind; title: string; unit: string }[] = [
  { id: "gauss", title: "Gaussian", unit: "m⁻²" },
  { id: "mean", title: "Mean", unit: "m⁻¹" },
];

interface LegendProps {
  scale: CurvatureScale | null;
  kind: CurvatureKind;
  onKind(kind: CurvatureKind): void;
}

/** What the colors of the curvature mean, and which curvature it is. */
export function Legend({ scale, kind, onKind }: LegendProps): ReactElement {
  const unit = KINDS.find((item) => item.id === kind)?.unit ?? "";
  const end = scale ? numberText(Number(scale.range.toPrecision(2))) : "";
  return (
    <div className="legend" role="group" aria-label="Curvature legend">
      <Segments label="Curvature kind" options={KINDS} chosen={kind} onChoose={onKind} />
      {scale ? (
        <>
          <span className="legend-bar" aria-hidden="true" />
          <span className="legend-ends">
            <span>−{end}</span>
            <span>0</span>
            <span>
              {end} {unit}
            </span>
          </span>
          <span className="legend-note">
            {scale.isEstimate ? "Estimated from the mesh. " : ""}95 of 100 points lie within.
          </span>
        </>
      ) : (
        <span className="legend-note">No surface to color.</span>
      )}
    </div>
  );
}
