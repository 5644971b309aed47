import type { ReactElement } from "react";
import { FileMenu, ShareMenus } from "../files/FileMenus";
import { IconButton } from "../widgets/Button";
import { useCurrentSession, useEditor } from "../widgets/context";
import { Icon } from "../widgets/Icon";
import { Tip } from "../widgets/Tip";
import { EditButtons } from "./EditButtons";
import { Logo } from "./Logo";
import { TitleField } from "./TitleField";
import type { Theme } from "./theme";

interface TopBarProps {
  theme: Theme;
  onTheme(theme: Theme): void;
  galleryOpen: boolean;
  onGallery(): void;
  /** The graph takes the whole width, below the model. */
  graphBelow: boolean;
  /** Missing where the window has room for one pane only. */
  onGraphBelow?(below: boolean): void;
}

export function TopBar(props: TopBarProps): ReactElement {
  const { theme, onTheme, galleryOpen, onGallery, graphBelow, onGraphBelow } = props;
  const session = useCurrentSession();
  const editor = useEditor();
  const other = theme === "dark" ? "light" : "dark";
  return (
    <header className="top-bar">
      <span className="brand">
        <Logo />
        <span>Dini</span>
      </span>
      <span className="rule" />
      <FileMenu />
      <button type="button" className="button gallery-button" aria-expanded={galleryOpen} onClick={onGallery}>
        <Icon name="gallery" />
        <span>Examples</span>
      </button>
      <Tip text="Begin an empty graph">
        <button type="button" className="button" aria-label="New graph" onClick={() => session.newDocument()}>
          <Icon name="file" />
          <span className="wide-only">New</span>
        </button>
      </Tip>
      <span className="rule" />
      <TitleField />
      <span className="rule" />
      <EditButtons />
      <span className="spacer" />
      <ShareMenus />
      <span className="rule" />
      <IconButton
        label="Keys and pointer"
        icon="help"
        shortcut="help"
        onClick={() => editor.store.set({ help: true })}
      />
      {onGraphBelow && (
        <IconButton
          label={graphBelow ? "Graph beside the model" : "Graph below the model"}
          icon={graphBelow ? "beside" : "below"}
          onClick={() => onGraphBelow(!graphBelow)}
        />
      )}
      <IconButton
        label={`Use the ${other} theme`}
        icon={theme === "dark" ? "sun" : "moon"}
        onClick={() => onTheme(other)}
      />
    </header>
  );
}
