// Steps of a parameter through its range, and the order in which they are shown.

import { type Parameter, snap, stepOf } from "./parameters";

export type PlayMode = "loop" | "swing" | "once";

export const FEWEST_STEPS = 2;
export const MOST_STEPS = 240;

/** A parameter that can be played: a number with a range, in which there are at least two values to show. */
export function isPlayable(parameter: Parameter): boolean {
  const { type, minimum, maximum } = parameter;
  if (minimum === undefined || maximum === undefined || maximum <= minimum) return false;
  return type === "number" || (type === "integer" && wholeIn(parameter) >= FEWEST_STEPS);
}

/** `count` values from one end of the range to the other, evenly; of integers no more than there are. */
export function stepValues(parameter: Parameter, count: number): number[] {
  const { type } = parameter;
  const isWhole = type === "integer";
  const [least, most] = [parameter.minimum ?? 0, parameter.maximum ?? 1];
  const [first, last] = isWhole ? [Math.ceil(least), Math.floor(most)] : [least, most];
  const used = Math.max(FEWEST_STEPS, Math.min(count, isWhole ? wholeIn(parameter) : MOST_STEPS, MOST_STEPS));
  const values = Array.from({ length: used }, (_, index) => first + ((last - first) * index) / (used - 1));
  if (isWhole) return values.map(Math.round);
  const grain = 10 ** Math.floor(Math.log10(Math.min(stepOf(parameter) / 100, (last - first) / 1e4)));
  // What is refused outside the range must not leave it by being rounded.
  return values.map((value) => Math.min(last, Math.max(first, snap(value, grain))));
}

/** How many whole numbers are in the range. */
function wholeIn({ minimum = 0, maximum = 0 }: Parameter): number {
  return Math.floor(maximum) - Math.ceil(minimum) + 1;
}

/** One round of the steps: there, or there and back without showing the ends twice. */
export function roundOf(count: number, mode: PlayMode): number[] {
  const forth = Array.from({ length: count }, (_, index) => index);
  return mode === "swing" ? [...forth, ...forth.slice(1, -1).reverse()] : forth;
}
