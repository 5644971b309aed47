import { MiniMap, type ReactFlowState, useStore } from "@xyflow/react";
import type { ReactElement } from "react";
import { useCurrent } from "../widgets/context";
import type { FlowNode } from "./flow_nodes";

/** The map costs more than it helps above this number of nodes. */
export const MAP_TO = 300;
const MAP_FROM = 40;
/** A lower pane needs its room for the graph itself, in pixels. */
const LEAST_HEIGHT = 400;

/** A map of a large graph, while a part of it is out of sight. */
export function CanvasMap({ count }: { count: number }): ReactElement | null {
  const isCut = useStore(hasHidden);
  const wrong = useCurrent((state) => (state.problem?.errors ?? []).map((entry) => entry.node).join(" "));
  if (count <= MAP_FROM || !isCut) return null;
  const colorOf = (node: FlowNode): string => {
    if (node.type !== "graph") return "transparent";
    if (wrong.split(" ").includes(node.id)) return "var(--error)";
    return node.selected ? "var(--accent)" : "var(--line2)";
  };
  return <MiniMap<FlowNode> pannable zoomable ariaLabel="Map of the graph" nodeColor={colorOf} nodeStrokeWidth={0} />;
}

/** Whether the middle of a node lies outside a pane that has room for a map. */
function hasHidden({ nodes, transform: [left, top, zoom], width, height }: ReactFlowState): boolean {
  if (height < LEAST_HEIGHT) return false;
  return nodes.some(({ position, measured, width: wanted }) => {
    const x = left + zoom * (position.x + (measured?.width ?? wanted ?? 0) / 2);
    const y = top + zoom * (position.y + (measured?.height ?? 0) / 2);
    return x < 0 || y < 0 || x > width || y > height;
  });
}
