import type { ReactElement } from "react";
import { useCurrent, useCurrentSession } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { DropMenu } from "../widgets/Menu";
import { filesOf } from "./Files";

/** Opening, saving and recovering. */
export function FileMenu(): ReactElement {
  const session = useCurrentSession();
  const files = filesOf(session);
  const isOpen = useCurrent((state) => state.document !== null);
  return (
    <DropMenu
      label="File"
      items={[
        { title: "New", run: () => session.newDocument() },
        { title: "Open…", shortcut: "open-file", run: () => void files.ask() },
        { title: "Open from the server…", run: () => files.show("open-stored") },
        { title: "Save", shortcut: "save", isDisabled: !isOpen, isNewGroup: true, run: () => void files.save() },
        { title: "Save as…", shortcut: "save-as", isDisabled: !isOpen, run: () => void files.save(true) },
        { title: "Save to the server…", isDisabled: !isOpen, run: () => void files.stored.keep() },
        { title: "Recover…", isNewGroup: true, run: () => files.show("recover") },
      ]}
    >
      <span>File</span>
    </DropMenu>
  );
}

/** Taking the graph elsewhere: as a link, as a command, as a model. */
export function ShareMenus(): ReactElement {
  const files = filesOf(useCurrentSession());
  const isOpen = useCurrent((state) => state.document !== null);
  return (
    <>
      <DropMenu
        label="Share"
        align="end"
        items={[
          { title: "Link to this graph…", isDisabled: !isOpen, run: () => void files.share() },
          {
            title: "Copy as curl",
            isDisabled: !isOpen,
            isNewGroup: true,
            run: () => void files.copy(files.curl(), "a curl command"),
          },
          {
            title: "Copy as dini eval",
            isDisabled: !isOpen,
            run: () => void files.copy(files.commandLine(), "a command"),
          },
        ]}
      >
        <Icon name="share" />
        <span className="wide-only">Share</span>
      </DropMenu>
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
