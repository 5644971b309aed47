import { type ReactElement, useEffect, useState } from "react";
import { useCurrent } from "../widgets/context";
import { Tabs } from "../widgets/Tabs";
import { Controls } from "./Controls";
import { Inspector } from "./Inspector";
import { Problems, useProblemCount } from "./Problems";

/** The panel below the model: the graph's controls, the selected node, the problems. */
export function Panel(): ReactElement {
  const [tab, setTab] = useState("controls");
  const selected = useCurrent((state) => state.selected);
  const opened = useCurrent((state) => state.opened);
  const count = useProblemCount();
  useEffect(() => setTab("controls"), [opened]);
  useEffect(() => {
    if (selected !== null) setTab("node");
  }, [selected]);
  const problems = <>Problems{count > 0 && <span className="badge">{count}</span>}</>;
  return (
    <Tabs
      className="panel"
      label="Panel"
      chosen={tab}
      onChoose={setTab}
      tabs={[
        { id: "controls", title: "Controls", content: <Controls /> },
        { id: "node", title: "Node", content: <Inspector /> },
        { id: "problems", title: problems, content: <Problems /> },
      ]}
    />
  );
}
