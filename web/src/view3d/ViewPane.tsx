import { type ReactElement, type ReactNode, useEffect, useRef, useState } from "react";
import { setCamera } from "../model/edit";
import { fileName } from "../model/format";
import { comparisonOf } from "../session/comparison";
import { saveBlob } from "../session/download";
import { keyText } from "../session/shortcuts";
import { makeThumbnails } from "../session/thumbnails";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { useStore } from "../widgets/hooks";
import { Icon } from "../widgets/Icon";
import { CompareBar } from "./CompareBar";
import { showGizmosOf, writeGizmo } from "./gizmo_link";
import type { OutOfView } from "./in_view";
import { Legend } from "./Legend";
import type { CurvatureScale } from "./model_look";
import { PaletteLegends } from "./PaletteLegends";
import { SectionPanel } from "./SectionPanel";
import { useShowMode } from "./show_mode";
import type { Viewer } from "./Viewer";
import { Progress, Statistics } from "./ViewStatus";
import { StandardViews, type ViewActions, ViewTools } from "./ViewTools";
import { useViewKeys } from "./view_keys";
import { useViewSettings } from "./view_settings";

const LABEL = "The model. Drag to turn, Shift and drag to move, wheel to zoom; arrow keys turn.";

interface ViewPaneProps {
  light: boolean;
  picture: boolean;
  /** The form beside the model when that is shown to someone. */
  controls: ReactNode;
}

/**
 * The pane around the 3D view. The view itself is loaded after the first paint and lives outside React. As a picture it
 * is the model and nothing else.
 */
export function ViewPane({ light, picture, controls }: ViewPaneProps): ReactElement {
  const session = useCurrentSession();
  const pane = useRef<HTMLElement>(null);
  const place = useRef<HTMLDivElement>(null);
  const [viewer, setViewer] = useState<Viewer | null>(null);
  const [failure, setFailure] = useState("");
  const [scale, setScale] = useState<CurvatureScale | null>(null);
  const [deviation, setDeviation] = useState<number>();
  const [outOfView, setOutOfView] = useState<OutOfView>("");
  const choice = useViewSettings(light, picture);
  const [showing, setShowing] = useShowMode();
  const stale = useCurrent((state) => state.problem !== null && state.shown !== null);
  // While the server is away no picture is near.
  const busy = useCurrent((state) => state.busy && !state.away);
  const isCompared = useStore(comparisonOf(session).store, ({ name }) => name !== null);
  const { settings } = choice;
  // The view calls back long after it was made; what it calls is always the newest.
  const newest = useRef(choice);
  newest.current = choice;

  useEffect(() => {
    let made: Viewer | undefined;
    let stop = (): void => undefined;
    let isGone = false;
    import("./Viewer")
      .then(({ Viewer: Made }) => {
        if (isGone || !place.current) return;
        made = new Made(place.current, LABEL, picture, {
          section: (section) => newest.current.set({ section }),
          outOfView: setOutOfView,
          scale: setScale,
          deviation: setDeviation,
          write: (gizmo, value, gesture) => writeGizmo(session, gizmo, value, gesture),
          end: (_, gesture, cancelled) => (cancelled ? session.cancelGesture(gesture) : session.endGesture()),
        });
        stop = showGizmosOf(session, made);
        setViewer(made);
        session.viewerLoaded(made);
        comparisonOf(session).drawAgain(made);
        if (!picture) void makeThumbnails(session.store, made);
      })
      .catch((error: unknown) => {
        const reason = "The 3D view could not start. It needs WebGL 2.";
        console.warn(reason, error);
        setFailure(reason);
        session.viewerFailed(reason);
      });
    return () => {
      isGone = true;
      stop();
      made?.dispose();
    };
  }, [session, picture]);

  useEffect(() => viewer?.setBusy(busy), [viewer, busy]);
  const wanted = JSON.stringify(settings);
  useEffect(() => viewer?.setSettings(newest.current.settings), [viewer, wanted]);

  const actions: ViewActions = {
    frame: () => viewer?.frame(),
    home: () => viewer?.home(),
    keep: () => {
      const camera = viewer?.keepView();
      if (camera) session.edit("Keep the view", setCamera(camera));
    },
    view: (view) => viewer?.standardView(view),
    screenshot: () => viewer?.still().toBlob(savePicture, "image/png"),
    show: () => setShowing(!showing),
  };
  const savePicture = (blob: Blob | null): void => {
    const title = session.store.get().document?.title ?? "";
    if (blob) saveBlob(blob, `${fileName(title)}.png`);
  };
  useViewKeys(pane, actions, () => choice.set({ orthographic: !settings.orthographic }));

  const startSection = (): void => {
    choice.set({ section: settings.section ? null : (viewer?.sectionTowardsEye() ?? null) });
  };
  return (
    <section className="view-pane" aria-label="Model" data-stale={stale} data-picture={picture} ref={pane}>
      <div className="canvas-place" ref={place} />
      {!picture && <ViewTools choice={choice} actions={actions} showing={showing} onSection={startSection} />}
      <Progress failure={failure} />
      {outOfView && !picture && (
        <button type="button" className="view-pill" onClick={() => viewer?.frameModel()}>
          <Icon name="frame" />
          <span>
            {outOfView === "out" ? "Model is out of view" : "Model is cut off"} · Frame{" "}
            <kbd>{keyText("model-fill")}</kbd>
          </span>
        </button>
      )}
      {!picture && (
        <div className="view-foot" data-showing={showing}>
          {!showing && <Statistics />}
          <StandardViews choice={choice} actions={actions} />
        </div>
      )}
      {settings.section && viewer && (
        <SectionPanel
          section={settings.section}
          reach={viewer.sectionReach}
          onChange={(section) => choice.set({ section })}
        />
      )}
      {settings.mode === "by-curvature" && (
        <Legend scale={scale} kind={settings.curvatureKind} onKind={(curvatureKind) => choice.set({ curvatureKind })} />
      )}
      {!picture && <CompareBar deviation={deviation} />}
      {(settings.mode === "shaded" || settings.mode === "shaded-wire") && !picture && !showing && !isCompared && (
        <PaletteLegends />
      )}
      {showing && <div className="show-controls">{controls}</div>}
    </section>
  );
}
