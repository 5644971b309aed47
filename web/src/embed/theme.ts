// Runs before the first paint: dark or light as `?theme=` says, else as the system is.

const LIGHT = matchMedia("(prefers-color-scheme: light)");

function apply(): void {
  const asked = new URLSearchParams(location.search).get("theme");
  const system = LIGHT.matches ? "light" : "dark";
  document.documentElement.dataset["theme"] = asked === "light" || asked === "dark" ? asked : system;
}

LIGHT.addEventListener("change", apply);
apply();
