import { type ReactElement, useEffect, useState } from "react";
import { numberText } from "../model/format";
import type { Json } from "../model/json";
import { type Parameter, type ParameterValues, parameterValue, withValue } from "../model/parameters";
import { isPlayable, stepValues } from "../model/steps";
import { problemText } from "../net/problem";
import { fetchArtifact, type SweepLine, sweep } from "../net/sweeps";
import type { Session } from "../session/session";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { Icon } from "../widgets/Icon";

const WIDTH = 240;
const HEIGHT = 150;
const COUNTS = [2, 3, 4, 5, 6, 8];
const USUAL_COUNT = 4;

/** A place of the sheet: the values there, and the picture once it has come. */
interface Cell {
  values: ParameterValues;
  image: string;
  error: string;
}

/** The button that opens the sheet; nothing where no parameter has a range. */
export function ContactSheetButton(): ReactElement | null {
  const [isOpen, setOpen] = useState(false);
  const can = useCurrent(({ document, drawn }) => drawn !== null && (document?.parameters.some(isPlayable) ?? false));
  if (!can) return null;
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
  const parameters = (useCurrent(({ document }) => document?.parameters) ?? []).filter(isPlayable);
  const [across, setAcross] = useState(parameters[0]?.name ?? "");
  const [down, setDown] = useState(parameters[1]?.name ?? "");
  const [columns, setColumns] = useState(USUAL_COUNT);
  const [rows, setRows] = useState(USUAL_COUNT - 1);
  const [cells, setCells] = useState<Cell[]>([]);
  const [error, setError] = useState("");
  const first = parameters.find(({ name }) => name === across);
  const second = parameters.find(({ name }) => name === down && name !== across);
  const xs = first ? stepValues(first, columns) : [];
  const ys = second ? stepValues(second, rows) : [undefined];
  const key = JSON.stringify([across, second?.name, xs, ys]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the key says all that matters of the parameters.
  useEffect(() => {
    const request = new AbortController();
    setError("");
    setCells([]);
    if (first) {
      fill(session, first, xs, second, ys, request.signal, setCells).then(
        (problem) => setError(problem),
        () => undefined,
      );
    }
    return () => request.abort();
  }, [session, key]);
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
      </div>
      <ul className="sheet" style={{ gridTemplateColumns: `repeat(${Math.max(1, xs.length)}, minmax(96px, 1fr))` }}>
        {cells.map((cell) => (
          <li key={JSON.stringify(cell.values)}>
            <button
              type="button"
              className="sheet-cell"
              disabled={cell.error !== ""}
              title={cell.error}
              aria-label={`Use ${textOf([first, second], cell.values)}`}
              onClick={() => {
                session.takeValues(cell.values, "Take values of the contact sheet");
                onClose();
              }}
            >
              <span className="sheet-picture">
                {cell.image && <img src={cell.image} alt="" />}
                {cell.error && <Icon name="alert" />}
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

/** Fills the sheet row by row from one batch. Answers what went wrong, or nothing. Rejects only after `signal`. */
async function fill(
  session: Session,
  first: Parameter,
  xs: readonly number[],
  second: Parameter | undefined,
  ys: readonly (number | undefined)[],
  signal: AbortSignal,
  tell: (cells: Cell[]) => void,
): Promise<string> {
  const body = session.drawnBody();
  if (body?.output === undefined) return "Nothing of this graph can be drawn.";
  const { graph, parameters, output } = body;
  let cells: Cell[] = ys.flatMap((y) =>
    xs.map((x) => {
      const values = withValue(parameters, first, x);
      return { values: second && y !== undefined ? withValue(values, second, y) : values, image: "", error: "" };
    }),
  );
  tell(cells);
  const set = (place: number, change: Partial<Cell>): void => {
    if (signal.aborted) return;
    cells = cells.map((cell, at) => (at === place ? { ...cell, ...change } : cell));
    tell(cells);
  };
  const viewer = await session.viewer;
  // Pictures are made one after the other: they share the view.
  let last: Promise<void> = Promise.resolve();
  const draw = async (place: number, line: SweepLine): Promise<void> => {
    const bytes = line.sha256 && !signal.aborted ? await fetchArtifact(line.sha256, signal) : undefined;
    if (!bytes) {
      set(place, { error: line.error || "The model did not come." });
      return;
    }
    const picture = await viewer.decode(bytes);
    const image = await viewer.thumbnail(picture, WIDTH, HEIGHT, session.store.get().document?.camera ?? null);
    picture.dispose();
    set(place, { image });
  };
  const take = (line: SweepLine): void => {
    const column = xs.indexOf(Number(line.parameters[first.name]));
    const row = second ? ys.indexOf(Number(line.parameters[second.name])) : 0;
    last = last.then(() => draw(row * xs.length + column, line));
  };
  const grid: Record<string, readonly Json[]> = { [first.name]: xs };
  if (second) grid[second.name] = ys.filter((y) => y !== undefined);
  const shared = Object.fromEntries(Object.entries(parameters).filter(([name]) => !Object.hasOwn(grid, name)));
  const answer = await sweep({ graph, parameters: shared, grid, output, quality: "draft" }, take, signal);
  await last;
  if (answer.kind === "problem") return problemText(answer.problem);
  return answer.kind === "away" ? "The server does not answer." : "";
}
