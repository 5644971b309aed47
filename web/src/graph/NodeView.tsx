import { useUpdateNodeInternals, type Node, type NodeProps } from "@xyflow/react";
import { memo, useEffect, useState, type ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../app/context";
import { Icon } from "../app/icons";
import { millisecondText, plural } from "../model/format";
import type { InputRow, ViewNode } from "../model/graph";
import { nodeErrors } from "../net/problem";
import { Socket } from "./Socket";

export type GraphNodeData = Node<{ node: ViewNode }, "graph">;

const LEAST_SHOWN_MILLISECONDS = 0.05;

/** A node: its title and time, a row per input that is given, its outputs, and what is wrong with it. */
export const NodeView = memo(function NodeView({ data, selected }: NodeProps<GraphNodeData>): ReactElement {
  const session = useCurrentSession();
  const update = useUpdateNodeInternals();
  const [unfolded, setUnfolded] = useState(false);
  const { node } = data;
  const error = useCurrent((state) => nodeErrors(state.problem?.errors ?? [], node.id)[0]?.detail);
  const warning = useCurrent((state) => nodeErrors(state.shown?.report.warnings ?? [], node.id)[0]?.detail);
  const blocked = useCurrent((state) => state.problem?.blocked.includes(node.id) ?? false);
  const tone = error ? "error" : warning ? "warning" : blocked ? "blocked" : undefined;
  useEffect(() => update(node.id), [unfolded, node.id, update]);
  const choose = (): void => session.select([node.id]);
  return (
    <div className="node" data-tone={tone} data-selected={selected} data-bypass={node.bypass} data-known={node.known}>
      <div className="node-head">
        {(error || warning) && <Icon name="alert" />}
        <span className="node-title" title={`${node.title} (${node.id})${node.doc ? `\n${node.doc}` : ""}`}>
          {node.title}
        </span>
        <Timing id={node.id} />
      </div>
      <div className="node-rows">
        {node.inputs.map((row) => (
          <Input key={row.name} row={row} node={node} onChoose={choose} />
        ))}
        {unfolded && node.folded.map((row) => <Input key={row.name} row={row} node={node} onChoose={choose} />)}
        {node.folded.length > 0 && (
          <button
            type="button"
            className="node-fold nodrag"
            aria-expanded={unfolded}
            tabIndex={-1}
            onClick={() => setUnfolded(!unfolded)}
          >
            {unfolded ? "Hide defaults" : plural(node.folded.length, "default")}
            <Icon name="chevron" />
          </button>
        )}
        {node.outputs.map((row) => (
          <div className="node-row node-output" key={row.name}>
            <span className="row-name">{row.name}</span>
            <Socket
              side="output"
              name={row.name}
              type={row.type}
              nodeTitle={node.title}
              doc={row.doc}
              onChoose={choose}
            />
          </div>
        ))}
      </div>
      {(error || warning) && <p className="node-message">{error ?? warning}</p>}
      {!node.known && <p className="node-message">The server does not know this node.</p>}
    </div>
  );
});

function Input({ row, node, onChoose }: { row: InputRow; node: ViewNode; onChoose(): void }): ReactElement {
  return (
    <div className="node-row" data-default={row.isDefault}>
      <Socket side="input" name={row.name} type={row.type} nodeTitle={node.title} doc={row.doc} onChoose={onChoose} />
      <span className="row-name">{row.name}</span>
      {row.parameter !== undefined ? (
        <span className="row-parameter" title={`Driven by the parameter “${row.parameter}”`}>
          <span aria-hidden="true">◈</span> {row.parameter}
        </span>
      ) : (
        row.value &&
        !row.linked && (
          <span className="row-value" title={row.value}>
            {row.value}
          </span>
        )
      )}
    </div>
  );
}

/** The node's time, or a mark that its value was already there. */
function Timing({ id }: { id: string }): ReactElement | null {
  const text = useCurrent((state) => {
    const report = state.shown?.report.nodes.get(id);
    if (!report) return "";
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
    <span className="node-time">{text}</span>
  );
}
