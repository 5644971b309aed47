import type { ReactElement } from "react";

const PATHS = {
  section: "M2.5 8h11M4.5 8V3.5h7V8M4.5 10.2v2.3h1.6M8 12.5h.2M11.5 10.2v2.3H9.9",
  control: "M3.6 12.4 11 5M11.4 8.2V4.6H7.8M3.6 12.4m-1.6 0a1.6 1.6 0 1 0 3.2 0a1.6 1.6 0 1 0-3.2 0",
  camera: "M2.2 5h2.6l1.1-1.7h4.2L11.2 5h2.6v7.7H2.2zM8 6.7a2 2 0 1 1 0 4 2 2 0 0 1 0-4z",
  show: "M2.5 3h11v7.4h-11zM6 13.2h4M8 10.4v2.8",
  leave: "M6.2 2.5v3.7H2.5M9.8 13.5V9.8h3.7M6.2 6.2 2.8 2.8M9.8 9.8l3.4 3.4",
  perspective: "M2.5 11.5 6 6h4l3.5 5.5zM8 6v5.5M4.4 8.6h7.2",
  flip: "M8 2.5v11M5.8 5 2.6 8l3.2 3M10.2 5l3.2 3-3.2 3",
} as const;

export type ToolIconName = keyof typeof PATHS;

/** The icons of the view's tools; like the page's, they say nothing to screen readers. */
export function ToolIcon({ name }: { name: ToolIconName }): ReactElement {
  return (
    <svg className="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" focusable="false">
      <path d={PATHS[name]} />
    </svg>
  );
}
