// Variants: sets of the form's values with a name, kept in the document below `ui.variants`, where they influence nothing
// that is computed.

import { type GraphDocument, lookedAt } from "./document";
import { type Edit, withNotes } from "./edit";
import { asArray, asObject, asString, isObject, type Json } from "./json";
import type { ParameterValues } from "./parameters";
import { documentWithValues, valuesIn } from "./saved_values";

export interface Variant {
  name: string;
  /** Those that differ from the defaults, and that the document still has. */
  values: ParameterValues;
}

/** The variants of the whole document, whatever of it is looked at. */
export function variantsOf(document: GraphDocument): Variant[] {
  const { parameters } = lookedAt(document, []);
  return itemsOf(document).map((item) => ({
    name: asString(asObject(item)["name"]),
    values: valuesIn(item, parameters),
  }));
}

/** The document as it would be saved with the values of a variant. */
export function variantDocument(document: GraphDocument, { values }: Variant): Json {
  return documentWithValues(document, values);
}

export function addVariant(values: ParameterValues): Edit {
  return (document) => {
    const items = itemsOf(document);
    const taken = new Set(items.map((item) => asString(asObject(item)["name"])));
    let number = items.length + 1;
    while (taken.has(`Variant ${number}`)) number++;
    return withNotes(document, { variants: [...items, { name: `Variant ${number}`, values: { ...values } }] });
  };
}

export function renameVariant(place: number, name: string): Edit {
  return (document) => {
    const items = itemsOf(document);
    const item = items[place];
    if (!item || asString(asObject(item)["name"]) === name || name === "") return document;
    return withNotes(document, { variants: items.map((one, at) => (at === place ? { ...asObject(one), name } : one)) });
  };
}

export function removeVariant(place: number): Edit {
  return (document) => {
    const left = itemsOf(document).filter((_, at) => at !== place);
    return withNotes(document, { variants: left.length > 0 ? left : undefined });
  };
}

function itemsOf({ json }: GraphDocument): Json[] {
  return asArray(asObject(json["ui"])["variants"]).filter(isObject);
}
