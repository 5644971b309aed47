// Turning and zooming with the keyboard.

import { Vector3 } from "three";

const TURN = 0.12;
const ZOOM = 0.85;
const POLE_MARGIN = 0.05;

const TURNS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-TURN, 0],
  ArrowRight: [TURN, 0],
  ArrowUp: [0, -TURN],
  ArrowDown: [0, TURN],
};

const ZOOMS: Readonly<Record<string, number>> = { "+": ZOOM, "=": ZOOM, "-": 1 / ZOOM };

/** Moves `offset`, from the target to the camera, as the pressed key says. False if the key means nothing here. */
export function turnByKey(event: KeyboardEvent, offset: Vector3, up: Vector3): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const turn = TURNS[event.key];
  const zoom = ZOOMS[event.key];
  if (zoom !== undefined) offset.multiplyScalar(zoom);
  if (turn) {
    const polar = offset.angleTo(up);
    const tilt = Math.min(Math.PI - POLE_MARGIN, Math.max(POLE_MARGIN, polar + turn[1])) - polar;
    const side = new Vector3().crossVectors(up, offset).normalize();
    offset.applyAxisAngle(side, tilt).applyAxisAngle(up, turn[0]);
  }
  return turn !== undefined || zoom !== undefined;
}
