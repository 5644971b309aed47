import { type Node, type NodeProps, useUpdateNodeInternals } from "@xyflow/react";
import { memo, type ReactElement, useEffect, useRef, useState } from "react";
import { FILE_TYPE } from "../model/catalogue";
import { millisecondText, plural } from "../model/format";
import type { InputRow, ViewNode } from "../model/graph";
import { isPill, pillSocket } from "../model/layout";
import { problemsOf } from "../net/problem";
import { toggleFlag } from "../session/actions";
import { socketKey } from "../session/editor";
import { pathOf, timesOf } from "../session/paths";
import { useCurrent, useCurrentSession, useEditing, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { InputField } from "../widgets/InputField";
import { NameField } from "../widgets/NameField";
import { DrivenBy } from "./DrivenBy";
import { MissingInput } from "./MissingInput";
import { Socket } from "./Socket";

export type GraphNodeData = Node<{ id: string }, "graph">;

const LEAST_SHOWN_MILLISECONDS = 0.1;

/** A node: its title and time, a row per input that is given, its outputs, and what is wrong with it. */
export const NodeView = memo(function NodeView({ data, selected }: NodeProps<GraphNodeData>): ReactElement | null {
  const node = useCurrent((state) => state.view?.byId.get(data.id));
  return node ? <Face node={node} isSelected={selected} /> : null;
});

function Face({ node, isSelected }: { node: ViewNode; isSelected: boolean }): ReactElement {
  const update = useUpdateNodeInternals();
  const isUnfolded = useEditing((state) => state.unfolded.has(node.id));
  const [isOver, setIsOver] = useState(false);
  // A wire under the hand opens the node it is over, if it fits an input that is folded away.
  const isWanted = useEditing(
    ({ wiring }) =>
      isOver &&
      wiring?.start.side === "output" &&
      node.folded.some(
        (row) => row.hasSocket && !wiring.refusals.has(socketKey({ node: node.id, side: "input", name: row.name })),
      ),
  );
  const tone = useCurrent((state) => problemsOf(state, pathOf(state, node.id))?.tone);
  const text = useCurrent((state) => problemsOf(state, pathOf(state, node.id))?.text);
  const isOpen = isUnfolded || isWanted;
  // What is wrong with a node needs room to be said.
  const isShort = isPill(node) && !isOpen && !text;
  // The canvas measures what comes into sight by itself, all of it at once; asked for each it would be slow to move.
  const isMeasured = useRef(false);
  useEffect(() => {
    if (isMeasured.current) update(node.id);
    isMeasured.current = true;
  }, [isOpen, isShort, node.rows, node.collapsed, text, node.id, update]);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the canvas makes the node around it an element with a role and keys.
    // biome-ignore lint/a11y/useKeyWithClickEvents: nothing is done here, only kept from being done twice.
    <div
      className="node"
      data-tone={tone}
      data-selected={isSelected}
      data-bypass={node.bypass}
      data-known={node.known}
      data-collapsed={node.collapsed}
      data-pill={isShort}
      data-color={node.color || undefined}
      onClick={(event) => {
        // With a key held a press in a field means a number, and not one more selected node.
        const isField = event.target instanceof Element && event.target.closest(".nokey") !== null;
        if (isField && (event.shiftKey || event.ctrlKey || event.metaKey)) event.stopPropagation();
      }}
      onPointerEnter={() => setIsOver(true)}
      onPointerLeave={() => setIsOver(false)}
    >
      <Head node={node} tone={tone} isPill={isShort} />
      {node.collapsed || isShort ? (
        <Ports node={node} isPill={isShort} />
      ) : (
        <Rows node={node} isOpen={isOpen} isUnfolded={isUnfolded} />
      )}
      {text && !node.collapsed && <p className="node-message">{text}</p>}
      {text && !node.collapsed && <MissingInput node={node} />}
      {!node.known && <p className="node-message">The server does not know this node.</p>}
    </div>
  );
}

interface HeadProps {
  node: ViewNode;
  tone?: string;
  isPill: boolean;
}

const Head = memo(function Head({ node, tone, isPill: isShort }: HeadProps): ReactElement {
  const editor = useEditor();
  const isRenaming = useEditing((state) => state.renaming === node.id);
  const hasPicture = node.outputs.some((row) => row.type !== FILE_TYPE && isDrawn(row.type));
  const hint = `${node.label && `${node.label}\n`}${node.title} (${node.id})${node.description ? `\n${node.description}` : ""}\nDouble-click to rename`;
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: F2 does the same.
    <div className="node-head" onDoubleClick={() => editor.store.set({ renaming: node.id })}>
      {(tone === "error" || tone === "warning") && <Icon name="alert" />}
      {isRenaming ? (
        <NameField id={node.id} />
      ) : (
        <span className="node-title" title={hint}>
          <span>{node.label || node.title}</span>
          {(node.label !== "" || !isPlainName(node)) && <span className="node-name">{node.id}</span>}
        </span>
      )}
      {hasPicture && !isShort && (
        <button
          type="button"
          className="node-eye nodrag"
          tabIndex={-1}
          data-stop
          aria-pressed={node.preview}
          aria-label={`Preview ${node.title}`}
          title="Preview in the model (V)"
          onClick={() => toggleFlag(editor, "preview", [node.id])}
        >
          <Icon name="eye" />
        </button>
      )}
      {isShort ? (
        <button
          type="button"
          className="node-eye nodrag"
          tabIndex={-1}
          data-stop
          aria-label={`Show the inputs of ${node.title}`}
          title="Show all inputs"
          onClick={() => editor.unfold([node.id], true)}
        >
          <Icon name="open" />
        </button>
      ) : (
        <Timing id={node.id} />
      )}
    </div>
  );
});

