// Finding node types: by what is typed, by what a dangling wire needs, and by values typed in place of a name.

import type { Catalogue, NodeCard } from "./catalogue";
import { accepts } from "./check";
import { evaluateExpression } from "./expression";
import { numberText } from "./format";
import type { Json, JsonObject } from "./json";
import { splitNumbers } from "./numbers";

/** The loose end of a wire that a new node is to take: an output that feeds it, or an input that it feeds. */
export interface LooseEnd {
  side: "output" | "input";
  types: readonly string[];
}

/** A parameter that comes with a new node and drives one of its inputs. */
export interface Slider {
  input: string;
  item: JsonObject;
}

export interface Finding {
  card: NodeCard;
  /** What is shown instead of the card's title. */
  title?: string;
  /** The socket that takes the loose end. */
  socket?: string;
  /** Values given with the node. */
  inputs?: JsonObject;
  slider?: Slider;
  /** The other word by which it was found. */
  word?: string;
}

/** How likely a loose wire ends at this socket of a node type: 0 and more. */
export interface Likelihood {
  likelihood(card: string, socket: string, end: LooseEnd): number;
}

/** Node types that fit, the best first. Without a text, all that take the loose end, the likeliest first. */
export function findNodes(catalogue: Catalogue, text: string, end?: LooseEnd, habits?: Likelihood): Finding[] {
  const query = text.trim().toLowerCase();
  const typed = end ? [] : typedValues(catalogue, query);
  const found: { finding: Finding; score: number }[] = [];
  for (const card of catalogue.nodes.values()) {
    const socket = end && socketFor(card, end);
    if (end && !socket) continue;
    const family = catalogue.families.get(card.family) ?? card.family;
    const match = query === "" ? { score: 1 } : matchOf(card, family, query.replaceAll("_", " "));
    const habit = end && socket ? (habits?.likelihood(card.id, socket.name, end) ?? 0) : 0;
    const finding: Finding = { card, socket: socket?.name, word: match.word };
    if (match.score > 0) found.push({ finding, score: match.score + (socket?.score ?? 0) + habit });
  }
  if (query !== "" || end) found.sort((a, b) => b.score - a.score);
  return [...typed, ...found.map(({ finding }) => finding)];
}

interface Match {
  /** 0 where nothing fits. */
  score: number;
  word?: string;
}

/**
 * How well a name, another word, a family or a description matches. A whole other word is as good as the beginning of
 * a name: who types "ring" wants a circle, and not what has "ring" somewhere in its title.
 */
export function matchOf(card: NodeCard, family: string, query: string): Match {
  const [title, id] = [card.title.toLowerCase(), card.id.replaceAll("_", " ").toLowerCase()];
  const names = Math.max(textScore(title, query), 0.98 * textScore(id, query));
  const other = wordOf(card.synonyms, query);
  if (names >= 0.98 || names > other.score) return { score: names >= 0.98 ? 10 + names : 7 + names };
  if (other.score > 0) return other;
  if (family.toLowerCase().startsWith(query)) return { score: 6 };
  const texts = [title, id, family.toLowerCase(), card.description.toLowerCase(), ...card.synonyms];
  const words = query.split(/\s+/);
  if (words.length > 1 && words.every((word) => texts.some((one) => one.includes(word)))) return { score: 5 };
  if (query.length > 2 && card.description.toLowerCase().includes(query)) return { score: 4 };
  const scattered = Math.max(subsequenceScore(title, query), subsequenceScore(id, query));
  return { score: scattered > 0 ? 1 + scattered : 0 };
}

/** The other word that matches best: whole ones before beginnings, the first of the list before the last. */
function wordOf(words: readonly string[], query: string): Match {
  let best: Match = { score: 0 };
  words.forEach((word, index) => {
    const fit = textScore(word, query);
    const score = fit >= 3.5 ? 12 - 0.05 * index : fit >= 1 && query.length > 1 ? 8 + fit / 4 - 0.01 * index : 0;
    if (score > best.score) best = { score, word };
  });
  return best;
}

