import { type ReactElement, useEffect, useMemo, useState } from "react";
import { type ColorScale, colorScales } from "../model/color_scales";
import { numberText } from "../model/format";
import { isNumber } from "../model/json";
import { inspect } from "../net/validation";
import { pathOf, valuesOf } from "../session/paths";
import { useCurrent, useCurrentSession } from "../widgets/context";

/** More would cover what they are about. */
const MOST_SHOWN = 2;

/** What the colors mean that nodes of the graph give to the model. */
export function PaletteLegends(): ReactElement | null {
  const document = useCurrent((state) => state.document);
  const catalogue = useCurrent((state) => state.catalogue);
  const view = useCurrent((state) => state.view);
  const values = useCurrent(valuesOf);
  // What the model is made of around a group is not looked at in it.
  const drawn = useCurrent((state) => (state.document?.inside.length === 0 ? state.drawn : null));
  const isShown = useCurrent((state) => state.shown !== null);
  const scales = useMemo(
    () => (document && catalogue && view ? colorScales(document, catalogue, view, values, drawn) : []),
    [document, catalogue, view, values, drawn],
  );
  if (!isShown || scales.length === 0) return null;
  return (
    <div className="palette-legends">
      {scales.slice(0, MOST_SHOWN).map((scale) => (
        <PaletteLegend key={scale.node} scale={scale} />
      ))}
    </div>
  );
}

function PaletteLegend({ scale }: { scale: ColorScale }): ReactElement {
  const found = useFound(scale);
  const largest = found && Math.max(Math.abs(found[0]), Math.abs(found[1]));
  const ends = scale.ends ?? (largest === undefined ? undefined : [-largest, largest]);
  const text = (value: number): string => numberText(Number(value.toPrecision(3)));
  const unit = scale.unit && `\u202f${scale.unit}`;
  const gradient = scale.colors.map((color) => `color(srgb-linear ${color.join(" ")})`).join(", ");
  return (
    <div className="palette-legend" role="group" aria-label={`Colors of ${scale.title}`}>
      <span className="palette-title">{scale.title}</span>
      <span
        className="palette-bar"
        aria-hidden="true"
        style={{ background: `linear-gradient(to right in srgb-linear, ${gradient})` }}
      />
      {ends && (
        <span className="legend-ends">
          <span>{text(ends[0] ?? 0)}</span>
          <span>
            {text(ends[1] ?? 0)}
            {unit}
          </span>
        </span>
      )}
      {found && (
        <span className="legend-note">
          {scale.ends ? "On the model" : "Range found"}: {text(found[0])} to {text(found[1])}
          {unit}
        </span>
      )}
    </div>
  );
}

/** The least and the greatest number that the node has found, once the picture is up to date. */
function useFound({ node, found }: ColorScale): [number, number] | undefined {
  const session = useCurrentSession();
  const revision = useCurrent((state) => (state.busy ? undefined : state.shown?.revision));
  const [range, setRange] = useState<[number, number]>();
  const least = found?.[0];
  const most = found?.[1];
  useEffect(() => {
    const state = session.store.get();
    const { document, values } = state;
    if (!document || revision === undefined || least === undefined || most === undefined) return undefined;
    const request = new AbortController();
    const ask = async (output: string): Promise<number[]> => {
      const answer = await inspect(
        { graph: document.json, parameters: values },
        pathOf(state, node),
        output,
        request.signal,
      );
      return answer && "values" in answer ? answer.values.filter(isNumber) : [];
    };
    void Promise.all([ask(least), ask(most)]).then(([low, high]) => {
      if (request.signal.aborted) return;
      setRange(low.length > 0 && high.length > 0 ? [Math.min(...low), Math.max(...high)] : undefined);
    });
    return () => request.abort();
  }, [session, revision, node, least, most]);
  return range;
}
