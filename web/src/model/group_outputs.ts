// The outputs of the group that is looked at, as wires that leave it: they follow the nodes that they begin at.

import { type GraphDocument, readLink, rewrittenWhole } from "./document";
import { type Link, linkText } from "./edit_links";
import { asArray, asObject, asString } from "./json";

/** The document with what the outputs come from replaced; outputs whose link becomes undefined go. */
export function withGroupOutputs(document: GraphDocument, change: (link: Link) => Link | undefined): GraphDocument {
  const name = document.inside.at(-1)?.group;
  if (name === undefined) return document;
  const groups = asObject(document.json["groups"]);
  const group = asObject(groups[name]);
  const before = asArray(group["outputs"]);
  const after = before.flatMap((output) => {
    const link = readLink(asString(asObject(output)["from"]));
    const next = change(link);
    if (next === link) return [output];
    return next ? [{ ...asObject(output), from: linkText(next) }] : [];
  });
  if (after.length === before.length && after.every((output, at) => output === before[at])) return document;
  return rewrittenWhole(document, { groups: { ...groups, [name]: { ...group, outputs: after } } });
}