/** The first socket of the card that the loose end fits, the more particular the better. */
export function socketFor(card: NodeCard, end: LooseEnd): { name: string; score: number } | undefined {
  let best: { name: string; score: number } | undefined;
  const consider = (name: string, score: number): void => {
    if (!best || score > best.score) best = { name, score };
  };
  if (end.side === "output") {
    card.inputs.forEach((input, index) => {
      if (!accepts(input, end.types)) return;
      const isMain = input.required ? 2 : 0;
      consider(input.name, isMain + 1 / input.types.length - 0.05 * index);
    });
  } else {
    card.outputs.forEach((output, index) => {
      if (output.types.some((type) => end.types.includes(type)))
        consider(output.name, 2 / output.types.length - 0.05 * index);
    });
  }
  return best;
}

/** A number, a range "low<value<high" or coordinates, typed in place of a name. */
function typedValues(catalogue: Catalogue, text: string): Finding[] {
  const parts = text.split("<");
  if (parts.length === 3) {
    const [low, value, high] = parts.map((part) => evaluateExpression(part));
    if (low === undefined || value === undefined || high === undefined || low >= high) return [];
    const [min, max] = [Math.min(low, value), Math.max(high, value)];
    return constants(catalogue, "number").map(({ card, input }) => ({
      card,
      title: `${card.title} ${numberText(value)}, slider ${numberText(low)} to ${numberText(high)}`,
      slider: { input, item: { type: "number", default: value, min, max } },
    }));
  }
  const coordinates = splitNumbers(text).map((part) => evaluateExpression(part));
  if (coordinates.length === 3 && coordinates.every((part) => part !== undefined))
    return triples(catalogue, coordinates);
  const value = /\d|^(pi|tau)\b/.test(text) ? evaluateExpression(text) : undefined;
  if (value === undefined) return [];
  return constants(catalogue, "number").map(({ card, input }) => ({
    card,
    title: `${card.title} ${numberText(value)}`,
    inputs: { [input]: value },
  }));
}

/** Nodes that only hold a value: one input and one output, both of this one type. */
function constants(catalogue: Catalogue, type: string): { card: NodeCard; input: string }[] {
  return [...catalogue.nodes.values()].flatMap((card) => {
    const [input, output] = [card.inputs[0], card.outputs[0]];
    const isOne = card.inputs.length === 1 && card.outputs.length === 1;
    const isType = (types: readonly string[] = []): boolean => types.length === 1 && types[0] === type;
    return isOne && input && isType(input.types) && isType(output?.types) ? [{ card, input: input.name }] : [];
  });
}

/** Nodes that hold a point or a vector: in one input, or in three numbers. */
function triples(catalogue: Catalogue, coordinates: readonly (number | undefined)[]): Finding[] {
  const shown = `(${coordinates.map((part) => numberText(part ?? 0)).join(", ")})`;
  const value = coordinates.map((part) => part ?? 0) as Json[];
  const found: Finding[] = [];
  for (const type of ["point", "vector"]) {
    for (const { card, input } of constants(catalogue, type)) {
      found.push({ card, title: `${card.title} ${shown}`, inputs: { [input]: value } });
    }
  }
  for (const card of catalogue.nodes.values()) {
    const isNumbers = card.inputs.length === 3 && card.inputs.every((input) => input.types.join() === "number");
    const isTriple = card.outputs.length === 1 && ["point", "vector"].includes(card.outputs[0]?.types.join() ?? "");
    if (!isNumbers || !isTriple) continue;
    const inputs = Object.fromEntries(card.inputs.map((input, index) => [input.name, value[index]])) as JsonObject;
    found.push({ card, title: `${card.title} ${shown}`, inputs });
  }
  return found;
}

/** 3 for the whole, 2 for its beginning, 1 for the beginning of a later word, 0.5 for a part. */
function textScore(text: string, query: string): number {
  const brevity = query.length / (text.length + 1) / 2;
  if (text === query) return 3.5;
  if (text.startsWith(query)) return 2 + brevity;
  if (text.includes(` ${query}`)) return 1 + brevity;
  return text.includes(query) ? 0.5 + brevity : 0;
}

/** Between 0 and 1: the letters of the query in order, the closer together the better. */
export function subsequenceScore(text: string, query: string): number {
  let at = -1;
  let gaps = 0;
  for (const letter of query.replaceAll(" ", "")) {
    const next = text.indexOf(letter, at + 1);
    if (next < 0) return 0;
    if (at >= 0) gaps += next - at - 1;
    at = next;
  }
  return 1 / (1 + gaps);
}

/** True if every word of the query is part of the text. */
export function matchText(text: string, query: string): boolean {
  const lower = text.toLowerCase();
  return query
    .toLowerCase()
    .split(/\s+/)
    .every((word) => lower.includes(word));
}
