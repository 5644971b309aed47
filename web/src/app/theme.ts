// Dark or light: follows the system until a person chooses, then the choice is remembered.

import { recall, remember } from "../session/remembered";

export type Theme = "dark" | "light";

const KEY = "dini.theme";
const LIGHT = "(prefers-color-scheme: light)";

export function rememberedTheme(): Theme | null {
  const theme = recall(KEY);
  return theme === "dark" || theme === "light" ? theme : null;
}

export function systemTheme(): Theme {
  return matchMedia(LIGHT).matches ? "light" : "dark";
}

export function applyTheme(theme: Theme | null): void {
  document.documentElement.dataset["theme"] = theme ?? systemTheme();
}

/** Remembers a choice; the system's own theme is remembered as "follow the system". */
export function rememberTheme(theme: Theme): void {
  remember(KEY, theme === systemTheme() ? null : theme);
}

export function onSystemTheme(listener: () => void): () => void {
  const query = matchMedia(LIGHT);
  query.addEventListener("change", listener);
  return () => query.removeEventListener("change", listener);
}
