import { type ReactElement, useEffect, useState } from "react";
import { numberText } from "../model/format";
import { type Parameter, type ParameterValues, parameterValue } from "../model/parameters";
import { isPlayable, stepValues } from "../model/steps";
import { type Cell, fillSheet } from "../session/contact_sheet";
import { useCurrent, useCurrentSession, useWholeParameters } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { Icon } from "../widgets/Icon";

const COUNTS = [2, 3, 4, 5, 6, 8];
const USUAL_COUNT = 4;

/** The button that opens the sheet; nothing where no parameter has a range. */
export function ContactSheetButton(): ReactElement | null {
  const [isOpen, setOpen] = useState(false);
  const isDrawn = useCurrent(({ drawn }) => drawn !== null);
  const parameters = useWholeParameters();
  if (!isDrawn || !parameters.some(isPlayable)) return null;
  return (
    <>
      <button
        type="button"
        className="button quiet"
        title="Pictures of the model for all values of two parameters"
        onClick={() => setOpen(true)}
      >
        <Icon name="grid" />
        <span>Contact sheet</span>
      </button>
      {isOpen && <ContactSheet onClose={() => setOpen(false)} />}
    </>
  );
}

/** The model for a grid of values of two parameters; a press on a picture takes its values. */
function ContactSheet({ onClose }: { onClose(): void }): ReactElement {
  const session = useCurrentSession();
  const parameters = useWholeParameters().filter(isPlayable);
  const [across, setAcross] = useState(parameters[0]?.name ?? "");
  const [down, setDown] = useState(parameters[1]?.name ?? "");
  const [columns, setColumns] = useState(USUAL_COUNT);
  const [rows, setRows] = useState(USUAL_COUNT - 1);
  const [cells, setCells] = useState<readonly Cell[]>([]);
  const [error, setError] = useState("");
  const [attempt, setAttempt] = useState(0);
  const first = parameters.find(({ name }) => name === across);
  const second = parameters.find(({ name }) => name === down && name !== across);
  const xs = first ? stepValues(first, columns) : [];
  const ys = second ? stepValues(second, rows) : [];
  const key = JSON.stringify([across, second?.name, xs, ys]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the key says all that matters of the parameters.
  useEffect(() => {
    const request = new AbortController();
    setError("");
    setCells([]);
    if (first) {
      void fillSheet(session, { first, xs, second, ys }, request.signal, setCells).then((problem) => {
        if (!request.signal.aborted) setError(problem);
      });
    }
    return () => request.abort();
  }, [session, key, attempt]);
  const done = cells.filter(({ image, error: failed }) => image || failed).length;
  return (
    <Dialog title="Contact sheet" className="sheet-dialog" onClose={onClose}>
      <div className="sheet-head">
        <Axis
          label="Across"
          {...{ parameters, chosen: across, count: columns }}
          onChoose={setAcross}
          onCount={setColumns}
        />
        <Axis
          label="Down"
          optional
          {...{ parameters, chosen: second?.name ?? "", count: rows }}
          onChoose={setDown}
          onCount={setRows}
        />
        <span className="muted" role="status">
          {error || `${done} of ${cells.length} pictures`}
        </span>
        {error && (
          <button type="button" className="button" onClick={() => setAttempt(attempt + 1)}>
            Try again
          </button>
        )}
      </div>
      <ul className="sheet" style={{ gridTemplateColumns: `repeat(${Math.max(1, xs.length)}, minmax(96px, 1fr))` }}>
        {cells.map((cell) => (
          <li key={JSON.stringify(cell.values)}>
            <button
              type="button"
              className="sheet-cell"
              // It can be reached all the same, or nobody could read why it is empty.
              aria-disabled={cell.error !== ""}
              aria-label={`Use ${textOf([first, second], cell.values)}${cell.error && `: ${cell.error}`}`}
              onClick={() => {
                if (cell.error) return;
                session.takeValues(cell.values, "Take values of the contact sheet");
                onClose();
              }}
            >
              <span className="sheet-picture">
                {cell.image && <img src={cell.image} alt="" />}
                {cell.error && <Icon name="alert" />}
                {cell.error && <span className="sheet-error">{cell.error}</span>}
              </span>
              <span className="sheet-text">{textOf([first, second], cell.values)}</span>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}

interface AxisProps {
  label: string;
  parameters: readonly Parameter[];
  chosen: string;
  count: number;
  optional?: boolean;
  onChoose(name: string): void;
  onCount(count: number): void;
}

function Axis({ label, parameters, chosen, count, optional, onChoose, onCount }: AxisProps): ReactElement {
  return (
    <span className="sheet-axis">
      <span>{label}</span>
      <select
        className="select"
        aria-label={label}
        value={chosen}
        onChange={(event) => onChoose(event.currentTarget.value)}
      >
        {optional && <option value="">nothing</option>}
        {parameters.map(({ name, label: title }) => (
          <option key={name} value={name}>
            {title}
          </option>
        ))}
      </select>
      <select
        className="select"
        aria-label={`Values ${label.toLowerCase()}`}
        value={count}
        onChange={(event) => onCount(Number(event.currentTarget.value))}
      >
        {COUNTS.map((one) => (
          <option key={one} value={one}>
            {one} values
          </option>
        ))}
      </select>
    </span>
  );
}

function textOf(parameters: readonly (Parameter | undefined)[], values: ParameterValues): string {
  return parameters
    .flatMap((parameter) =>
      parameter ? [`${parameter.label} ${numberText(Number(parameterValue(parameter, values)))}`] : [],
    )
    .join(", ");
}
