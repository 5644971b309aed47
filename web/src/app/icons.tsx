// 16 px icons, 1.5 px strokes. They say nothing to screen readers: the button around them has the name.

import type { ReactElement } from "react";

const PATHS = {
  gallery: "M2.5 2.5h4.5v4.5h-4.5zM9 2.5h4.5v4.5h-4.5zM2.5 9h4.5v4.5h-4.5zM9 9h4.5v4.5h-4.5z",
  download: "M8 2.5v7.5M4.8 7 8 10.2 11.2 7M2.8 13.2h10.4",
  copy: "M5.8 5.8h7.4v7.4h-7.4zM10.2 5.6V2.8H2.8v7.4h2.8",
  reset: "M3.2 3v3.4h3.4M3.5 6.2A5 5 0 1 1 3 8.6",
  moon: "M13 9.6A5.6 5.6 0 0 1 6.4 3 5.4 5.4 0 1 0 13 9.6z",
  sun: "M8 5.2a2.8 2.8 0 1 1 0 5.6 2.8 2.8 0 0 1 0-5.6zM8 1.4v1.4M8 13.2v1.4M1.4 8h1.4M13.2 8h1.4M3.3 3.3l1 1M11.7 11.7l1 1M12.7 3.3l-1 1M4.3 11.7l-1 1",
  alert: "M8 2.2 14.4 13.4H1.6zM8 6.4v3.4M8 11.4v.4",
  frame: "M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3",
  home: "M2.6 7.6 8 2.8l5.4 4.8M4.2 6.6v6.6h7.6V6.6",
  grid: "M2.5 6.2h11M2.5 9.8h11M6.2 2.5v11M9.8 2.5v11",
  axes: "M8 8.6V2.4M8 8.6l5.2 3.4M8 8.6 2.8 12",
  check: "M3 8.6 6.4 12 13 4.6",
  offline:
    "M2 2l12 12M5.2 9.6a4 4 0 0 1 2-1M10.9 9.7a4 4 0 0 0-.8-.6M2.6 6.8a8 8 0 0 1 2.2-1.5M13.4 6.8A8 8 0 0 0 7.3 4.6M8 12.4v.2",
  eye: "M1.6 8S4 3.8 8 3.8 14.4 8 14.4 8 12 12.2 8 12.2 1.6 8 1.6 8zM8 6.2a1.8 1.8 0 1 1 0 3.6 1.8 1.8 0 0 1 0-3.6z",
  plus: "M8 3v10M3 8h10",
  undo: "M6.2 3 2.8 6.2l3.4 3.2M3 6.2h6.4a3.4 3.4 0 0 1 0 6.8H6.6",
  redo: "M9.8 3l3.4 3.2-3.4 3.2M13 6.2H6.6a3.4 3.4 0 0 0 0 6.8h2.8",
  search: "M7 2.6a4.4 4.4 0 1 1 0 8.8 4.4 4.4 0 0 1 0-8.8zM10.2 10.2l3.4 3.4",
  trash: "M3 4.4h10M6.2 4.2V2.6h3.6v1.6M4.4 4.6l.6 8.8h6l.6-8.8",
  close: "M4 4l8 8M12 4l-8 8",
  layout: "M2.4 3h4v3.4h-4zM2.4 9.6h4V13h-4zM9.6 6.2h4v3.6h-4zM6.4 4.7h1.8v6.6H6.4M8.2 8h1.4",
  more: "M3.4 8v.1M8 8v.1M12.6 8v.1",
  pencil: "M3 13l.6-2.8 7.2-7.2 2.2 2.2-7.2 7.2zM9.4 4.4l2.2 2.2",
  file: "M4 2.2h5.2L12.4 5.4v8.4H4zM9 2.4v3.2h3.2",
  corner: "M13 5 5 13M13 9.5 9.5 13",
  chevron: "M4.2 6.2 8 10l3.8-3.8",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }): ReactElement {
  return (
    <svg className="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" focusable="false">
      <path d={PATHS[name]} />
    </svg>
  );
}

export function Logo(): ReactElement {
  return (
    <svg className="logo" viewBox="0 0 20 20" width="20" height="20" aria-hidden="true" focusable="false">
      <circle cx="10" cy="10" r="7" />
      <path d="M3.2 16.8 16.8 3.2" />
      <circle cx="10" cy="10" r="2.1" className="logo-center" />
    </svg>
  );
}
