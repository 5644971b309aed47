import { Background, BackgroundVariant, ReactFlow, SelectionMode } from "@xyflow/react";
import { type ReactElement, useMemo, useRef, useState } from "react";
import { prefixOf } from "../model/scope";
import { useCurrent, useEditing, useEditor } from "../widgets/context";
import { FrameView, NoteView } from "./areas";
import { CanvasMap, MAP_TO } from "./CanvasMap";
import { CanvasTools } from "./CanvasTools";
import { EmptyCanvas } from "./EmptyCanvas";
import { FarTitles } from "./FarTitles";
import type { Flow } from "./flow";
import { type FlowNode, useFlowNodes } from "./flow_nodes";
import { useWires } from "./flow_wires";
import { GroupPath } from "./GroupPath";
import { useHandlers } from "./handlers";
import { useInSight } from "./in_sight";
import { NodeView } from "./NodeView";
import { Overlays } from "./Overlays";
import { LEAST_ZOOM } from "./opening";
import { useTouchpad } from "./touchpad";
import { openingFit, useCanvas } from "./use_canvas";
import { type WireEdge, WireView } from "./WireView";

const NODE_TYPES = { graph: NodeView, frame: FrameView, note: NoteView };
const EDGE_TYPES = { wire: WireView };
/** The middle and the right button move the canvas while the left one draws boxes. */
const OTHER_BUTTONS = [1, 2];

/** The graph: a canvas on which it is built. */
export function GraphPane(): ReactElement {
  const editor = useEditor();
  const isReady = useCurrent((state) => state.view !== null);
  // A group that is entered is another canvas.
  const opened = useCurrent(({ opened: count, document }) => `${count} ${prefixOf(document?.inside ?? [])}`);
  const count = useCurrent((state) => state.view?.nodes.length ?? 0);
  const leftPans = useEditing((state) => state.leftPans);
  const isWiring = useEditing((state) => state.wiring !== null);
  const element = useRef<HTMLElement>(null);
  // A graph that is opened is fitted into the pane; one that is begun stays where its first node was put.
  const isFull = useRef({ opened: "", value: false });
  if (isFull.current.opened !== opened) isFull.current = { opened, value: count > 0 };
  const opening = useMemo(() => openingFit(editor.session.store.get(), element.current), [editor, opened, isReady]);
  const [nodes, onNodesChange] = useFlowNodes();
  const edges = useWires();
  const [made, setMade] = useState<{ flow: Flow; opened: string } | null>(null);
  // Until the canvas of a graph that was just opened is there, the last one must not be asked for places.
  const flow = made?.opened === opened ? made.flow : null;
  const { noteMove, fitAll } = useCanvas(flow, element);
  const { isCut, noteRest } = useInSight(element, count);
  useTouchpad(flow, element, noteMove);
  const handlers = useHandlers(flow);
  return (
    <section
      ref={element}
      className="graph-pane"
      tabIndex={-1}
      aria-label="Graph"
      data-ready={flow !== null}
      data-wiring={isWiring}
      {...handlers.pane}
    >
      {isReady ? (
        <ReactFlow<FlowNode, WireEdge>
          key={opened}
          nodes={nodes}
          edges={edges}
          nodeTypes={NODE_TYPES}
          edgeTypes={EDGE_TYPES}
          onInit={(instance) => setMade({ flow: instance, opened })}
          onNodesChange={onNodesChange}
          {...handlers.flow}
          onMove={noteMove}
          onMoveEnd={noteRest}
          fitView={isFull.current.value}
          fitViewOptions={opening}
          minZoom={LEAST_ZOOM}
          maxZoom={2.5}
          selectionOnDrag={!leftPans}
          panOnDrag={leftPans ? true : OTHER_BUTTONS}
          selectionMode={SelectionMode.Partial}
          selectionKeyCode="Shift"
          multiSelectionKeyCode={MULTI}
          deleteKeyCode={null}
          zoomOnDoubleClick={false}
          elevateNodesOnSelect
          nodeDragThreshold={3}
          connectionRadius={24}
          reconnectRadius={6}
          edgesFocusable={false}
          disableKeyboardA11y
          onlyRenderVisibleElements={isCut}
          attributionPosition="bottom-left"
        >
          <FarTitles />
          <Background variant={BackgroundVariant.Dots} gap={24} size={1.4} />
          {count <= MAP_TO && <CanvasMap count={count} />}
        </ReactFlow>
      ) : (
        <p className="pane-wait">Loading the graph…</p>
      )}
      {isReady && count === 0 && <EmptyCanvas />}
      <GroupPath />
      <CanvasTools onFit={fitAll} />
      <Overlays editor={editor} />
    </section>
  );
}

const MULTI = ["Shift", "Meta", "Control"];
