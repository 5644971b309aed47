import { useEffect, useState, type ReactElement } from "react";
import { FilesLayer } from "../files/FilesLayer";
import { UnkeptBanner } from "../files/UnkeptBanner";
import { GraphPane } from "../graph/GraphPane";
import { Examples } from "../panels/Examples";
import { Panel } from "../panels/Panel";
import { ViewPane } from "../view3d/ViewPane";
import { wantsPicture } from "./address";
import { Banner } from "./Banner";
import { EditorContext, SessionContext } from "./context";
import type { Editor } from "./editor";
import { HelpDialog } from "./HelpDialog";
import { Hint } from "./Hint";
import { listen } from "./keyboard";
import { useMedia, useRemembered, useSession, useTheme } from "./hooks";
import { SplitPane } from "./SplitPane";
import { StatusBar } from "./StatusBar";
import { Tabs } from "./Tabs";
import { TopBar } from "./TopBar";

const NARROW = "(max-width: 899px)";

export function App({ editor }: { editor: Editor }): ReactElement {
  const { session } = editor;
  const [theme, setTheme] = useTheme();
  const [gallery, setGallery] = useRemembered("dini.gallery", "closed");
  const [tab, setTab] = useState("model");
  const narrow = useMedia(NARROW);
  const opened = useSession(session, (state) => state.opened);

  // In a narrow window, choosing an example is followed by looking at it.
  useEffect(() => {
    // The first graph opens by itself, maybe after a person chose a tab.
    if (opened > 1) setTab("model");
  }, [opened]);
  useEffect(() => listen(editor), [editor]);

  const isPicture = wantsPicture();
  const view = <ViewPane light={theme === "light"} picture={isPicture} />;
  if (isPicture) {
    return (
      <SessionContext value={session}>
        <EditorContext value={editor}>{view}</EditorContext>
      </SessionContext>
    );
  }

  const isOpen = gallery === "open";
  const model = (
    <SplitPane name="model" label="Border between model and controls" direction="column" initial={0.62}>
      {[view, <Panel key="panel" />]}
    </SplitPane>
  );
  return (
    <SessionContext value={session}>
      <EditorContext value={editor}>
        <TopBar
          theme={theme}
          onTheme={setTheme}
          galleryOpen={isOpen}
          onGallery={() => setGallery(isOpen ? "closed" : "open")}
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
                { id: "examples", title: "Examples", content: <Examples /> },
              ]}
            />
          ) : (
            <>
              <SplitPane name="graph" label="Border between graph and model" direction="row" initial={0.54}>
                {[
                  <SplitPane
                    key="left"
                    name="gallery"
                    label="Border between graph and examples"
                    direction="column"
                    initial={0.515}
                  >
                    {[<GraphPane key="graph" />, isOpen && <Examples />]}
                  </SplitPane>,
                  model,
                ]}
              </SplitPane>
            </>
          )}
        </main>
        <Hint />
        <StatusBar />
        <FilesLayer />
        <HelpDialog />
      </EditorContext>
    </SessionContext>
  );
}
