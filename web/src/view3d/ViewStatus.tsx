import { type ReactElement, useEffect, useState } from "react";
import { byteText, grouped, millisecondText } from "../model/format";
import { problemText } from "../net/problem";
import type { SessionState } from "../session/state";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { OVERDUE_MILLISECONDS, useLasting } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";

/** From here on a person may want to stop it. */
const LONG_MILLISECONDS = 1200;

/** Waiting, failing and being out of date. */
export function Progress({ failure }: { failure: string }): ReactElement {
  const busy = useCurrent((state) => state.busy && !state.away);
  const isEmpty = useCurrent((state) => state.shown === null);
  const problem = useCurrent((state) => state.problem);
  const noOutput = useCurrent((state) => state.document !== null && !hasOutput(state));
  const empty = noOutput ? "What the graph makes appears here." : "";
  const waiting = busy ? "Evaluating…" : empty;
  const slow = useLasting(busy, 250);
  const long = useLasting(busy, LONG_MILLISECONDS);
  return (
    <>
      {slow && <div className="progress" role="progressbar" aria-label="Evaluating" />}
      {long && <Waiting />}
      {failure && <p className="view-message">{failure}</p>}
      {!failure && isEmpty && !problem && !long && <p className="pane-wait">{waiting}</p>}
      {problem && !long && (
        <div className="view-problem" role="status">
          <Icon name="alert" />
          <span>
            {!isEmpty && <strong>Out of date. </strong>}
            {problemText(problem)}
          </span>
          {problem.errors.length === 0 && <RetryButton />}
        </div>
      )}
    </>
  );
}

function Waiting(): ReactElement {
  const session = useCurrentSession();
  const isOverdue = useLasting(true, OVERDUE_MILLISECONDS - LONG_MILLISECONDS);
  const [seconds, setSeconds] = useState(Math.round(LONG_MILLISECONDS / 1000));
  useEffect(() => {
    const timer = window.setInterval(() => setSeconds((before) => before + 1), 1000);
    return () => window.clearInterval(timer);
  }, []);
  return (
    <div className="view-waiting">
      <span>{isOverdue ? `No answer for ${seconds} s` : `Evaluating… ${seconds} s`}</span>
      {isOverdue && <RetryButton />}
      <button type="button" className="button quiet" onClick={() => session.stop()}>
        Stop
      </button>
    </div>
  );
}

/** For what is no fault of the graph. */
function RetryButton(): ReactElement | null {
  const session = useCurrentSession();
  const canRetry = useCurrent(hasOutput);
  if (!canRetry) return null;
  return (
    <button type="button" className="button" onClick={() => session.retry()}>
      Try again
    </button>
  );
}

function hasOutput({ drawn }: SessionState): boolean {
  return drawn !== null;
}

export function Statistics(): ReactElement | null {
  const shown = useCurrent((state) => state.shown);
  if (!shown) return null;
  const more = [
    `${grouped(shown.vertices)} vertices`,
    byteText(shown.model.byteLength),
    `${millisecondText(shown.report.evaluate)} evaluate`,
    `${millisecondText(shown.decodeMilliseconds)} decode`,
  ];
  return (
    <div className="statistics" role="group" aria-label="Statistics" title={more.join(" · ")}>
      <span>{grouped(shown.triangles)} triangles</span>
      {shown.quality === "draft" && <span className="statistics-draft">draft</span>}
    </div>
  );
}
