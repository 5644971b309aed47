// Checks that no vertex which draco3d decodes is farther from its original than the position error that was announced, and
// that every original has one, for NAME.glb and NAME.made_of.json in a directory.
//   node check_errors.mjs DIRECTORY COUNT

import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { openPrimitives } from './decode_glb.mjs';

const draco3d = await import('draco3d').catch(() => {
  console.error('The node packages are missing. Install them with: npm ci --prefix tests/gltf/tools');
  process.exit(1);
});
const draco = await draco3d.default.createDecoderModule({});
const [directory, count] = process.argv.slice(2);
const names = readdirSync(directory).filter((name) => name.endsWith('.glb'));
let failures = 0;
let nearest = 0;
for (const name of names) {
  const problems = [];
  const file = join(directory, name);
  const made = JSON.parse(readFileSync(file.replace(/\.glb$/, '.made_of.json')));
  const decoded = openPrimitives(readFileSync(file), draco, problems).flatMap((part) => part.positions);
  const off = Math.max(farthest(decoded, made.positions), farthest(made.positions, decoded));
  if (!(off <= made.position_error)) problems.push(`a vertex is off by ${off}, ${made.position_error} was announced`);
  nearest = Math.max(nearest, off / made.position_error);
  for (const problem of problems) console.error(`${name}: ${problem}`);
  failures += problems.length;
}
if (names.length !== Number(count)) failures += 1;
// An error that is never come near to would be no bound worth telling.
if (!(nearest > 0.5)) failures += 1;
console.log(`${names.length} surfaces, ${failures} failures, ${nearest} of the announced error at most`);
process.exit(failures ? 1 : 0);

// How far, along any axis, a point of one list is from the nearest one of the other, at most.
function farthest(points, others) {
  let most = 0;
  for (let i = 0; i < points.length; i += 3) {
    let least = Infinity;
    for (let k = 0; k < others.length && least > most; k += 3) {
      const off = Math.max(
        Math.abs(points[i] - others[k]),
        Math.abs(points[i + 1] - others[k + 1]),
        Math.abs(points[i + 2] - others[k + 2]),
      );
      least = Math.min(least, off);
    }
    most = Math.max(most, least);
  }
  return most;
}
