// Steps of a parameter through its range, and the order in which they are shown.

import { type Parameter, snap, stepOf } from "./parameters";

export type PlayMode = "loop" | "swing" | "once";

export const FEWEST_STEPS = 2;
export const MOST_STEPS = 240;

/** A parameter that can be played: a number with a range. */
export function isPlayable({ type, minimum, maximum }: Parameter): boolean {
  return (
    (type === "number" || type === "integer") && minimum !== undefined && maximum !== undefined && maximum > minimum
  );
}

/** `count` values from one end of the range to the other, evenly; of integers no more than there are. */
export function stepValues(parameter: Parameter, count: number): number[] {
  const { minimum = 0, maximum = 1, type } = parameter;
  const isWhole = type === "integer";
  const most = isWhole ? Math.floor(maximum) - Math.ceil(minimum) + 1 : MOST_STEPS;
  const used = Math.max(FEWEST_STEPS, Math.min(count, most, MOST_STEPS));
  const step = Math.min(stepOf(parameter) / 100, (maximum - minimum) / 1e4);
  const values = Array.from({ length: used }, (_, index) => minimum + ((maximum - minimum) * index) / (used - 1));
  return isWhole ? values.map(Math.round) : values.map((value) => snap(value, 10 ** Math.floor(Math.log10(step))));
}

/** One round of the steps: there, or there and back without showing the ends twice. */
export function roundOf(count: number, mode: PlayMode): number[] {
  const forth = Array.from({ length: count }, (_, index) => index);
  return mode === "swing" ? [...forth, ...forth.slice(1, -1).reverse()] : forth;
}
