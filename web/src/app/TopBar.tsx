import type { ReactElement } from "react";
import { FileMenu, ShareMenus } from "../files/FileMenus";
import { EditButtons } from "./EditButtons";
import { TitleField } from "./TitleField";
import { useCurrentSession, useEditor } from "./context";
import { Icon, Logo } from "./icons";
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
      <button
        type="button"
        className="button"
        title="Begin an empty graph"
        aria-label="New graph"
        onClick={() => session.newDocument()}
      >
        <Icon name="file" />
        <span className="wide-only">New</span>
      </button>
      <span className="rule" />
      <TitleField />
      <span className="rule" />
      <EditButtons />
      <span className="spacer" />
      <ShareMenus />
      <span className="rule" />
      <button
        type="button"
        className="button icon-button"
        aria-label="Keys and pointer"
        title="Keys and pointer (?)"
        onClick={() => editor.store.set({ help: true })}
      >
        <span aria-hidden="true">?</span>
      </button>
      <button
        type="button"
        className="button icon-button"
        aria-label={`Use the ${other} theme`}
        title={`Use the ${other} theme`}
        onClick={() => onTheme(other)}
      >
        <Icon name={theme === "dark" ? "sun" : "moon"} />
      </button>
    </header>
  );
}
