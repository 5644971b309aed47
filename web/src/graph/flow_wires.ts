// The wires as React Flow holds them.

import { type CSSProperties, useMemo, useRef } from "react";
import { wireType } from "../model/catalogue";
import type { ViewWire } from "../model/graph";
import { frameKey, hiddenIn } from "../model/ui";
import { useCurrent, useEditing } from "../widgets/context";
import { FRAME_IN, FRAME_OUT } from "./areas";
import type { WireEdge } from "./WireView";

/** The wires as React Flow draws them; a wire that is as before stays the same object. */
export function useWires(): WireEdge[] {
  const wires = useCurrent((state) => state.view?.wires);
  const catalogue = useCurrent((state) => state.catalogue);
  const selection = useCurrent((state) => state.selection);
  const bypassed = useCurrent((state) => bypassedIn(state.view?.nodes ?? []));
  const chosen = useEditing((state) => state.wires);
  const frames = useCurrent((state) => state.document?.frames);
  const known = useRef(new WeakMap<object, WireEdge>());
  return useMemo(
    () =>
      shownWires(wires ?? [], hiddenIn(frames ?? [])).map(({ wire, source, target }) => {
        const near = selection.size < 20 && (selection.has(wire.from) || selection.has(wire.to));
        const selected = chosen.has(wire.id);
        const passed = bypassed.split(" ").includes(wire.to);
        const className = [near && "wire-near", passed && "wire-passed"].filter(Boolean).join(" ");
        const old = known.current.get(wire);
        const isSame = old?.selected === selected && old.className === className;
        if (old && isSame && old.source === source && old.target === target) return old;
        const edge: WireEdge = {
          id: wire.id,
          type: "wire",
          source,
          sourceHandle: source === wire.from ? wire.output : FRAME_OUT,
          target,
          targetHandle: target === wire.to ? wire.input : FRAME_IN,
          data: { wire },
          selected,
          className,
          reconnectable: target === wire.to ? "target" : false,
          ariaLabel: `${wire.type || "Wire"} from ${wire.from} to ${wire.input} of ${wire.to}`,
          style: { "--wire": catalogue ? wireType(catalogue, wire.type).color : undefined } as CSSProperties,
        };
        known.current.set(wire, edge);
        return edge;
      }),
    [wires, catalogue, selection, bypassed, chosen, frames],
  );
}

/** Where wires end that are seen: at a collapsed frame in place of the nodes in it. Those within one are not seen. */
function shownWires(
  wires: readonly ViewWire[],
  hidden: ReadonlyMap<string, string>,
): { wire: ViewWire; source: string; target: string }[] {
  const shown = wires.map((wire) => {
    const [from, to] = [hidden.get(wire.from), hidden.get(wire.to)];
    const source = from === undefined ? wire.from : frameKey(from);
    return { wire, source, target: to === undefined ? wire.to : frameKey(to) };
  });
  return hidden.size === 0 ? shown : shown.filter(({ source, target }) => source !== target);
}

/** Names of the bypassed nodes as one text, which is the same as long as they are. */
function bypassedIn(nodes: readonly { id: string; bypass: boolean }[]): string {
  return nodes.flatMap((node) => (node.bypass ? [node.id] : [])).join(" ");
}
