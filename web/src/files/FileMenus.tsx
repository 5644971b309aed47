import type { ReactElement } from "react";
import { commandLineText } from "../app/commands";
import { useCurrent, useCurrentSession } from "../app/context";
import { Icon } from "../app/icons";
import { keyText } from "../app/shortcuts";
import { filesOf } from "./Files";
import { Menu } from "./Menu";

/** Opening, saving and recovering. */
export function FileMenu(): ReactElement {
  const session = useCurrentSession();
  const files = filesOf(session);
  const isOpen = useCurrent((state) => state.document !== null);
  return (
    <Menu
      label="File"
      items={[
        { title: "New", run: () => session.newDocument() },
        { title: "Open…", keys: keyText("open-file"), run: () => void files.ask() },
        null,
        { title: "Save", keys: keyText("save"), disabled: !isOpen, run: () => void files.save() },
        { title: "Save as…", keys: keyText("save-as"), disabled: !isOpen, run: () => void files.save(true) },
        { title: "Recover…", run: () => files.show("recover") },
      ]}
    >
      <span>File</span>
    </Menu>
  );
}

/** Taking the graph elsewhere: as a link, as a command, as a model. */
export function ShareMenus(): ReactElement {
  const session = useCurrentSession();
  const files = filesOf(session);
  const isOpen = useCurrent((state) => state.document !== null);
  return (
    <>
      <Menu
        label="Share"
        align="right"
        items={[
          { title: "Link to this graph…", disabled: !isOpen, run: () => void files.share() },
          null,
          {
            title: "Copy as curl",
            disabled: !isOpen,
            run: () => void files.copy(files.curl(), "a curl command"),
          },
          {
            title: "Copy as dini eval",
            disabled: !isOpen,
            run: () => void files.copy(commandLineText(session), "a command"),
          },
        ]}
      >
        <span>Share</span>
      </Menu>
      <button
        type="button"
        className="button export-button"
        disabled={!isOpen}
        aria-label="Export"
        onClick={() => files.show("model-file")}
      >
        <Icon name="download" />
        <span className="wide-only">Export…</span>
      </button>
    </>
  );
}
