import type { ReactFlowInstance } from "@xyflow/react";
import type { FlowNode } from "./flow_nodes";
import type { WireEdge } from "./WireView";

/** React Flow's canvas, as the graph's pane uses it. */
export type Flow = ReactFlowInstance<FlowNode, WireEdge>;