function Rows({ node, isOpen, isUnfolded }: { node: ViewNode; isOpen: boolean; isUnfolded: boolean }): ReactElement {
  const editor = useEditor();
  return (
    <div className="node-rows">
      {(isOpen ? node.rows : node.inputs).map((row) => (
        <Input key={row.name} row={row} id={node.id} title={node.title} />
      ))}
      {(node.folded.length > 0 || isPill(node)) && (
        <button
          type="button"
          className="node-fold nodrag"
          aria-expanded={isUnfolded}
          tabIndex={-1}
          data-stop
          onClick={() => editor.unfold([node.id], !isUnfolded)}
        >
          {foldText(node, isUnfolded)}
          <Icon name="open" />
        </button>
      )}
      {node.outputs.map((row) => (
        <div className="node-row node-output" key={row.name}>
          <span className="row-name">{row.title}</span>
          <Socket
            node={node.id}
            side="output"
            name={row.name}
            title={row.title}
            type={row.type}
            nodeTitle={node.title}
            description={row.description}
          />
        </div>
      ))}
    </div>
  );
}

const Input = memo(function Input({ row, id, title }: { row: InputRow; id: string; title: string }): ReactElement {
  const session = useCurrentSession();
  const reset = (): void => session.setInput(id, row.name, undefined);
  return (
    <div className="node-row" data-default={row.isDefault}>
      {row.hasSocket && (
        <Socket
          node={id}
          side="input"
          name={row.name}
          title={row.title}
          type={row.type}
          nodeTitle={title}
          description={row.description}
        />
      )}
      {/* biome-ignore lint/a11y/noStaticElementInteractions: a short way for the pointer; the default can be typed as well. */}
      <span
        className="row-name"
        title={row.description}
        onDoubleClick={row.linked || row.isDefault ? undefined : reset}
      >
        {row.title}
      </span>
      {row.parameter !== undefined ? (
        <DrivenBy name={row.parameterName ?? ""} label={row.parameter} />
      ) : row.linked ? null : (
        <InputField node={id} title={title} row={row} look="node" />
      )}
    </div>
  );
});

function foldText(node: ViewNode, isUnfolded: boolean): string {
  if (!isUnfolded) return plural(node.folded.length, "default");
  return isPill(node) ? "Title only" : "Hide defaults";
}

/** The sockets of a collapsed node, on its head; those of a pill have places of their own. */
function Ports({ node, isPill: isShort }: { node: ViewNode; isPill: boolean }): ReactElement {
  const common = { node: node.id, nodeTitle: node.title };
  const linked = node.inputs.filter((row) => row.linked);
  return (
    <div className="node-ports">
      {linked.map((row, index) => (
        <Socket
          key={`in ${row.name}`}
          {...common}
          side="input"
          top={isShort ? pillSocket(index, linked.length) : undefined}
          name={row.name}
          title={row.title}
          type={row.type}
          description={row.description}
        />
      ))}
      {node.outputs.map((row) => (
        <Socket
          key={`out ${row.name}`}
          {...common}
          top={isShort ? pillSocket(0, 1) : undefined}
          side="output"
          name={row.name}
          title={row.title}
          type={row.type}
          description={row.description}
        />
      ))}
    </div>
  );
}

/** The node's time, or a mark that its value was already there. */
function Timing({ id }: { id: string }): ReactElement | null {
  const isShown = useEditing((state) => state.times);
  const text = useCurrent((state) => {
    const report = timesOf(state, id);
    if (!report || !isShown) return "";
    if (report.cached) return "cached";
    return report.milliseconds < LEAST_SHOWN_MILLISECONDS ? "" : millisecondText(report.milliseconds);
  });
  if (!text) return null;
  return text === "cached" ? (
    <span
      className="node-time node-cached"
      role="img"
      aria-label="from the cache"
      title="Not computed again: its value was in the cache"
    />
  ) : (
    <span className="node-time" title="Time to compute it">
      {text}
    </span>
  );
}

/** True for a name the page gave by itself; it says no more than the title. */
function isPlainName({ id, type }: ViewNode): boolean {
  return id === type || (id.startsWith(`${type}_`) && /^\d+$/.test(id.slice(type.length + 1)));
}

function isDrawn(type: string): boolean {
  return type !== "" && type !== "number";
}
