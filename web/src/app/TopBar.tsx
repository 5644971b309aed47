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
}

export function TopBar({ theme, onTheme, galleryOpen, onGallery }: TopBarProps): ReactElement {
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
      <IconButton
        label={`Use the ${other} theme`}
        icon={theme === "dark" ? "sun" : "moon"}
        onClick={() => onTheme(other)}
      />
    </header>
  );
}
