// A Redis, workers and servers around it, for scripts that try them.
import { spawn } from "node:child_process";
import { mkdirSync } from "node:fs";
import { connect, createServer } from "node:net";
import { join } from "node:path";
import { pause, program, until } from "./server.mjs";

const freePort = () =>
  new Promise((resolve) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });

const isListening = (port) =>
  new Promise((resolve) => {
    const socket = connect(port, "127.0.0.1");
    let told = "";
    socket.setTimeout(1000, () => socket.destroy());
    socket.on("connect", () => socket.write("PING\r\n"));
    socket.on("data", (bytes) => {
      told += bytes;
      socket.destroy();
    });
    socket.on("error", () => {});
    socket.on("close", () => resolve(told.startsWith("+PONG")));
  });

/** A Redis that keeps what it is told in a folder (appendfsync everysec), to be killed and started again. */
export class Redis {
  static async start(folder) {
    const redis = new Redis();
    redis.folder = folder;
    redis.port = await freePort();
    mkdirSync(folder, { recursive: true });
    await redis.start();
    return redis;
  }

  get url() {
    return `redis://127.0.0.1:${this.port}`;
  }

  async start() {
    const words = ["--port", String(this.port), "--bind", "127.0.0.1", "--dir", this.folder, "--save", "", "--appendonly", "yes", "--appendfsync", "everysec"];
    this.child = spawn("redis-server", words, { stdio: "ignore" });
    this.ended = new Promise((resolve) => this.child.on("exit", resolve));
    await until("Redis answers", () => isListening(this.port));
  }

  async kill() {
    this.child.kill("SIGKILL");
    await this.ended;
  }

  async restart(milliseconds) {
    await this.kill();
    await pause(milliseconds);
    await this.start();
  }
}

/** `dini worker` with one thread, unless `words` say otherwise. */
export function startWorker(redis, words = ["--threads", "1"]) {
  const child = spawn(program, ["worker", "--queue", redis.url, ...words], { stdio: ["ignore", "ignore", "ignore"] });
  const worker = { child, isGone: false, kill: (signal = "SIGKILL") => child.kill(signal) };
  worker.ended = new Promise((resolve) =>
    child.on("exit", (code, signal) => {
      worker.isGone = true;
      resolve({ code, signal });
    }),
  );
  return worker;
}

/** The numbers of `GET /metrics` without labels, by name. */
export function numbers(text) {
  const found = {};
  for (const [, name, value] of text.matchAll(/^(\w+) ([-+.\deE]+)$/gm)) found[name] = Number(value);
  return found;
}
