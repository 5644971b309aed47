import { useState, type ReactElement } from "react";
import { CopyMenu } from "./CopyMenu";
import { useCurrent, useCurrentSession } from "./context";
import { downloadModel } from "./download";
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
  const title = useCurrent((state) => state.document?.title);
  const [saving, setSaving] = useState(false);
  const [failure, setFailure] = useState("");
  const download = async (): Promise<void> => {
    setSaving(true);
    setFailure(await downloadModel(session));
    setSaving(false);
  };
  const other = theme === "dark" ? "light" : "dark";
  return (
    <header className="top-bar">
      <span className="brand">
        <Logo />
        <span>Dini</span>
      </span>
      <span className="rule" />
      <button type="button" className="button gallery-button" aria-expanded={galleryOpen} onClick={onGallery}>
        <Icon name="gallery" />
        <span>Examples</span>
      </button>
      <h1 className="document-title">{title ?? ""}</h1>
      {failure && (
        <span className="top-failure" role="alert">
          {failure}
        </span>
      )}
      <span className="spacer" />
      <CopyMenu />
      <button
        type="button"
        className="button"
        disabled={!title || saving}
        aria-label="Download GLB"
        onClick={() => void download()}
      >
        <Icon name="download" />
        <span className="wide-only">{saving ? "Preparing…" : "Download .glb"}</span>
      </button>
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
