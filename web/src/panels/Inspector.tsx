import { Fragment, memo, type ReactElement, useId } from "react";
import { millisecondText, plural } from "../model/format";
import type { InputRow, OutputRow, ViewNode } from "../model/graph";
import { problemsOf } from "../net/problem";
import { axesText } from "../net/report";
import { toggleBypass, toggleFlag } from "../session/actions";
import { pathOf, timesOf, wireAt } from "../session/paths";
import { useCurrent, useCurrentSession, useEditing, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { InputField } from "../widgets/InputField";
import { Mark } from "../widgets/Mark";
import { NameField } from "../widgets/NameField";
import { ExposeButton } from "./ExposeButton";

/** The selected node: every input to edit, what it does, what it gives. */
export function Inspector(): ReactElement {
  const selected = useCurrent((state) => state.selected);
  const count = useCurrent((state) => state.selection.size);
  const node = useCurrent((state) => (selected === null ? undefined : state.view?.byId.get(selected)));
  if (!node) return <p className="empty">Select a node to change its inputs and to read what it does.</p>;
  return (
    <div className="inspector" key={node.id}>
      <Head node={node} />
      {count > 1 && <p className="muted">{plural(count, "node")} are selected; this is the last one.</p>}
      <Message id={node.id} />
      <div className="inspector-rows" role="group" aria-label={`Inputs of ${node.title}`}>
        {node.rows.map((row) => (
          <Row key={row.name} row={row} id={node.id} title={node.title} />
        ))}
        {node.rows.length === 0 && <p className="muted">This node has no inputs.</p>}
      </div>
      <Outputs node={node} />
      <div className="inspector-text">
        {node.description && <p>{node.description}</p>}
        {node.details && <p>{node.details}</p>}
        {node.source && <p className="node-source">{node.source}</p>}
      </div>
    </div>
  );
}

function Head({ node }: { node: ViewNode }): ReactElement {
  const editor = useEditor();
  const isRenaming = useEditing((state) => state.renaming === `panel ${node.id}`);
  return (
    <header className="inspector-head">
      <Mark type={node.outputs[0]?.type} />
      <h2>{node.title}</h2>
      {isRenaming ? (
        <NameField id={node.id} />
      ) : (
        <button
          type="button"
          className="inspector-name"
          title="Rename"
          aria-label={`Rename ${node.id}`}
          onClick={() => editor.store.set({ renaming: `panel ${node.id}` })}
        >
          {node.label && <span>{node.label} · </span>}
          {node.id}
          <Icon name="pencil" />
        </button>
      )}
      <span className="spacer" />
      <button
        type="button"
        className="chip"
        aria-pressed={node.preview}
        title="Preview in the model (V)"
        onClick={() => toggleFlag(editor, "preview", [node.id])}
      >
        Preview
      </button>
      <button
        type="button"
        className="chip"
        aria-pressed={node.bypass}
        title="Let the first input pass through (M)"
        onClick={() => toggleBypass(editor)}
      >
        Bypass
      </button>
    </header>
  );
}

function Message({ id }: { id: string }): ReactElement | null {
  const text = useCurrent((state) => problemsOf(state, pathOf(state, id))?.text);
  const tone = useCurrent((state) => problemsOf(state, pathOf(state, id))?.tone);
  return text ? (
    <p className="inspector-message" data-tone={tone}>
      <Icon name="alert" />
      <span>{text}</span>
    </p>
  ) : null;
}

const Row = memo(function Row({ row, id, title }: { row: InputRow; id: string; title: string }): ReactElement {
  const session = useCurrentSession();
  const about = useId();
  const canReset = !row.isDefault && !row.linked && row.parameter === undefined;
  const reset = (): void => session.setInput(id, row.name, undefined);
  return (
    <div className="parameter" data-default={row.isDefault}>
      {/* biome-ignore lint/a11y/noStaticElementInteractions: a short way for the pointer; the default can be typed as well. */}
      <span
        className="parameter-label"
        title={`${row.description}${canReset ? "\nDouble-click for the default" : ""}`}
        onDoubleClick={canReset ? reset : undefined}
      >
        <Mark type={row.type} /> {row.title}
        {row.required && row.isDefault && <span className="needed">needed</span>}
      </span>
      <Source row={row} id={id} title={title} about={about} />
      <ExposeButton row={row} id={id} />
      <span hidden id={about}>
        {row.description}
      </span>
    </div>
  );
});

/** What stands at an input: the parameter, the wires, or the field. */
function Source({
  row,
  id,
  title,
  about,
}: {
  row: InputRow;
  id: string;
  title: string;
  about: string;
}): ReactElement | null {
  const session = useCurrentSession();
  const wires = useCurrent((state) => state.view?.wires);
  if (row.parameter !== undefined) {
    return (
      <span className="inspector-source" title={`Driven by the parameter “${row.parameter}”, on the Controls tab`}>
        <span aria-hidden="true">◈</span> {row.parameter}
      </span>
    );
  }
  if (row.linked) {
    return (
      <span className="inspector-source">
        {(wires ?? [])
          .filter((wire) => wire.to === id && wire.input === row.name)
          .map((wire) => (
            <Fragment key={wire.id}>
              <button
                type="button"
                className="chip"
                title="Go to the node this wire comes from"
                onClick={() => session.select([wire.from])}
              >
                {wire.from}
                {wire.output !== row.name && <span className="muted"> {wire.output}</span>}
              </button>
            </Fragment>
          ))}
      </span>
    );
  }
  if (!row.card) return <span className="muted">{row.value}</span>;
  return (
    <span className="inspector-field">
      <InputField node={id} title={title} row={row} look="panel" described={about} />
    </span>
  );
}

function Outputs({ node }: { node: ViewNode }): ReactElement {
  const time = useCurrent((state) => {
    const report = timesOf(state, node.id);
    return report && (report.cached ? "from the cache" : millisecondText(report.milliseconds));
  });
  return (
    <ul className="node-outputs" aria-label={`Outputs of ${node.title}`}>
      {node.outputs.map((row) => {
        return (
          <li key={row.name} title={row.description}>
            <Mark type={row.type} />
            {row.title}
            <Carried node={node.id} row={row} />
          </li>
        );
      })}
      {time !== undefined && <li className="muted">{time}</li>}
    </ul>
  );
}

/** The type of what an output carries, and its axes once the server has told them. */
function Carried({ node, row: { name, type } }: { node: string; row: OutputRow }): ReactElement {
  const text = useCurrent((state) => {
    const value = wireAt(state, node, name);
    return value ? axesText(value.type, value.axes) : type;
  });
  return <span className="muted">{text}</span>;
}
