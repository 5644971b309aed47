import type { ReactElement } from "react";
import { FileMenu, ShareMenus } from "../files/FileMenus";
import { useCurrent } from "./context";
import { Icon, Logo } from "./icons";
import type { Theme } from "./theme";

interface TopBarProps {
  theme: Theme;
  onTheme(theme: Theme): void;
  galleryOpen: boolean;
  onGallery(): void;
}

export function TopBar({ theme, onTheme, galleryOpen, onGallery }: TopBarProps): ReactElement {
  const title = useCurrent((state) => state.document?.title);
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
      <h1 className="document-title">{title ?? ""}</h1>
      <span className="spacer" />
      <ShareMenus />
      <span className="rule" />
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
