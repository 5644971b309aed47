import type { ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../app/context";
import { Icon } from "../app/icons";
import { plural } from "../model/format";
import { parameterOf, type ProblemEntry } from "../net/problem";

/** Errors of the newest evaluation plus failed checks and warnings of the shown one. */
export function useProblemCount(): number {
  const problem = useCurrent((state) => state.problem);
  const report = useCurrent((state) => state.shown?.report);
  const errors = problem ? Math.max(1, problem.errors.length) : 0;
  return errors + (report?.warnings.length ?? 0) + (report?.checks.filter((check) => !check.passed).length ?? 0);
}

/** Everything that is wrong, with its place; choosing an entry selects its node. */
export function Problems(): ReactElement {
  const problem = useCurrent((state) => state.problem);
  const report = useCurrent((state) => state.shown?.report);
  const checks = report?.checks.filter((check) => !check.passed) ?? [];
  const warnings = report?.warnings ?? [];
  if (!problem && checks.length + warnings.length === 0) {
    return (
      <p className="empty good">
        <Icon name="check" /> No problems.
      </p>
    );
  }
  return (
    <div className="problems">
      {problem && problem.errors.length === 0 && (
        <ul>
          <Row
            tone="error"
            entry={{
              code: problem.code,
              node: "",
              port: "",
              pointer: "",
              detail: problem.detail || problem.title,
              fix: [],
            }}
          />
        </ul>
      )}
      <ul>
        {problem?.errors.map((entry, index) => (
          <Row key={index} tone="error" entry={entry} />
        ))}
        {checks.map((check, index) => (
          <Row
            key={`check-${index}`}
            tone="warning"
            entry={{
              code: "check-failed",
              node: check.node,
              port: "",
              pointer: "",
              detail: check.message || `The value is ${check.value}.`,
              fix: [],
            }}
          />
        ))}
        {warnings.map((entry, index) => (
          <Row key={`warning-${index}`} tone="warning" entry={entry} />
        ))}
      </ul>
      {problem && problem.blocked.length > 0 && (
        <p className="problems-blocked">
          {plural(problem.blocked.length, "node")} behind {problem.errors.length === 1 ? "it" : "them"} could not be
          evaluated.
        </p>
      )}
    </div>
  );
}

function Row({ tone, entry }: { tone: "error" | "warning"; entry: ProblemEntry }): ReactElement {
  const session = useCurrentSession();
  const place = useCurrent((state) => {
    const parameter = parameterOf(entry);
    if (parameter !== undefined)
      return state.document?.parameters.find((item) => item.name === parameter)?.label ?? parameter;
    const node = state.view?.nodes.find((item) => item.id === entry.node);
    const name = node ? `${node.title} (${node.id})` : entry.node;
    return entry.port ? `${name} · ${entry.port}` : name;
  });
  const isKnown = useCurrent((state) => state.document?.nodes.has(entry.node) ?? false);
  const body = (
    <>
      <Icon name="alert" />
      <span className="problem-text">
        <span>{entry.detail || entry.code}</span>
        <span className="problem-place">
          {place}
          {entry.code && <code>{entry.code}</code>}
        </span>
      </span>
    </>
  );
  return (
    <li className="problem" data-tone={tone}>
      {isKnown ? (
        <button type="button" onClick={() => session.select([entry.node])}>
          {body}
        </button>
      ) : (
        <div>{body}</div>
      )}
    </li>
  );
}
