// Pictures of the model for a grid of values of two parameters, from one batch of the server.

import type { Json } from "../model/json";
import { type Parameter, type ParameterValues, withValue } from "../model/parameters";
import { problemText } from "../net/problem";
import { type SweepLine, sweep } from "../net/sweeps";
import { modelOf } from "./batch";
import type { Session } from "./session";

const WIDTH = 240;
const HEIGHT = 150;

/** What stands across, and down where there are two. */
export interface SheetAxes {
  first: Parameter;
  xs: readonly number[];
  second?: Parameter;
  ys: readonly number[];
}

/** A place of the sheet: the values there, and the picture once it has come. */
export interface Cell {
  values: ParameterValues;
  image: string;
  error: string;
}

/**
 * Fills the sheet row by row; `tell` is given all of it whenever some of it has come. Answers what went wrong, or nothing.
 * After `signal` nothing is told any more, and the pictures are let go. Never rejects.
 */
export async function fillSheet(
  session: Session,
  { first, xs, second, ys }: SheetAxes,
  signal: AbortSignal,
  tell: (cells: readonly Cell[]) => void,
): Promise<string> {
  const body = session.drawnBody();
  if (body?.output === undefined) return "Nothing of this graph can be drawn.";
  const { graph, parameters, output } = body;
  const rows: readonly (number | undefined)[] = second ? ys : [undefined];
  let cells: readonly Cell[] = rows.flatMap((y) =>
    xs.map((x) => {
      const values = withValue(parameters, first, x);
      return { values: second && y !== undefined ? withValue(values, second, y) : values, image: "", error: "" };
    }),
  );
  tell(cells);
  signal.addEventListener("abort", () => {
    for (const { image } of cells) URL.revokeObjectURL(image);
  });
  const set = (place: number, change: Partial<Cell>): void => {
    cells = cells.map((cell, at) => (at === place ? { ...cell, ...change } : cell));
    tell(cells);
  };
  const draw = async (place: number, line: SweepLine): Promise<void> => {
    const found = await modelOf(line, { ...body, parameters: cells[place]?.values ?? {} }, signal);
    if ("error" in found) {
      if (!signal.aborted) set(place, found);
      return;
    }
    const viewer = await session.viewer;
    const picture = await viewer.decode(found.bytes);
    const camera = session.store.get().document?.camera ?? null;
    const image = await viewer.thumbnail(picture, WIDTH, HEIGHT, camera).finally(() => picture.dispose());
    if (signal.aborted) URL.revokeObjectURL(image);
    else set(place, { image });
  };
  // Pictures are made one after the other: they share the view.
  let last: Promise<void> = Promise.resolve();
  const take = (line: SweepLine): void => {
    const column = xs.indexOf(Number(line.parameters[first.name]));
    const row = second ? ys.indexOf(Number(line.parameters[second.name])) : 0;
    const place = row * xs.length + column;
    if (column < 0 || row < 0) return;
    last = last.then(async () => {
      if (signal.aborted) return;
      try {
        await draw(place, line);
      } catch {
        // One that cannot be drawn must not keep the others from it.
        if (!signal.aborted) set(place, { error: "It cannot be drawn." });
      }
    });
  };
  const grid: Record<string, readonly Json[]> = { [first.name]: xs };
  if (second) grid[second.name] = ys;
  const shared = Object.fromEntries(Object.entries(parameters).filter(([name]) => !Object.hasOwn(grid, name)));
  try {
    const answer = await sweep({ graph, parameters: shared, grid, output, quality: "draft" }, take, signal);
    await last;
    if (answer.kind === "problem") return problemText(answer.problem);
    return answer.kind === "away" ? "The server does not answer." : "";
  } catch {
    // It was given up.
    return "";
  }
}
