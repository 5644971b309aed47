// Runs before the first paint: a remembered theme must not flash in after the other one.

import { applyTheme, rememberedTheme } from "./theme";

applyTheme(rememberedTheme());
