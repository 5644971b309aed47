import { Background, BackgroundVariant, MiniMap, ReactFlow, type Edge, type ReactFlowInstance } from "@xyflow/react";
import { useEffect, useMemo, useRef, useState, type CSSProperties, type ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../app/context";
import { Icon } from "../app/icons";
import { wireType } from "../model/catalogue";
import { NODE_WIDTH } from "../model/layout";
import { NodeView, type GraphNodeData } from "./NodeView";

const NODE_TYPES = { graph: NodeView };
const MINIMAP_FROM = 30;
const MINIMAP_TO = 300;
const ONLY_VISIBLE_FROM = 150;
const FIT = { padding: 0.09, maxZoom: 1.15, minZoom: 0.2 };

type Flow = ReactFlowInstance<GraphNodeData, Edge>;

/** The graph, to look at and to select in. */
export function GraphPane(): ReactElement {
  const session = useCurrentSession();
  const view = useCurrent((state) => state.view);
  const positions = useCurrent((state) => state.document?.positions);
  const catalogue = useCurrent((state) => state.catalogue);
  const opened = useCurrent((state) => state.opened);
  const selected = useCurrent((state) => state.selected);
  const [flow, setFlow] = useState<Flow | null>(null);
  const element = useRef<HTMLElement>(null);
  const wasMoved = useRef(false);

  const nodes = useMemo<GraphNodeData[]>(
    () =>
      (view?.nodes ?? []).map((node) => ({
        id: node.id,
        type: "graph" as const,
        position: positions?.get(node.id) ?? { x: 0, y: 0 },
        width: NODE_WIDTH,
        selected: node.id === selected,
        data: { node },
        ariaLabel: `${node.title}, ${node.id}`,
        domAttributes: { "aria-roledescription": "node" },
      })),
    [view, positions, selected],
  );
  const edges = useMemo<Edge[]>(
    () =>
      (view?.wires ?? []).map((wire) => ({
        id: wire.id,
        source: wire.from,
        sourceHandle: wire.output,
        target: wire.to,
        targetHandle: wire.input,
        focusable: false,
        ariaLabel: `${wire.type || "Wire"} from ${wire.from} to ${wire.input} of ${wire.to}`,
        className: selected !== null && (wire.from === selected || wire.to === selected) ? "wire-near" : undefined,
        style: { "--wire": catalogue ? wireType(catalogue, wire.type).color : undefined } as CSSProperties,
      })),
    [view, catalogue, selected],
  );

  // The graph stays in view while the pane changes its size, until a person has moved it.
  useEffect(() => {
    wasMoved.current = false;
    if (!flow || !element.current) return undefined;
    const fit = (): void => {
      if (!wasMoved.current) void flow.fitView(FIT);
    };
    const observer = new ResizeObserver(fit);
    observer.observe(element.current);
    return () => observer.disconnect();
  }, [flow]);

  const fit = (): void => {
    wasMoved.current = false;
    void flow?.fitView(FIT);
  };
  return (
    <section
      ref={element}
      className="graph-pane"
      aria-label="Graph"
      onKeyDown={(event) => {
        if (event.key.toLowerCase() === "f" || event.key === "Home") fit();
      }}
    >
      {view ? (
        <ReactFlow<GraphNodeData, Edge>
          key={opened}
          nodes={nodes}
          edges={edges}
          nodeTypes={NODE_TYPES}
          onInit={setFlow}
          onNodeClick={(_, node) => session.select([node.id])}
          onPaneClick={() => session.select([])}
          onNodesChange={(changes) => {
            for (const change of changes) if (change.type === "select" && change.selected) session.select([change.id]);
          }}
          onMoveStart={(event) => {
            if (event) wasMoved.current = true;
          }}
          fitView
          fitViewOptions={FIT}
          minZoom={0.1}
          maxZoom={2.5}
          nodesDraggable={false}
          nodesConnectable={false}
          edgesFocusable={false}
          deleteKeyCode={null}
          selectionKeyCode={null}
          onlyRenderVisibleElements={nodes.length > ONLY_VISIBLE_FROM}
        >
          <Background variant={BackgroundVariant.Dots} gap={24} size={1.4} />
          {nodes.length > MINIMAP_FROM && nodes.length <= MINIMAP_TO && (
            <MiniMap pannable zoomable ariaLabel="Map of the graph" />
          )}
        </ReactFlow>
      ) : (
        <p className="pane-wait">Loading the graph…</p>
      )}
      <div className="pane-tools">
        <button
          type="button"
          className="tool"
          title="Fit the graph into the pane (F)"
          aria-label="Fit graph"
          onClick={fit}
        >
          <Icon name="frame" />
        </button>
      </div>
    </section>
  );
}
