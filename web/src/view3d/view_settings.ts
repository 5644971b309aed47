// What a person has chosen for the view. All but the section is remembered.

import { useState } from "react";
import { useRemembered } from "../widgets/hooks";
import type { ShadingMode } from "./model_look";
import type { Section } from "./section";
import type { ViewSettings } from "./viewer_settings";

export const MODES: readonly { id: ShadingMode; title: string; hint: string }[] = [
  { id: "shaded", title: "Shaded", hint: "Surfaces" },
  { id: "shaded-wire", title: "Lines", hint: "Surfaces with the lines of their parameters" },
  { id: "wire", title: "Wire", hint: "The lines of the parameters only" },
  { id: "normals", title: "Normals", hint: "Directions as colors" },
  { id: "by-curvature", title: "Curvature", hint: "Curvature as colors, with a legend" },
];

export interface ViewChoice {
  settings: ViewSettings;
  set(change: Partial<ViewSettings>): void;
}

/** The choices and the way to change them. */
export function useViewSettings(light: boolean, picture: boolean): ViewChoice {
  const [mode, setMode] = useRemembered("dini.view.mode", "shaded");
  const [curvature, setCurvature] = useRemembered("dini.view.curvature", "gauss");
  const [grid, setGrid] = useRemembered("dini.view.grid", "on");
  const [axes, setAxes] = useRemembered("dini.view.axes", "on");
  const [control, setControl] = useRemembered("dini.view.control", "on");
  const [projection, setProjection] = useRemembered("dini.view.projection", "perspective");
  const [section, setSection] = useState<Section | null>(null);
  const plain = { mode: "shaded", curvatureKind: "gauss", grid: false, axes: false, control: false } as const;
  const settings: ViewSettings = picture
    ? { ...plain, light, orthographic: false, section: null }
    : {
        mode: MODES.find((item) => item.id === mode)?.id ?? "shaded",
        curvatureKind: curvature === "mean" ? "mean" : "gauss",
        light,
        grid: grid === "on",
        axes: axes === "on",
        control: control === "on",
        orthographic: projection === "orthographic",
        section,
      };
  const onOff = (on: boolean): string => (on ? "on" : "off");
  return {
    settings,
    set(change) {
      if (change.mode) setMode(change.mode);
      if (change.curvatureKind) setCurvature(change.curvatureKind);
      if (change.grid !== undefined) setGrid(onOff(change.grid));
      if (change.axes !== undefined) setAxes(onOff(change.axes));
      if (change.control !== undefined) setControl(onOff(change.control));
      if (change.orthographic !== undefined) setProjection(change.orthographic ? "orthographic" : "perspective");
      if (change.section !== undefined) setSection(change.section);
    },
  };
}
