// Makes a node one of another type and keeps of its inputs and wires what fits.

import type { Catalogue } from "./catalogue";
import { accepts, WireCheck } from "./check";
import { readSources, type Source } from "./document";
import { changeNode, type Edit } from "./edit";
import { connect, disconnect } from "./edit_wires";
import { withGroupOutputs } from "./group_outputs";
import { asObject, type Json, type JsonObject } from "./json";

export function replaceNode(catalogue: Catalogue, id: string, type: string): Edit {
  return (document) => {
    const [before, card] = [document.nodes.get(id), catalogue.nodes.get(type)];
    if (!before || !card || before.type === type) return document;
    const old = catalogue.nodes.get(before.type);
    const { types } = new WireCheck(document, catalogue);
    const present = asObject(asObject(asObject(document.scope["nodes"])[id])["inputs"]);
    const inputs: JsonObject = {};
    for (const input of card.inputs) {
      const value = present[input.name];
      const oldTypes = old?.inputs.find((item) => item.name === input.name)?.types ?? [];
      const fits = (source: Source): boolean =>
        source.kind === "link" ? accepts(input, types.possible(source.node, source.output)) : accepts(input, oldTypes);
      if (value === undefined || !readSources(value).every(fits)) continue;
      // Where one wire is taken only, the first of several stays.
      const isList = !input.several && Array.isArray(value) && readSources(value).length > 1;
      inputs[input.name] = isList ? (value[0] as Json) : value;
    }
    let changed = changeNode(document, id, ({ type: _, inputs: __, ...rest }) => ({ ...rest, type, inputs }));
    // A wire that now starts or ends at what is not there is judged anew, the last of an input first.
    for (const node of document.nodes.values()) {
      for (const [input, sources] of node.inputs) {
        for (let index = sources.length - 1; index >= 0; index--) {
          const source = sources[index];
          if (source?.kind !== "link" || source.node !== id) continue;
          const wanted = source.output ?? old?.outputs[0]?.name;
          const names = card.outputs.map((output) => output.name);
          names.sort((a, b) => Number(b === wanted) - Number(a === wanted));
          const without = disconnect({ to: node.id, input, index })(changed);
          const check = new WireCheck(without, catalogue);
          const output = names.find((name) => !check.refusal({ from: id, output: name, to: node.id, input }));
          changed =
            output === undefined
              ? without
              : connect(catalogue, { from: id, output, to: node.id, input }, { replaced: index })(changed);
        }
      }
    }
    return withGroupOutputs(changed, (link) => {
      const isThere = link.output === undefined || card.outputs.some(({ name }) => name === link.output);
      return link.node !== id || isThere ? link : { node: id };
    });
  };
}
