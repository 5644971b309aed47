// Runs Debian's nginx with docker/nginx.conf, at other addresses and in a folder of its own.
import { spawn } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { ask, root, until } from "./server.mjs";

/** A port that nobody has just now. */
export function freePort() {
  return new Promise((resolve, reject) => {
    const taken = createServer();
    taken.on("error", reject);
    taken.listen(0, "127.0.0.1", () => {
      const { port } = taken.address();
      taken.close(() => resolve(port));
    });
  });
}

/** The shipped configuration with `changes` of its text, each of which must be found in it. */
function configuration(changes) {
  let text = readFileSync(join(root, "docker/nginx.conf"), "utf8");
  for (const [shipped, here] of changes) {
    if (!text.includes(shipped)) throw new Error(`docker/nginx.conf has no '${shipped}' any more`);
    text = text.replaceAll(shipped, here);
  }
  return text;
}

/** nginx before a keeper and an evaluator, once it listens. */
export async function startProxy(folder, { keeper, evaluator, token }) {
  const own = join(folder, "nginx");
  mkdirSync(own, { recursive: true });
  const port = await freePort();
  const file = join(own, "nginx.conf");
  const log = join(own, "access.log");
  const text = configuration([
    ["server keeper:8080", `server 127.0.0.1:${keeper}`],
    ["server evaluator:8080", `server 127.0.0.1:${evaluator}`],
    ["listen 8080", `listen 127.0.0.1:${port}`],
    ["/tmp/nginx/", `${own}/`],
    ["/dev/stdout", log],
  ]);
  writeFileSync(file, text);
  writeFileSync(join(own, "token.conf"), `proxy_set_header Authorization "Bearer ${token}";\n`);
  // As root its workers would be somebody else, who may not write into this folder.
  const user = process.getuid() === 0 ? " user root;" : "";
  const child = spawn("/usr/sbin/nginx", ["-e", "stderr", "-c", file, "-g", `daemon off;${user}`], { stdio: ["ignore", "ignore", "pipe"] });
  let said = "";
  child.stderr.on("data", (bytes) => (said += bytes));
  const ended = new Promise((resolve) => child.on("exit", resolve));
  await until("nginx answers", async () => {
    if (child.exitCode !== null) throw new Error(`nginx did not start: ${said}`);
    return (await ask(port, { path: "/healthz" })).status === 200;
  });
  return { port, said: () => said, log: () => readFileSync(log, "utf8"), kill: () => child.kill("SIGTERM"), ended };
}
