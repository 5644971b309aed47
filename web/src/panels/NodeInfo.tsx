import type { CSSProperties, ReactElement } from "react";
import { useCurrent } from "../app/context";
import { wireType } from "../model/catalogue";
import { millisecondText } from "../model/format";
import type { InputRow, ViewNode } from "../model/graph";
import { axesText } from "../net/report";

/** What the selected node is, takes and gives. */
export function NodeInfo(): ReactElement {
  const selected = useCurrent((state) => state.selected);
  const node = useCurrent((state) => state.view?.nodes.find((item) => item.id === selected));
  if (!node) return <p className="empty">Select a node in the graph to read what it does.</p>;
  return (
    <div className="node-info">
      <h2>
        {node.title} <span className="node-id">{node.id}</span>
      </h2>
      {node.doc && <p>{node.doc}</p>}
      {node.source && <p className="node-source">{node.source}</p>}
      <Outputs node={node} />
      <table>
        <tbody>
          {[...node.inputs, ...node.folded].map((row) => (
            <tr key={row.name}>
              <th scope="row">
                <Mark type={row.type} />
                {row.name}
              </th>
              <td>{sourceText(row)}</td>
              <td className="muted">{row.doc}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Outputs({ node }: { node: ViewNode }): ReactElement {
  const report = useCurrent((state) => state.shown?.report.nodes.get(node.id));
  return (
    <ul className="node-outputs">
      {node.outputs.map((row) => {
        const output = report?.outputs.get(row.name);
        return (
          <li key={row.name}>
            <Mark type={row.type} />
            {row.name}
            <span className="muted">{output ? axesText(output.type, output.axes) : row.type}</span>
          </li>
        );
      })}
      {report && <li className="muted">{report.cached ? "from the cache" : millisecondText(report.milliseconds)}</li>}
    </ul>
  );
}

function Mark({ type }: { type: string }): ReactElement {
  const catalogue = useCurrent((state) => state.catalogue);
  const look = catalogue ? wireType(catalogue, type) : undefined;
  return <span className="mark" data-shape={look?.shape} style={{ "--socket": look?.color } as CSSProperties} />;
}

function sourceText(row: InputRow): string {
  if (row.parameter !== undefined) return `◈ ${row.parameter}`;
  if (row.linked) return row.type ? `wire: ${row.type}` : "wire";
  return row.value || "—";
}
