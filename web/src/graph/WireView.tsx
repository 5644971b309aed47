import { BaseEdge, type Edge, EdgeLabelRenderer, type EdgeProps, getBezierPath } from "@xyflow/react";
import { memo, type ReactElement, useState } from "react";
import type { ViewWire } from "../model/graph";
import { axesText } from "../net/report";
import { wireAt } from "../session/paths";
import { useCurrent, useEditing } from "../widgets/context";

export type WireEdge = Edge<{ wire: ViewWire }, "wire">;

/** Wide enough to be hit without aiming. */
const REACH = 18;

/** A wire; under the pointer, or selected, it says what it carries. */
export const WireView = memo(function WireView(props: EdgeProps<WireEdge>): ReactElement {
  const { id, data, selected, sourceX, sourceY, targetX, targetY, sourcePosition, targetPosition } = props;
  const [isOver, setIsOver] = useState(false);
  const isTarget = useEditing((state) => state.target === id);
  const [path, x, y] = getBezierPath({ sourceX, sourceY, targetX, targetY, sourcePosition, targetPosition });
  const isFamily = useCurrent((state) => (data ? (wireValue(state, data.wire)?.axes.length ?? 0) > 0 : false));
  return (
    <g
      className="wire"
      data-target={isTarget}
      data-family={isFamily}
      onPointerEnter={() => setIsOver(true)}
      onPointerLeave={() => setIsOver(false)}
    >
      <BaseEdge id={id} path={path} interactionWidth={REACH} style={props.style} />
      {(isOver || selected) && data && <WireLabel wire={data.wire} x={x} y={y} />}
    </g>
  );
});

function WireLabel({ wire, x, y }: { wire: ViewWire; x: number; y: number }): ReactElement {
  const text = useCurrent((state) => {
    const value = wireValue(state, wire);
    return value ? axesText(value.type, value.axes) : wire.type || "unknown type";
  });
  return (
    <EdgeLabelRenderer>
      <div className="wire-label" style={{ transform: `translate(-50%, -50%) translate(${x}px, ${y}px)` }}>
        {text}
      </div>
    </EdgeLabelRenderer>
  );
}

/** What the server says a wire carries: as checked, or as evaluated last. */
function wireValue(
  state: Parameters<Parameters<typeof useCurrent>[0]>[0],
  wire: ViewWire,
): { type: string; axes: { name: string; size: number; closed: boolean }[] } | undefined {
  return wireAt(state, wire.from, wire.output);
}
