import { Handle, Position } from "@xyflow/react";
import { type CSSProperties, memo, type ReactElement } from "react";
import { wireType } from "../model/catalogue";
import { socketKey } from "../session/editor";
import { useCurrent, useEditing, useEditor } from "../widgets/context";
import { inspectSocket } from "./inspection";

interface SocketProps {
  node: string;
  side: "input" | "output";
  name: string;
  /** The name as people read it. */
  title: string;
  type: string;
  nodeTitle: string;
  description: string;
  /** Its height on the node, in pixels, where no row stands beside it. */
  top?: number;
}

/** The place where wires end: its color tells the family, its shape the kind, its name both. */
export const Socket = memo(function Socket({
  node,
  side,
  name,
  title,
  type,
  nodeTitle,
  description,
  top,
}: SocketProps): ReactElement {
  const editor = useEditor();
  const look = useCurrent((state) => (state.catalogue ? wireType(state.catalogue, type) : undefined));
  const fit = useEditing(({ wiring }) => {
    if (!wiring) return undefined;
    const key = socketKey({ node, side, name });
    if (socketKey(wiring.start) === key) return "start";
    return wiring.start.side === side || wiring.refusals.has(key) ? "no" : "yes";
  });
  const open = (element: HTMLElement): void => {
    const box = element.getBoundingClientRect();
    editor.openConnect({ node, side, name }, { x: box.left + box.width / 2, y: box.bottom + 8 });
  };
  const shown = { node, side, name, title, type, description };
  return (
    <Handle
      id={name}
      type={side === "input" ? "target" : "source"}
      position={side === "input" ? Position.Left : Position.Right}
      className="socket"
      style={top === undefined ? undefined : { top }}
      role="button"
      tabIndex={-1}
      data-stop
      data-fit={fit}
      aria-label={`${side === "input" ? "Input" : "Output"} ${title} of ${nodeTitle}, ${type || "unknown type"}`}
      aria-haspopup="dialog"
      onPointerEnter={(event) => inspectSocket(editor, shown, event.currentTarget)}
      onPointerLeave={() => inspectSocket(editor, null)}
      onFocus={(event) => inspectSocket(editor, shown, event.currentTarget)}
      onBlur={() => inspectSocket(editor, null)}
      onKeyDown={(event) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        event.stopPropagation();
        inspectSocket(editor, null);
        open(event.currentTarget);
      }}
    >
      <span className="mark" data-shape={look?.shape} style={{ "--socket": look?.color } as CSSProperties} />
    </Handle>
  );
});
