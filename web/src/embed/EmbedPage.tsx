import { type ReactElement, useEffect, useId, useRef, useState } from "react";
import { clamp, type Parameter, parameterValue, sameValues } from "../model/parameters";
import { parameterErrors, problemText } from "../net/problem";
import type { Viewer } from "../view3d/Viewer";
import { PLAIN } from "../view3d/viewer_settings";
import { useLasting, useMedia, useStore } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";
import { ValueField } from "../widgets/ValueField";
import type { Show, ShowState } from "./show";

const LABEL = "The model. Drag to turn, Shift and drag to move, wheel to zoom; arrow keys turn.";

interface ShowProps {
  show: Show;
}

/** The model of a stored graph, and its sliders below it. */
export function EmbedPage({ show }: ShowProps): ReactElement {
  const { document: graph, values, given, shown } = useStore(show.store, (state) => state);
  const [viewer, setViewer] = useState<Viewer | null>(null);
  const [isOpen, setIsOpen] = useState(true);
  const hasControls = graph !== null && graph.parameters.length > 0;
  return (
    <main className="embed">
      <section className="view-pane" aria-label="Model" data-stale={useStore(show.store, isStale)}>
        <EmbedView show={show} onViewer={setViewer} />
        {graph && <h1 className="embed-title">{graph.title}</h1>}
        <div className="embed-tools" role="group" aria-label="View">
          {!sameValues(values, given) && <Tool label="Reset" icon="reset" onClick={() => show.reset()} />}
          {shown > 0 && <Tool label="Opening view" icon="home" onClick={() => viewer?.home()} />}
          {hasControls && <Tool label="Controls" icon="sliders" expanded={isOpen} onClick={() => setIsOpen(!isOpen)} />}
        </div>
        <EmbedStatus show={show} />
      </section>
      {hasControls && isOpen && (
        <section className="embed-controls" aria-label="Controls">
          {graph.parameters.map((parameter) => (
            <Row key={parameter.name} show={show} parameter={parameter} />
          ))}
        </section>
      )}
    </main>
  );
}

/** A model that is not that of the sliders. */
const isStale = (state: ShowState): boolean => state.problem !== null && state.shown > 0;

/** The 3D view, which is loaded after the first paint and lives outside React. */
function EmbedView({ show, onViewer }: ShowProps & { onViewer(viewer: Viewer): void }): ReactElement {
  const place = useRef<HTMLDivElement>(null);
  const made = useRef<Viewer | null>(null);
  const isLight = useLightTheme();
  const light = useRef(isLight);
  light.current = isLight;
  const busy = useStore(show.store, (state) => state.busy && !state.away);
  useEffect(() => {
    const nothing = (): void => undefined;
    import("../view3d/Viewer")
      .then(({ Viewer: Made }) => {
        if (!place.current || made.current) return;
        const host = {
          section: nothing,
          outOfView: nothing,
          scale: nothing,
          deviation: nothing,
          write: nothing,
          end: nothing,
        };
        made.current = new Made(place.current, LABEL, false, host);
        made.current.setSettings({ ...PLAIN, light: light.current, axes: false, control: false });
        onViewer(made.current);
        show.viewerLoaded(made.current);
      })
      .catch(() => show.viewerFailed());
  }, [show, onViewer]);
  useEffect(() => made.current?.setSettings({ ...PLAIN, light: isLight, axes: false, control: false }), [isLight]);
  useEffect(() => made.current?.setBusy(busy), [busy]);
  return <div className="canvas-place" ref={place} />;
}

/** Whether the page is light: see theme.ts. */
function useLightTheme(): boolean {
  const isSystemLight = useMedia("(prefers-color-scheme: light)");
  const asked = new URLSearchParams(location.search).get("theme");
  return asked === "light" || (asked !== "dark" && isSystemLight);
}

function EmbedStatus({ show }: ShowProps): ReactElement {
  const { problem, away, busy, shown } = useStore(show.store, (state) => state);
  const isSlow = useLasting(busy && !away, 250);
  const isAway = useLasting(away, 250);
  const text = problem ? problemText(problem) : isAway ? "The server cannot be reached. It is asked again." : "";
  return (
    <>
      {isSlow && <div className="progress" role="progressbar" aria-label="Evaluating" />}
      {text !== "" && shown === 0 && (
        <div className="embed-message" role="status">
          <Icon name={problem ? "alert" : "offline"} />
          <p>{text}</p>
        </div>
      )}
      {text !== "" && shown > 0 && (
        <div className="embed-problem" role="status">
          <Icon name={problem ? "alert" : "offline"} />
          <span>{text}</span>
        </div>
      )}
    </>
  );
}

/** Label and field of one parameter. */
function Row({ show, parameter }: ShowProps & { parameter: Parameter }): ReactElement {
  const id = useId();
  const value = useStore(show.store, (state) => parameterValue(parameter, state.values));
  const problem = useStore(show.store, (state) => state.problem);
  const invalid = parameterErrors(problem, parameter.name).length > 0;
  const { label, description } = parameter;
  return (
    <div className="embed-row" data-parameter={parameter.name}>
      <label htmlFor={id} title={description || undefined}>
        {label}
      </label>
      <ValueField
        {...{ id, parameter, value, label, invalid }}
        partLabel={(letter) => `${label} ${letter}`}
        look="form"
        within={(next) => clamp(parameter, next)}
        onChange={(next, moving) => show.set(parameter, next, moving)}
      />
    </div>
  );
}

interface ToolProps {
  label: string;
  icon: "reset" | "home" | "sliders";
  expanded?: boolean;
  onClick(): void;
}

function Tool({ label, icon, expanded, onClick }: ToolProps): ReactElement {
  return (
    <button type="button" aria-label={label} title={label} aria-expanded={expanded} onClick={onClick}>
      <Icon name={icon} />
    </button>
  );
}
