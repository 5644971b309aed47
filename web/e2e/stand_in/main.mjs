// node e2e/stand_in/main.mjs [--port N] [--port-file F] [--delay MS]

import { writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { startStandIn } from "./server.mjs";

const option = (name) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? undefined : process.argv[at + 1];
};

const web = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../dist");
const wait = Number(option("delay") ?? 0);
const server = await startStandIn({ port: Number(option("port") ?? 8080), web, delay: () => wait });
const { port } = server.address();
if (option("port-file")) writeFileSync(option("port-file"), String(port));
console.log(`http://127.0.0.1:${port}`);
process.on("SIGTERM", () => process.exit(0));
