// The built-in graphs as the page lists them.

import { asObject, asString, type Json } from "../model/json";
import type { Example } from "./state";

export function readExample(json: Json): Example {
  const item = asObject(json);
  return {
    id: asString(item["id"]),
    title: asString(item["title"]) || asString(item["id"]),
    description: asString(item["description"]),
    figure: typeof item["figure"] === "number" ? String(item["figure"]) : asString(item["figure"]),
    image: asString(item["image"]),
    graph: item["graph"],
  };
}

/** The figures in their order, then those that are none. */
export function inOrderOfFigures(examples: readonly Example[]): Example[] {
  const place = ({ figure }: Example): number => parseFloat(figure) || Infinity;
  return [...examples].sort((a, b) => (place(a) === place(b) ? 0 : place(a) - place(b)));
}

/** The example shown to someone who asked for none: the twisted surface of figure 5, else the first. */
export function finest(examples: readonly Example[]): Example | undefined {
  return examples.find((item) => item.figure === "5") ?? examples[0];
}
