import type { ReactElement } from "react";
import { lookedAt } from "../model/document";
import { plural } from "../model/format";
import type { ParameterValue } from "../model/parameters";
import { patchDocument } from "../model/patch";
import { firstOf } from "../model/scope";
import { isSameEntry, type ProblemEntry, parameterOf } from "../net/problem";
import type { SessionState } from "../session/state";
import { useCurrent, useCurrentSession, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";

/** Errors of the newest evaluation and of the whole graph, plus failed checks and warnings of the shown picture. */
export function useProblemCount(): number {
  return useCurrent((state) => {
    const { errors, others } = problemsIn(state);
    return (state.problem && errors.length === 0 ? 1 : errors.length) + others.length;
  });
}

/** Everything that is wrong, with its place; choosing an entry goes to its node, and a known fix is one press away. */
export function Problems(): ReactElement {
  const problem = useCurrent((state) => state.problem);
  const checked = useCurrent((state) => state.checked);
  const shown = useCurrent((state) => state.shown);
  const { errors, others } = problemsIn({ problem, checked, shown });
  const blocked = problem?.blocked ?? checked?.blocked ?? [];
  if (!problem && errors.length + others.length === 0) {
    return (
      <p className="empty good">
        <Icon name="check" /> No problems.
      </p>
    );
  }
  return (
    <div className="problems">
      <ul>
        {problem && errors.length === 0 && (
          <Row tone="error" entry={plainEntry(problem.code, "", problem.detail || problem.title)} />
        )}
        {errors.map((entry) => (
          <Row key={keyOf(entry)} tone="error" entry={entry} />
        ))}
        {others.map((entry) => (
          <Row key={keyOf(entry)} tone="warning" entry={entry} />
        ))}
      </ul>
      {blocked.length > 0 && (
        <p className="problems-blocked">
          {plural(blocked.length, "node")} behind {errors.length === 1 ? "it" : "them"} could not be evaluated.
        </p>
      )}
    </div>
  );
}

type Wrong = Pick<SessionState, "problem" | "checked" | "shown">;

/** Errors once each, whoever reported them; then failed checks and warnings. */
function problemsIn({ problem, checked, shown }: Wrong): { errors: ProblemEntry[]; others: ProblemEntry[] } {
  const errors = [...(problem?.errors ?? [])];
  for (const entry of checked?.errors ?? []) if (!errors.some((item) => isSameEntry(item, entry))) errors.push(entry);
  const failed = (shown?.report.checks ?? [])
    // What keeps a check from running is said by the error of its node.
    .filter((check) => !check.passed && !errors.some(({ node }) => node === check.node))
    .map((check) => plainEntry("check-failed", check.node, check.message || "The check failed."));
  const warnings = (shown?.report.warnings ?? []).filter((entry) => !errors.some((item) => isSameEntry(item, entry)));
  return { errors, others: [...failed, ...warnings] };
}

function keyOf({ code, node, port, pointer, detail }: ProblemEntry): string {
  return [code, node, port, pointer, detail].join(" ");
}

function plainEntry(code: string, node: string, detail: string): ProblemEntry {
  return { code, node, port: "", pointer: "", detail, fix: [] };
}

function Row({ tone, entry }: { tone: "error" | "warning"; entry: ProblemEntry }): ReactElement {
  const editor = useEditor();
  const place = useCurrent((state) => {
    const parameter = parameterOf(entry);
    if (parameter !== undefined)
      return state.document?.parameters.find((item) => item.name === parameter)?.label ?? parameter;
    const node = state.view?.byId.get(entry.node);
    const name = node ? `${node.title} (${node.id})` : entry.node;
    return entry.port ? `${name} · ${entry.port}` : name;
  });
  const isKnown = useCurrent(
    ({ document }) => document !== null && lookedAt(document, []).nodes.has(firstOf(entry.node)),
  );
  const go = (): void => {
    if (editor.session.goTo(entry.node)) editor.canvas?.focusNode(entry.node.split("/").at(-1) ?? "");
  };
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
        <button type="button" onClick={go}>
          {body}
        </button>
      ) : (
        <div>{body}</div>
      )}
      {entry.fix.length > 0 && <FixButton entry={entry} />}
    </li>
  );
}

function FixButton({ entry }: { entry: ProblemEntry }): ReactElement {
  const session = useCurrentSession();
  const editor = useEditor();
  const apply = (): void => {
    const { document } = session.store.get();
    const name = parameterOf(entry);
    const parameter = document?.parameters.find((item) => item.name === name);
    const value = entry.fix[0]?.value;
    if (parameter && value !== undefined && value !== null) {
      session.setParameter(parameter, value as ParameterValue, false);
    } else if (document) {
      const fixed = patchDocument(document, entry.fix);
      if (!fixed) {
        editor.say("The graph has changed; this fix no longer fits.", "refused");
        return;
      }
      session.edit("Apply fix", () => fixed);
    }
    editor.say("Applied the fix");
  };
  const what = entry.fix.map((step) => (step.op === "remove" ? "remove it" : `use ${JSON.stringify(step.value)}`));
  return (
    <button type="button" className="button quiet" title={what.join(", ")} onClick={apply}>
      Apply fix
    </button>
  );
}
