import type { ReactElement } from "react";
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
            run: () => void files.copy(files.commandLine(), "a command"),
          },
        ]}
      >
        <ShareIcon />
        <span className="wide-only">Share</span>
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

function ShareIcon(): ReactElement {
  return (
    <svg className="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" focusable="false">
      <path d="M8 9.5V2.6M5.2 5.2 8 2.4l2.8 2.8M4.6 7.4H3v6h10v-6h-1.6" />
    </svg>
  );
}
