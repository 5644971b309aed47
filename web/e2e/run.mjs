// Runs the end-to-end tests with node's own test runner: npm run e2e [-- name.e2e.mjs]

import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const chosen = process.argv.slice(2);
const files = readdirSync(here).filter(
  (name) => name.endsWith(".e2e.mjs") && (chosen.length === 0 || chosen.includes(name)),
);
// One file after the other: the browser draws on the processor, and the pictures of two at once take too long.
for (const file of files) {
  const { status } = spawnSync(process.execPath, ["--test", path.join(here, file)], { stdio: "inherit" });
  if (status !== 0) process.exitCode = 1;
}
