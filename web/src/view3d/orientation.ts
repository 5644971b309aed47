// Which side of a model's surfaces is the outer one. For an open surface the front is chance; what a section shows of it
// should not be.

import { type BufferGeometry, Vector3 } from "three";

const MOST_SAMPLES = 4000;

/** True if the normals of surfaces point, on the whole, towards their own middles. */
export function pointsInward(geometries: readonly BufferGeometry[]): boolean {
  let sum = 0;
  for (const geometry of geometries) {
    const [position, normal] = [geometry.getAttribute("position"), geometry.getAttribute("normal")];
    const stride = Math.max(1, Math.ceil(position.count / MOST_SAMPLES));
    const middle = new Vector3();
    const [place, direction] = [new Vector3(), new Vector3()];
    let count = 0;
    for (let at = 0; at < position.count; at += stride, count++) middle.add(place.fromBufferAttribute(position, at));
    middle.divideScalar(Math.max(1, count));
    for (let at = 0; at < position.count; at += stride) {
      place.fromBufferAttribute(position, at).sub(middle);
      sum += stride * place.dot(direction.fromBufferAttribute(normal, at));
    }
  }
  return sum < 0;
}
