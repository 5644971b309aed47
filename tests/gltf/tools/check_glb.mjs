// Checks GLB files: the Khronos validator finds nothing, and every primitive, decoded by draco3d (not by the library that
// wrote it), agrees with its accessors. Prints one line of JSON facts per file; exits with 1 if anything is wrong.
//   node check_glb.mjs [--dump OUT.json] FILE_OR_DIRECTORY...
// A file NAME.expected.json beside NAME.glb is compared number by number with what draco3d decodes.

import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPrimitives } from './decode_glb.mjs';

const imports = await Promise.all([import('gltf-validator'), import('draco3d')]).catch(() => {
  console.error('The node packages are missing. Install them with: npm ci --prefix tests/gltf/tools');
  process.exit(1);
});
const [validator, draco3d] = imports.map((module) => module.default);
const draco = await draco3d.createDecoderModule({});

const { files, dump } = readArguments(process.argv.slice(2));
let failures = 0;
const dumped = {};
for (const file of files) {
  const problems = [];
  const parts = await check(file, readFileSync(file), problems).catch((error) => {
    problems.push(error.stack);
    return [];
  });
  console.log(JSON.stringify({ file, ...facts(parts) }));
  for (const problem of problems) console.error(`${file}: ${problem}`);
  failures += problems.length;
  dumped[file] = parts;
}
if (dump) writeFileSync(dump, JSON.stringify(dumped));
process.exit(failures ? 1 : 0);

function readArguments(words) {
  const files = [];
  let dump;
  while (words.length) {
    const word = words.shift();
    if (word === '--dump') {
      dump = words.shift();
    } else if (statSync(word).isDirectory()) {
      files.push(...readdirSync(word).filter((name) => name.endsWith('.glb')).sort().map((name) => join(word, name)));
    } else {
      files.push(word);
    }
  }
  if (files.length) return { files, dump };
  console.error('usage: node check_glb.mjs [--dump OUT.json] FILE_OR_DIRECTORY...');
  process.exit(2);
}

async function check(file, bytes, problems) {
  const report = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 0, writeTimestamp: false });
  for (const { severity, code, message, pointer } of report.issues.messages) {
    if (severity <= 1) problems.push(`validator: ${code} at ${pointer}: ${message}`);
  }
  const parts = openPrimitives(bytes, draco, problems);
  const expected = file.replace(/\.glb$/, '.expected.json');
  if (existsSync(expected)) compare(JSON.parse(readFileSync(expected)), parts, problems);
  return parts;
}

function compare(expected, parts, problems) {
  const actual = facts(parts);
  for (const name of ['vertices', 'triangles']) {
    if (actual[name] !== expected[name]) problems.push(`${actual[name]} ${name}, expected ${expected[name]}`);
  }
  expected.parts.forEach((part, index) => {
    if (parts[index]?.name !== part.name) problems.push(`part ${index} is ${parts[index]?.name}, expected ${part.name}`);
    for (const name of ['positions', 'normals', 'indices'].filter((key) => key in part)) {
      const values = parts[index]?.[name] ?? [];
      const same = values.length === part[name].length && part[name].every((value, i) => value === values[i]);
      if (!same) problems.push(`part ${part.name}: ${name} differ from the expected ones`);
    }
  });
}

function facts(parts) {
  const result = { parts: parts.length, primitives: 0, triangles: 0, vertices: 0, min: null, max: null };
  for (const part of parts) {
    result.primitives += part.primitives;
    result.triangles += part.triangles;
    result.vertices += part.positions.length / 3;
    for (let i = 0; i < part.positions.length; i += 3) {
      const point = part.positions.slice(i, i + 3);
      result.min = point.map((value, axis) => Math.min(value, result.min?.[axis] ?? Infinity));
      result.max = point.map((value, axis) => Math.max(value, result.max?.[axis] ?? -Infinity));
    }
  }
  return result;
}
