// Groups of the form: a heading over parameters that belong together, kept below `ui.parameters`, where it influences
// nothing that is computed.

import type { GraphDocument } from "./document";
import { type Edit, inOrder, withUi } from "./edit";
import { moveParameter } from "./edit_parameters";
import { asObject, asString, type JsonObject } from "./json";
import type { Parameter } from "./parameters";

/** Rows of the form that stand below one heading; no heading where it is empty. */
export interface ParameterGroup {
  title: string;
  parameters: Parameter[];
}

/** The group of a parameter; empty where it has none. */
export function groupOf(document: GraphDocument, name: string): string {
  return asString(asObject(itemsOf(document)[name])["group"]);
}

/** The parameters in their order; a heading stands wherever the group is another one than before. */
export function groupedParameters(document: GraphDocument): ParameterGroup[] {
  const groups: ParameterGroup[] = [];
  for (const parameter of document.parameters) {
    const title = groupOf(document, parameter.name);
    const last = groups.at(-1);
    if (last && last.title === title) last.parameters.push(parameter);
    else groups.push({ title, parameters: [parameter] });
  }
  return groups;
}

/** Puts a parameter into a group, behind what is there; an empty title takes it out of its own, in front of that. */
export function setGroup(name: string, title: string): Edit {
  return (document) => {
    const own = groupOf(document, name);
    if (own === title) return document;
    if (title === "") return inOrder(writeGroup(name, ""), moveParameter(name, frontOf(document, name, own)))(document);
    const others = document.parameters.filter((parameter) => parameter.name !== name);
    const isIn = others.map((parameter) => groupOf(document, parameter.name) === title);
    const last = isIn.lastIndexOf(true);
    return last < 0
      ? writeGroup(name, title)(document)
      : inOrder(writeGroup(name, title), moveParameter(name, last + 1))(document);
  };
}

/** Puts a parameter at a place among the others, counted without it; it joins the group that it is put into. */
export function moveIntoPlace(name: string, place: number): Edit {
  return (document) => {
    const others = document.parameters.filter((parameter) => parameter.name !== name);
    const titleAt = (at: number): string | undefined => {
      const neighbor = others[at];
      return neighbor && groupOf(document, neighbor.name);
    };
    const [above, below, own] = [titleAt(place - 1), titleAt(place), groupOf(document, name)];
    const stays = above === own || below === own;
    const title = stays ? own : (above ?? below ?? own);
    return inOrder(moveParameter(name, place), writeGroup(name, title))(document);
  };
}

/** The place of the first of the parameters in a row that are in one group with this one, if one is behind it as well. */
function frontOf(document: GraphDocument, name: string, group: string): number {
  const { parameters } = document;
  const isIn = parameters.map((parameter) => groupOf(document, parameter.name) === group);
  const at = parameters.findIndex((parameter) => parameter.name === name);
  // At the end of its row it parts nothing.
  if (!isIn[at + 1]) return at;
  return isIn.lastIndexOf(false, at) + 1;
}

function writeGroup(name: string, title: string): Edit {
  return (document) => {
    if (groupOf(document, name) === title) return document;
    const { [name]: item, ...others } = itemsOf(document);
    const { group: _, ...rest } = asObject(item);
    const next: JsonObject = title === "" ? rest : { ...rest, group: title };
    const parameters: JsonObject = Object.keys(next).length > 0 ? { ...others, [name]: next } : others;
    return withUi(document, { parameters: Object.keys(parameters).length > 0 ? parameters : undefined });
  };
}

function itemsOf(document: GraphDocument): JsonObject {
  return asObject(asObject(document.scope["ui"])["parameters"]);
}
