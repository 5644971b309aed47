import { useEffect, useRef, useState, type ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../app/context";
import { useLasting, useRemembered } from "../app/hooks";
import { Icon } from "../app/icons";
import { makeThumbnails } from "../app/thumbnails";
import { byteText, grouped, millisecondText } from "../model/format";
import { problemText } from "../net/problem";
import type { ShadingMode } from "./materials";
import type { Viewer } from "./Viewer";

const MODES: readonly { id: ShadingMode; title: string; hint: string }[] = [
  { id: "shaded", title: "Shaded", hint: "Surfaces" },
  { id: "shaded-wire", title: "Lines", hint: "Surfaces with their lines" },
  { id: "wire", title: "Wire", hint: "Lines only" },
  { id: "normals", title: "Normals", hint: "Directions as colors" },
];

/**
 * The pane around the 3D view. The view itself is loaded after the first paint and lives outside React. As a picture it
 * is the model and nothing else.
 */
export function ViewPane({ light, picture }: { light: boolean; picture: boolean }): ReactElement {
  const session = useCurrentSession();
  const place = useRef<HTMLDivElement>(null);
  const [viewer, setViewer] = useState<Viewer | null>(null);
  const [failure, setFailure] = useState("");
  const [mode, setMode] = useRemembered("dini.view.mode", "shaded");
  const [grid, setGrid] = useRemembered("dini.view.grid", "on");
  const [axes, setAxes] = useRemembered("dini.view.axes", "on");

  useEffect(() => {
    let made: Viewer | undefined;
    let isGone = false;
    import("./Viewer")
      .then(({ Viewer: Made }) => {
        if (isGone || !place.current) return;
        made = new Made(
          place.current,
          "The model. Drag to turn, Shift and drag to move, wheel to zoom; arrow keys turn.",
          picture,
        );
        setViewer(made);
        session.viewerLoaded(made);
        if (!picture) void makeThumbnails(session, made);
      })
      .catch((error: unknown) => {
        const reason = "The 3D view could not start. It needs WebGL 2.";
        console.warn(reason, error);
        setFailure(reason);
        session.viewerFailed(reason);
      });
    return () => {
      isGone = true;
      made?.dispose();
    };
  }, [session, picture]);

  useEffect(() => {
    const chosen = picture ? "shaded" : (MODES.find((item) => item.id === mode)?.id ?? "shaded");
    viewer?.setSettings({ mode: chosen, grid: !picture && grid === "on", axes: !picture && axes === "on", light });
  }, [viewer, picture, mode, grid, axes, light]);

  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const target = event.target as HTMLElement;
      const isElsewhere = target.closest("input, select, textarea, .graph-pane, [role=slider], [role=separator]");
      if (isElsewhere || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key.toLowerCase() === "f") viewer?.frame();
      if (event.key === "Home") viewer?.home();
    };
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, [viewer]);

  const stale = useCurrent((state) => state.problem !== null && state.shown !== null);
  const tools = (
    <div className="view-tools">
      <div className="segments" role="radiogroup" aria-label="Shading">
        {MODES.map((item) => (
          <button
            key={item.id}
            type="button"
            role="radio"
            aria-checked={mode === item.id}
            title={item.hint}
            onClick={() => setMode(item.id)}
          >
            {item.title}
          </button>
        ))}
      </div>
      <div className="segments">
        <Toggle title="Grid" icon="grid" on={grid === "on"} onChange={(on) => setGrid(on ? "on" : "off")} />
        <Toggle title="Axes" icon="axes" on={axes === "on"} onChange={(on) => setAxes(on ? "on" : "off")} />
        <button
          type="button"
          title="Fill the view with the model (F)"
          aria-label="Frame"
          onClick={() => viewer?.frame()}
        >
          <Icon name="frame" />
        </button>
        <button type="button" title="Standard view (Home)" aria-label="Home view" onClick={() => viewer?.home()}>
          <Icon name="home" />
        </button>
      </div>
    </div>
  );
  return (
    <section className="view-pane" aria-label="Model" data-stale={stale} data-picture={picture}>
      <div className="canvas-place" ref={place} />
      {!picture && tools}
      <Progress failure={failure} />
      {!picture && <Statistics />}
    </section>
  );
}

function Toggle({
  title,
  icon,
  on,
  onChange,
}: {
  title: string;
  icon: "grid" | "axes";
  on: boolean;
  onChange(on: boolean): void;
}): ReactElement {
  return (
    <button type="button" aria-pressed={on} aria-label={title} title={title} onClick={() => onChange(!on)}>
      <Icon name={icon} />
    </button>
  );
}

/** Waiting, failing and being out of date. */
function Progress({ failure }: { failure: string }): ReactElement {
  const busy = useCurrent((state) => state.busy && !state.away);
  const isEmpty = useCurrent((state) => state.shown === null);
  const problem = useCurrent((state) => state.problem);
  const slow = useLasting(busy, 250);
  return (
    <>
      {slow && <div className="progress" role="progressbar" aria-label="Evaluating" />}
      {failure && <p className="view-message">{failure}</p>}
      {!failure && isEmpty && !problem && <p className="pane-wait">{busy ? "Evaluating…" : ""}</p>}
      {problem && (
        <div className="view-problem" role="status">
          <Icon name="alert" />
          <span>
            {!isEmpty && <strong>Out of date. </strong>}
            {problemText(problem)}
          </span>
        </div>
      )}
    </>
  );
}

function Statistics(): ReactElement | null {
  const shown = useCurrent((state) => state.shown);
  if (!shown) return null;
  const parts = [
    `${grouped(shown.triangles)} triangles`,
    `${grouped(shown.vertices)} vertices`,
    byteText(shown.model.byteLength),
    `${millisecondText(shown.report.evaluate)} evaluate`,
    `${millisecondText(shown.decodeMilliseconds)} decode`,
  ];
  return (
    <div className="statistics" aria-label="Statistics">
      {parts.map((part) => (
        <span key={part.replace(/^[\d\s.]+/, "")}>{part}</span>
      ))}
      {shown.quality === "draft" && <span className="statistics-draft">draft</span>}
    </div>
  );
}
