import { Handle, Position } from "@xyflow/react";
import { memo, type CSSProperties, type ReactElement } from "react";
import { useCurrent } from "../app/context";
import { wireType } from "../model/catalogue";

interface SocketProps {
  side: "input" | "output";
  name: string;
  type: string;
  nodeTitle: string;
  doc: string;
  onChoose(): void;
}

/** The place where wires end: its color tells the family, its shape the kind, its name both. */
export const Socket = memo(function Socket({ side, name, type, nodeTitle, doc, onChoose }: SocketProps): ReactElement {
  const look = useCurrent((state) => (state.catalogue ? wireType(state.catalogue, type) : undefined));
  const title = [`${name}: ${type || "unknown"}`, doc].filter(Boolean).join("\n");
  return (
    <Handle
      id={name}
      type={side === "input" ? "target" : "source"}
      position={side === "input" ? Position.Left : Position.Right}
      isConnectable={false}
      className="socket"
      role="button"
      tabIndex={-1}
      aria-label={`${side === "input" ? "Input" : "Output"} ${name} of ${nodeTitle}, ${type || "unknown type"}`}
      title={title}
      onClick={onChoose}
    >
      <span className="mark" data-shape={look?.shape} style={{ "--socket": look?.color } as CSSProperties} />
    </Handle>
  );
});
