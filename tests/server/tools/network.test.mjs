// The server opens no connection and starts no program, whatever addresses stand in what it is sent: every call of the
// real program to the network is looked at while it answers.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { ask, startServer } from "../../../scripts/lib/server.mjs";

const elsewhere = "http://192.0.2.1:9/model.glb"; // of a network for examples, where nobody is (RFC 5737)

/** A graph with that address wherever a text may stand. */
const graph = {
  $schema: elsewhere,
  format: 1,
  nodes: {
    mesh: { type: "import", inputs: { asset: elsewhere } },
    out: { type: "export", inputs: { model: { from: "mesh" } } },
  },
  ui: { note: elsewhere },
  meta: { title: elsewhere, author: "file:///etc/passwd" },
};
const ball = { ...graph, nodes: { ...graph.nodes, mesh: { type: "sphere_mesh", inputs: {} } } };
const names = { Origin: undefined, Referer: elsewhere, "X-Forwarded-For": "192.0.2.1", "X-Forwarded-Host": "192.0.2.1", traceparent: elsewhere };

test("the server opens no connection and starts no program", async () => {
  const folder = mkdtempSync(join(tmpdir(), "dini-network-"));
  const log = join(folder, "calls");
  const calls = "trace=socket,connect,bind,listen,sendto,sendmsg,execve,fork,vfork";
  const server = await startServer(join(folder, "port"), ["--data", join(folder, "data")], { before: ["strace", "-f", "-qq", "-e", calls, "-o", log] });
  try {
    const post = (path, body, headers = {}) => ask(server.port, { method: "POST", path, body: JSON.stringify(body), headers: { ...names, ...headers } });
    for (const path of ["/v1/evaluate", "/v1/validate", "/v1/explain", "/v1/sweeps", "/v1/jobs"]) {
      for (const one of [graph, ball, elsewhere]) {
        const { status } = await post(path, { graph: one, ...(path === "/v1/sweeps" ? { list: [{}] } : {}) });
        assert.ok(status >= 200 && status < 500, `${path} ${status}`);
      }
    }
    const kept = await ask(server.port, { method: "PUT", path: "/v1/graphs/ball", body: JSON.stringify(ball), headers: { ...names, "If-None-Match": "*" } });
    assert.equal(kept.status, 201, kept.body);
    const shown = await ask(server.port, { path: "/v1/graphs/ball/outputs/out.glb", headers: names });
    assert.equal(shown.status, 200, shown.body);
  } finally {
    const tracer = server.child.pid;
    process.kill(Number(readFileSync(`/proc/${tracer}/task/${tracer}/children`, "utf8")), "SIGTERM");
    await server.ended;
  }

  const lines = readFileSync(log, "utf8").split("\n").map((line) => line.replace(/^\d+\s+/, ""));
  const those = (name) => lines.filter((line) => line.startsWith(`${name}(`));
  rmSync(folder, { recursive: true });
  assert.ok(those("listen").length > 0);
  for (const line of those("bind")) assert.match(line, /"127\.0\.0\.1"|"::1"/);
  assert.deepEqual([...those("connect"), ...those("fork"), ...those("vfork"), ...those("sendto")], []);
  assert.deepEqual(those("socket").filter((line) => !line.includes("AF_INET")), []);
  assert.equal(those("execve").length, 1); // itself
});
