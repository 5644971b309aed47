// What a group shows of itself: its outputs, and what it is called.

import type { Catalogue } from "./catalogue";
import { rewrittenWhole } from "./document";
import type { Edit } from "./edit";
import { linkText } from "./edit_links";
import { asArray, asObject, asString, isObject } from "./json";

/** Makes the outputs of nodes outputs of the group that is looked at; where all of them are, they are taken away. */
export function toggleOutputs(catalogue: Catalogue, ids: ReadonlySet<string>): Edit {
  return (document) => {
    const name = document.inside.at(-1)?.group;
    if (name === undefined) return document;
    const groups = asObject(document.json["groups"]);
    const group = asObject(groups[name]);
    const outputs = asArray(group["outputs"]).map(asObject);
    const wanted = [...ids].flatMap((node) =>
      (catalogue.nodes.get(document.nodes.get(node)?.type ?? "")?.outputs ?? []).map((output) => ({
        node,
        output: output.name,
      })),
    );
    const isShown = ({ node, output }: { node: string; output: string }): boolean =>
      outputs.some(({ from }) => from === node || from === linkText({ node, output }));
    let next = outputs;
    if (wanted.every(isShown)) {
      next = outputs.filter(({ from }) => !ids.has(asString(from).split(".")[0] ?? ""));
    } else {
      for (const place of wanted) {
        if (isShown(place)) continue;
        const free = (number: number): string => (number === 1 ? place.output : `${place.output}_${number}`);
        let number = 1;
        while (next.some((output) => output["name"] === free(number))) number++;
        next = [...next, { name: free(number), from: linkText(place) }];
      }
    }
    return rewrittenWhole(document, { groups: { ...groups, [name]: { ...group, outputs: next } } });
  };
}

/** What a group is called where people read it. */
export function renameGroup(name: string, label: string): Edit {
  return (document) => {
    const groups = asObject(document.json["groups"]);
    if (!isObject(groups[name])) return document;
    return rewrittenWhole(document, { groups: { ...groups, [name]: { ...groups[name], label } } });
  };
}
