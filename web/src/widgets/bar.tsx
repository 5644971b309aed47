import type { CSSProperties, ReactElement } from "react";

/** A bar is filled from zero, or from its end where zero lies beyond that. */
export function barStyle(value: number, zero: number): CSSProperties {
  return { "--from": Math.min(value, zero), "--to": Math.max(value, zero), "--at": value } as CSSProperties;
}

/** Where zero is, if the range crosses it. */
export function ZeroTick({ share }: { share: number }): ReactElement | null {
  return share > 0 && share < 1 ? <span className="zero-tick" style={{ "--zero": share } as CSSProperties} /> : null;
}
