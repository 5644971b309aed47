import type { ReactElement } from "react";
import { millisecondText, plural } from "../model/format";
import { useProblemCount } from "../panels/Problems";
import { useCurrent } from "../widgets/context";
import { OVERDUE_MILLISECONDS, useLasting } from "../widgets/hooks";

/** The line at the bottom: whether the picture is up to date, how large the graph is, what the server took. */
export function StatusBar(): ReactElement {
  const isBusy = useCurrent((state) => state.busy);
  const busy = useLasting(isBusy, 250);
  const isOverdue = useLasting(isBusy, OVERDUE_MILLISECONDS);
  const away = useCurrent((state) => state.away);
  const isCrowded = useCurrent((state) => state.isCrowded);
  const problem = useCurrent((state) => state.problem);
  const view = useCurrent((state) => state.view);
  const shown = useCurrent((state) => state.shown);
  const engine = useCurrent((state) => state.catalogue?.engine);
  const count = useProblemCount();
  const [tone, text] = away
    ? ["warning", isCrowded ? "Server busy" : "Server away"]
    : busy && isBusy
      ? isOverdue
        ? ["warning", "No answer yet"]
        : ["busy", "Evaluating…"]
      : problem
        ? ["error", shown ? "Out of date" : "Not shown"]
        : ["ok", shown ? "Up to date" : "Ready"];
  const nodes = [...(shown?.report.nodes.values() ?? [])];
  const cached = nodes.filter((node) => node.cached).length;
  const total = shown && shown.report.prepare + shown.report.evaluate + shown.report.encode;
  return (
    <footer className="status-bar" role="contentinfo" aria-label="Status">
      <span className="status-main" data-tone={tone} role="status">
        {text}
      </span>
      {view && (
        <span>
          {plural(view.nodes.length, "node")} · {plural(view.wires.length, "wire")}
        </span>
      )}
      {count > 0 && <span className="status-problems">{plural(count, "problem")}</span>}
      <span className="spacer" />
      {total !== null && total !== undefined && <span>Server {millisecondText(total)}</span>}
      {nodes.length > 0 && (
        <span className="status-cached" title="Nodes whose value was already there">
          {cached} of {nodes.length} from the cache
        </span>
      )}
      {engine && <span className="status-engine">Dini {engine}</span>}
    </footer>
  );
}
