import { useEffect, useState } from "react";
import { applyTheme, onSystemTheme, rememberedTheme, rememberTheme, systemTheme, type Theme } from "./theme";

/** The theme in use and the way to change it. */
export function useTheme(): [Theme, (theme: Theme) => void] {
  const [theme, setTheme] = useState<Theme>(rememberedTheme() ?? systemTheme());
  useEffect(() => {
    applyTheme(theme);
    return onSystemTheme(() => setTheme(rememberedTheme() ?? systemTheme()));
  }, [theme]);
  return [
    theme,
    (next) => {
      rememberTheme(next);
      setTheme(next);
    },
  ];
}
