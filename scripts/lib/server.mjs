// What scripts that try the real server share: starting one, and asking it.
import { spawn } from "node:child_process";
import { readFileSync, rmSync } from "node:fs";
import { request } from "node:http";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
export const program = process.env.DINI_PROGRAM ?? join(root, "build/release/dini");

/** `dini serve` with some words more, once it listens. `portFile` is a name that no other server has; `before` stands before the program. */
export async function startServer(portFile, words, { port = 0, before = [], stderr = "inherit" } = {}) {
  rmSync(portFile, { force: true });
  const line = [...before, program, "serve", "--port", String(port), "--port-file", portFile, "--log-level", "off", ...words];
  const child = spawn(line[0], line.slice(1), { stdio: ["ignore", "ignore", stderr] });
  let gone = false;
  const ended = new Promise((resolve) => child.on("exit", (code, signal) => resolve((gone = { code, signal }))));
  for (;;) {
    try {
      const number = Number(readFileSync(portFile, "utf8"));
      if (number > 0) return { port: number, child, kill: (signal = "SIGKILL") => child.kill(signal), ended, isGone: () => gone !== false };
    } catch {
      // not yet
    }
    if (gone) throw new Error(`the server did not start: ${JSON.stringify(gone)}`);
    await pause(5);
  }
}

/** One answer; status 0 where there was none. */
export function ask(port, { agent, method = "GET", path, headers = {}, body = "" }) {
  return new Promise((resolve) => {
    const lost = (error) => resolve({ status: 0, body: String(error?.code ?? "cut off"), headers: {} });
    const length = method === "GET" ? {} : { "Content-Type": "application/json", "Content-Length": Buffer.byteLength(body) };
    const all = Object.fromEntries(Object.entries({ ...length, ...headers }).filter(([, value]) => value !== undefined));
    const sent = request({ host: "127.0.0.1", port, path, method, headers: all, agent }, (answer) => {
      const pieces = [];
      answer.on("data", (bytes) => pieces.push(bytes));
      answer.on("end", () => resolve({ status: answer.statusCode, headers: answer.headers, body: Buffer.concat(pieces).toString() }));
      answer.on("error", lost);
      answer.on("aborted", lost);
    });
    sent.on("error", lost);
    sent.end(body);
  });
}

export const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

export const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Waits until something holds; an error that says what did not after half a minute. */
export async function until(what, holds) {
  const late = Date.now() + 30_000;
  while (!(await holds())) {
    if (Date.now() > late) throw new Error(`waited in vain until ${what}`);
    await pause(20);
  }
}

/** Counts checks, tells those that fail, and closes with the line that scripts/test reads. */
export class Checks {
  passed = 0;
  failed = 0;

  check(title, holds, detail = "") {
    if (holds) ++this.passed;
    else ++this.failed;
    console.log(`${holds ? "ok    " : "FAILED"}  ${title}${holds || detail === "" ? "" : `: ${detail}`}`);
    return holds;
  }

  close() {
    console.log(`${this.passed} passed, ${this.failed} failed`);
    process.exitCode = this.failed === 0 ? 0 : 1;
  }
}
