import type { PartReport } from "../net/report";

/** What a printer would say first. */
export function verdict(meshes: readonly PartReport[]): string {
  if (meshes.length === 0) return "There is nothing to print: only curves or points.";
  const open = meshes.filter(({ isWatertight }) => !isWatertight).length;
  const crossing = meshes.filter(({ contacts }) => contacts > 0).length;
  const isOne = meshes.length === 1;
  if (open === 0 && crossing === 0) {
    return isOne ? "It is closed and meets itself nowhere." : "All parts are closed and meet themselves nowhere.";
  }
  const some = (count: number, one: string, many: string): string =>
    isOne ? `It ${one}.` : `${count} of ${meshes.length} parts ${count === 1 ? one : many}.`;
  const said: string[] = [];
  if (open > 0) said.push(some(open, "is open", "are open"), "What is open cannot be printed.");
  if (crossing > 0) said.push(some(crossing, "meets itself", "meet themselves"));
  return said.join(" ");
}
