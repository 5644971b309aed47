import type { CSSProperties, ReactElement } from "react";
import { wireType } from "../model/catalogue";
import { useCurrent } from "./context";

/** The sign of a wire type. */
export function Mark({ type }: { type: string | undefined }): ReactElement {
  const look = useCurrent((state) => (state.catalogue ? wireType(state.catalogue, type) : undefined));
  return (
    <span
      className="mark"
      aria-hidden="true"
      data-shape={look?.shape}
      style={{ "--socket": look?.color } as CSSProperties}
    />
  );
}
