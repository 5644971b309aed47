import type { ReactElement } from "react";
import { keyText, type ShortcutId } from "../session/shortcuts";
import { IconButton } from "../widgets/Button";
import type { IconName } from "../widgets/Icon";
import { Segments } from "../widgets/Segments";
import { Tip } from "../widgets/Tip";
import type { StandardView } from "./rig";
import { MODES, type ViewChoice } from "./view_settings";

const STANDARD: readonly { id: StandardView; title: string; hint: string; shortcut?: ShortcutId }[] = [
  { id: "front", title: "Front", hint: "From the front, along Y", shortcut: "model-front" },
  { id: "right", title: "Right", hint: "From the right, along X", shortcut: "model-right" },
  { id: "top", title: "Top", hint: "From above, along Z", shortcut: "model-above" },
  { id: "iso", title: "Iso", hint: "From a corner" },
];

export interface ViewActions {
  frame(): void;
  home(): void;
  /** Makes the present view the one that the document opens with. */
  keep(): void;
  view(view: StandardView): void;
  screenshot(): void;
  show(): void;
}

interface ViewToolsProps {
  choice: ViewChoice;
  actions: ViewActions;
  showing: boolean;
  onSection(): void;
}

/** The buttons over the 3D view. */
export function ViewTools({ choice, actions, showing, onSection }: ViewToolsProps): ReactElement {
  const { settings, set } = choice;
  return (
    <div className="view-tools">
      <Segments label="Shading" options={MODES} chosen={settings.mode} onChoose={(mode) => set({ mode })} />
      <div className="segments" role="group" aria-label="View">
        <Toggle label="Grid" icon="grid" on={settings.grid} onChange={(grid) => set({ grid })} />
        <Toggle label="Axes" icon="axes" on={settings.axes} onChange={(axes) => set({ axes })} />
        <Toggle
          label="Control geometry"
          icon="control"
          hint="Control geometry: what selected and previewed nodes make"
          on={settings.control}
          onChange={(control) => set({ control })}
        />
        <Toggle label="Section" icon="section" on={settings.section !== null} onChange={onSection} />
        <IconButton
          className=""
          label="Frame"
          icon="frame"
          hint="Fill the view with the selection, or the model"
          shortcut="model-fill"
          onClick={actions.frame}
        />
        <IconButton
          className=""
          label="Home view"
          icon="home"
          hint="Opening view"
          shortcut="model-home"
          onClick={actions.home}
        />
        <IconButton
          className=""
          label="Keep this view"
          icon="keep"
          hint="Keep this view: the graph opens with it"
          onClick={actions.keep}
        />
        <IconButton
          className=""
          label="Save a picture"
          icon="camera"
          hint="Save a picture (PNG)"
          onClick={actions.screenshot}
        />
        <IconButton
          className=""
          label={showing ? "Leave the show" : "Show"}
          icon={showing ? "leave" : "show"}
          hint={showing ? "Back to the editor (Esc)" : "The model and its controls, nothing else"}
          onClick={actions.show}
        />
      </div>
    </div>
  );
}

/** The standard views, and perspective. */
export function StandardViews({ choice, actions }: Pick<ViewToolsProps, "choice" | "actions">): ReactElement {
  const { settings, set } = choice;
  return (
    <div className="segments" role="group" aria-label="Standard views">
      {STANDARD.map(({ id, title, hint, shortcut }) => (
        <Tip key={id} text={hint} keys={shortcut && keyText(shortcut)}>
          <button type="button" onClick={() => actions.view(id)}>
            {title}
          </button>
        </Tip>
      ))}
      <Toggle
        label="Orthographic"
        icon="perspective"
        hint="Without perspective"
        shortcut="model-perspective"
        on={settings.orthographic}
        onChange={(orthographic) => set({ orthographic })}
      />
    </div>
  );
}

interface ToggleProps {
  label: string;
  icon: IconName;
  hint?: string;
  shortcut?: ShortcutId;
  on: boolean;
  onChange(on: boolean): void;
}

function Toggle({ on, onChange, ...button }: ToggleProps): ReactElement {
  return <IconButton {...button} className="" pressed={on} onClick={() => onChange(!on)} />;
}
