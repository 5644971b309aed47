// Frames and notes: what is said about the graph on its canvas.

import { Handle, type Node, type NodeProps, Position } from "@xyflow/react";
import { memo, type PointerEvent, type ReactElement, useRef, useState } from "react";
import { changeFrame, changeNote } from "../model/edit_ui";
import { plural } from "../model/format";
import { type Box, FRAME_COLORS, frameKey, noteKey } from "../model/ui";
import { problemsOf } from "../net/problem";
import { toggleFrame } from "../session/actions";
import { pathOf } from "../session/paths";
import { useCurrent, useCurrentSession, useEditing, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";

export type AreaNode = Node<{ id: string }, "frame" | "note">;

/** The ends of a collapsed frame. */
export const FRAME_IN = "frame-in";
export const FRAME_OUT = "frame-out";
/** Height of a collapsed frame. */
export const FRAME_HEAD = 30;

const LEAST = { width: 96, height: 56 };

/** A titled area behind nodes. */
export const FrameView = memo(function FrameView({ data, selected }: NodeProps<AreaNode>): ReactElement | null {
  const session = useCurrentSession();
  const editor = useEditor();
  const frame = useCurrent((state) => state.document?.frames.find((item) => item.id === data.id));
  const isRenaming = useEditing((state) => state.renaming === frameKey(data.id));
  const wrong = useCurrent(
    (state) => frame?.nodes.filter((id) => problemsOf(state, pathOf(state, id))?.tone === "error").length ?? 0,
  );
  if (!frame) return null;
  const rename = (title: string): void => {
    editor.store.set({ renaming: null });
    if (title !== frame.title) session.edit("Rename frame", changeFrame(data.id, { title }));
  };
  const recolor = (): void => {
    const at = FRAME_COLORS.indexOf(frame.color as (typeof FRAME_COLORS)[number]);
    session.edit("Color frame", changeFrame(data.id, { color: FRAME_COLORS[(at + 1) % FRAME_COLORS.length] }));
  };
  return (
    <div className="frame" data-color={frame.color} data-selected={selected} data-collapsed={frame.collapsed}>
      {frame.collapsed && <FrameEnds />}
      {/* biome-ignore lint/a11y/noStaticElementInteractions: F2 does the same. */}
      <div className="frame-head" onDoubleClick={() => editor.store.set({ renaming: frameKey(data.id) })}>
        {isRenaming ? (
          <TextLine label="Title of the frame" text={frame.title} onText={rename} />
        ) : (
          <span className="frame-title" title="Double-click to rename">
            {frame.title}
          </span>
        )}
        {wrong > 0 && frame.collapsed && (
          <span className="frame-wrong" role="img" aria-label={`${plural(wrong, "node")} in it with problems`}>
            <Icon name="alert" />
          </span>
        )}
        <button
          type="button"
          className="frame-fold nodrag"
          tabIndex={-1}
          data-stop
          aria-expanded={!frame.collapsed}
          aria-label={`Nodes of ${frame.title}`}
          title={frame.collapsed ? "Expand (H)" : "Collapse (H)"}
          onClick={() => toggleFrame(editor, data.id)}
        >
          <Icon name="open" />
        </button>
        <button
          type="button"
          className="frame-color nodrag"
          tabIndex={-1}
          data-stop
          aria-label="Another color"
          title="Another color"
          onClick={recolor}
        />
      </div>
      {!frame.collapsed && (
        <Corner
          box={frame}
          onSize={(size) => session.edit("Resize frame", changeFrame(data.id, size), { gesture: `size ${data.id}` })}
        />
      )}
    </div>
  );
});

/** Where wires of its nodes end while a frame shows its head only. They are drawn from the nodes, and not here. */
function FrameEnds(): ReactElement {
  return (
    <>
      <Handle id={FRAME_IN} type="target" position={Position.Left} isConnectable={false} className="frame-end" />
      <Handle id={FRAME_OUT} type="source" position={Position.Right} isConnectable={false} className="frame-end" />
    </>
  );
}

/** Free text on the canvas. */
export const NoteView = memo(function NoteView({ data, selected }: NodeProps<AreaNode>): ReactElement | null {
  const session = useCurrentSession();
  const editor = useEditor();
  const note = useCurrent((state) => state.document?.notes.find((item) => item.id === data.id));
  const isWriting = useEditing((state) => state.renaming === noteKey(data.id));
  if (!note) return null;
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: F2 does the same.
    <div
      className="note"
      data-selected={selected}
      onDoubleClick={() => editor.store.set({ renaming: noteKey(data.id) })}
    >
      {isWriting ? (
        <textarea
          className="nodrag nokey nowheel"
          aria-label="Text of the note"
          autoFocus
          defaultValue={note.text}
          onBlur={(event) => {
            editor.store.set({ renaming: null });
            const text = event.currentTarget.value;
            if (text !== note.text) session.edit("Write note", changeNote(data.id, { text }));
          }}
          onKeyDown={(event) => {
            event.stopPropagation();
            if (event.key === "Escape" || (event.key === "Enter" && (event.ctrlKey || event.metaKey)))
              event.currentTarget.blur();
          }}
        />
      ) : (
        <p>{note.text || <span className="muted">Double-click to write</span>}</p>
      )}
      <Corner
        box={note}
        onSize={(size) => session.edit("Resize note", changeNote(data.id, size), { gesture: `size ${data.id}` })}
      />
    </div>
  );
});

function TextLine({ label, text, onText }: { label: string; text: string; onText(text: string): void }): ReactElement {
  const [typed, setTyped] = useState(text);
  return (
    <input
      className="name-field nodrag nokey"
      aria-label={label}
      autoFocus
      value={typed}
      onFocus={(event) => event.currentTarget.select()}
      onChange={(event) => setTyped(event.currentTarget.value)}
      onBlur={() => onText(typed)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") event.currentTarget.blur();
        if (event.key === "Escape") onText(text);
      }}
    />
  );
}

/** The corner that is dragged to change the size. */
function Corner({ box, onSize }: { box: Box; onSize(size: { width: number; height: number }): void }): ReactElement {
  const start = useRef({ x: 0, y: 0, width: 0, height: 0, zoom: 1 });
  const onPointerMove = (event: PointerEvent<HTMLSpanElement>): void => {
    if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
    const { x, y, width, height, zoom } = start.current;
    onSize({
      width: Math.round(Math.max(LEAST.width, width + (event.clientX - x) / zoom)),
      height: Math.round(Math.max(LEAST.height, height + (event.clientY - y) / zoom)),
    });
  };
  return (
    <span
      className="corner nodrag nokey"
      onPointerDown={(event) => {
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
        const area = event.currentTarget.parentElement?.getBoundingClientRect();
        const zoom = area ? area.width / box.width : 1;
        start.current = { x: event.clientX, y: event.clientY, width: box.width, height: box.height, zoom };
      }}
      onPointerMove={onPointerMove}
    >
      <Icon name="corner" />
    </span>
  );
}
