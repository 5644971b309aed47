import { type ReactElement, useEffect, useState } from "react";
import { FilesLayer } from "../files/FilesLayer";
import { UnkeptBanner } from "../files/UnkeptBanner";
import { GraphPane } from "../graph/GraphPane";
import { Controls } from "../panels/Controls";
import { Examples } from "../panels/Examples";
import { Panel } from "../panels/Panel";
import type { Editor } from "../session/editor";
import { ViewPane } from "../view3d/ViewPane";
import { EditorContext, useCurrent } from "../widgets/context";
import { Dialog } from "../widgets/Dialog";
import { useMedia, useRemembered } from "../widgets/hooks";
import { Tabs } from "../widgets/Tabs";
import { Tips } from "../widgets/Tip";
import { wantsPicture } from "./address";
import { Banner } from "./Banner";
import { HelpDialog } from "./HelpDialog";
import { Hint } from "./Hint";
import { listen } from "./keyboard";
import { SplitPane } from "./SplitPane";
import { StatusBar } from "./StatusBar";
import { TopBar } from "./TopBar";
import { useTheme } from "./use_theme";

const NARROW = "(max-width: 899px)";

/** The page. `editor` is what its parts have in common. */
export function App({ editor }: { editor: Editor }): ReactElement {
  useEffect(() => listen(editor), [editor]);
  return (
    <EditorContext value={editor}>
      <Tips>
        <Page />
      </Tips>
    </EditorContext>
  );
}

function Page(): ReactElement {
  const [theme, setTheme] = useTheme();
  const [isGalleryOpen, setGalleryOpen] = useState(false);
  const [tab, setTab] = useState("model");
  const [arrangement, setArrangement] = useRemembered("dini.arrangement", "beside");
  const narrow = useMedia(NARROW);
  const opened = useCurrent((state) => state.opened);

  // In a narrow window, choosing an example is followed by looking at it.
  useEffect(() => {
    // The first graph opens by itself, maybe after a person chose a tab.
    if (opened > 1) setTab("model");
  }, [opened]);

  const isPicture = wantsPicture();
  const view = <ViewPane light={theme === "light"} picture={isPicture} controls={<Controls />} />;
  if (isPicture) return view;

  const isBelow = arrangement === "below" && !narrow;
  const model = (
    <SplitPane
      key={isBelow ? "row" : "column"}
      name={isBelow ? "model.row" : "model"}
      label="Border between model and controls"
      direction={isBelow ? "row" : "column"}
      initial={0.62}
    >
      {[view, <Panel key="panel" />]}
    </SplitPane>
  );
  return (
    <>
      <TopBar
        theme={theme}
        onTheme={setTheme}
        galleryOpen={isGalleryOpen}
        onGallery={() => setGalleryOpen(true)}
        graphBelow={isBelow}
        onGraphBelow={narrow ? undefined : (below) => setArrangement(below ? "below" : "beside")}
      />
      <Banner />
      <UnkeptBanner />
      <main className="work">
        {narrow ? (
          <Tabs
            className="pane-tabs"
            label="Panes"
            keep
            chosen={tab}
            onChoose={setTab}
            tabs={[
              { id: "model", title: "Model", content: model },
              { id: "graph", title: "Graph", content: <GraphPane /> },
              { id: "examples", title: "Examples", content: <Examples light={theme === "light"} /> },
            ]}
          />
        ) : isBelow ? (
          <SplitPane
            key="below"
            name="graph.below"
            label="Border between model and graph"
            direction="column"
            initial={0.5}
          >
            {[model, <GraphPane key="graph" />]}
          </SplitPane>
        ) : (
          <SplitPane key="beside" name="graph" label="Border between graph and model" direction="row" initial={0.54}>
            {[<GraphPane key="graph" />, model]}
          </SplitPane>
        )}
      </main>
      {isGalleryOpen && !narrow && (
        <Dialog title="Examples" className="gallery-dialog" onClose={() => setGalleryOpen(false)}>
          <Examples light={theme === "light"} onOpened={() => setGalleryOpen(false)} />
        </Dialog>
      )}
      <Hint />
      <StatusBar />
      <FilesLayer />
      <HelpDialog />
    </>
  );
}
