import type { ReactElement, ReactNode } from "react";
import { Icon } from "../app/icons";
import type { StandardView } from "./rig";
import { ToolIcon } from "./ToolIcon";
import { MODES, type ViewChoice } from "./view_settings";

const STANDARD: readonly { id: StandardView; title: string; hint: string }[] = [
  { id: "front", title: "Front", hint: "From the front, along Y (1)" },
  { id: "right", title: "Right", hint: "From the right, along X (3)" },
  { id: "top", title: "Top", hint: "From above, along Z (7)" },
  { id: "iso", title: "Iso", hint: "From a corner" },
];

export interface ViewActions {
  frame(): void;
  home(): void;
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
      <div className="segments" role="radiogroup" aria-label="Shading">
        {MODES.map((item) => (
          <button
            key={item.id}
            type="button"
            role="radio"
            aria-checked={settings.mode === item.id}
            title={item.hint}
            onClick={() => set({ mode: item.id })}
          >
            {item.title}
          </button>
        ))}
      </div>
      <div className="segments" role="group" aria-label="View">
        <Toggle title="Grid" on={settings.grid} onChange={(grid) => set({ grid })}>
          <Icon name="grid" />
        </Toggle>
        <Toggle title="Axes" on={settings.axes} onChange={(axes) => set({ axes })}>
          <Icon name="axes" />
        </Toggle>
        <Toggle title="Control geometry" on={settings.control} onChange={(control) => set({ control })}>
          <ToolIcon name="control" />
        </Toggle>
        <Toggle title="Section" on={settings.section !== null} onChange={onSection}>
          <ToolIcon name="section" />
        </Toggle>
        <Action title="Frame" hint="Fill the view with the selection, or the model (F)" onClick={actions.frame}>
          <Icon name="frame" />
        </Action>
        <Action title="Home view" hint="Opening view (Home)" onClick={actions.home}>
          <Icon name="home" />
        </Action>
        <Action title="Save a picture" hint="Save a picture (PNG)" onClick={actions.screenshot}>
          <ToolIcon name="camera" />
        </Action>
        <Action
          title={showing ? "Leave the show" : "Show"}
          hint={showing ? "Back to the editor (Esc)" : "The model and its controls, nothing else"}
          onClick={actions.show}
        >
          <ToolIcon name={showing ? "leave" : "show"} />
        </Action>
      </div>
    </div>
  );
}

/** The standard views, and perspective. */
export function StandardViews({ choice, actions }: Pick<ViewToolsProps, "choice" | "actions">): ReactElement {
  const { settings, set } = choice;
  return (
    <div className="segments" role="group" aria-label="Standard views">
      {STANDARD.map(({ id, title, hint }) => (
        <button key={id} type="button" title={hint} onClick={() => actions.view(id)}>
          {title}
        </button>
      ))}
      <Toggle
        title="Orthographic"
        hint="Without perspective (5)"
        on={settings.orthographic}
        onChange={(orthographic) => set({ orthographic })}
      >
        <ToolIcon name="perspective" />
      </Toggle>
    </div>
  );
}

interface ToggleProps {
  title: string;
  hint?: string;
  on: boolean;
  onChange(on: boolean): void;
  children: ReactNode;
}

function Toggle({ title, hint, on, onChange, children }: ToggleProps): ReactElement {
  return (
    <button type="button" aria-pressed={on} aria-label={title} title={hint ?? title} onClick={() => onChange(!on)}>
      {children}
    </button>
  );
}

interface ActionProps {
  title: string;
  hint: string;
  onClick(): void;
  children: ReactNode;
}

function Action({ title, hint, onClick, children }: ActionProps): ReactElement {
  return (
    <button type="button" aria-label={title} title={hint} onClick={onClick}>
      {children}
    </button>
  );
}
