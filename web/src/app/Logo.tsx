import type { ReactElement } from "react";

export function Logo(): ReactElement {
  return (
    <svg className="logo" viewBox="0 0 20 20" width="20" height="20" aria-hidden="true" focusable="false">
      <circle cx="10" cy="10" r="7" />
      <path d="M3.2 16.8 16.8 3.2" />
      <circle cx="10" cy="10" r="2.1" className="logo-center" />
    </svg>
  );
}
