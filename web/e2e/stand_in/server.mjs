// Answers the page as the server would, with canned examples. For developing and testing the page; never shipped.

import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import path from "node:path";
import { catalogue } from "./cards.mjs";
import { examples } from "./examples.mjs";
import { meshesOf } from "./geometry.mjs";
import { makeGlb } from "./glb.mjs";

const CSP =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; style-src 'self'; " +
  "img-src 'self' data: blob:; connect-src 'self'; object-src 'none'; base-uri 'none'; frame-ancestors 'none'";

const MEDIA_TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
  ".txt": "text/plain; charset=utf-8",
};

function problem(status, title, errors, blocked = []) {
  return {
    status,
    type: "application/problem+json",
    body: JSON.stringify({
      type: "about:blank",
      title,
      status,
      detail: errors[0]?.detail ?? title,
      instance: "stand-in",
      errors,
      blocked,
    }),
  };
}

/** What is wrong with the parameter values, in the server's words. */
function parameterErrors(declared, given) {
  return Object.entries(given).flatMap(([name, value]) => {
    const item = declared[name];
    const error = (code, detail) => [{ code, node: "", port: "", pointer: `/parameters/${name}`, detail, fix: [] }];
    if (!item) return error("unknown-parameter", `The graph has no parameter "${name}".`);
    if (item.type === "integer" && !Number.isInteger(value))
      return error("type-mismatch", `${item.label} takes an integer, not ${value}.`);
    if (value < item.min || value > item.max)
      return error("out-of-range", `${item.label} is ${value}; it must be from ${item.min} to ${item.max}.`);
    return [];
  });
}

async function evaluate(request, accept) {
  const example = examples.find((item) => JSON.stringify(item.graph) === JSON.stringify(request.graph));
  if (!example)
    return problem(422, "The graph is wrong", [
      {
        code: "unknown-node-type",
        node: Object.keys(request.graph?.nodes ?? {})[0] ?? "",
        port: "",
        pointer: "/graph",
        detail: "The stand-in knows only its own examples.",
      },
    ]);
  const declared = example.graph.parameters;
  const errors = parameterErrors(declared, request.parameters ?? {});
  if (errors.length > 0) return problem(422, "A value is wrong", errors);
  const defaults = Object.fromEntries(Object.entries(declared).map(([name, item]) => [name, item.default]));
  const values = { ...defaults, ...request.parameters };
  if (example.id.startsWith("fig02") && values.reach > 3.9) {
    return problem(
      422,
      "The graph could not be evaluated",
      [
        {
          code: "at-infinity",
          node: "boosted",
          port: "amount",
          pointer: "/graph/nodes/boosted/inputs/amount",
          detail: "The boost sends a point of the ring to infinity at 3.9.",
        },
      ],
      ["skin", "out"],
    );
  }
  const started = performance.now();
  const meshes = meshesOf(example.id, values, request.quality);
  const evaluated = performance.now();
  const { bytes, vertices, triangles } = await makeGlb(meshes, { parameters: values });
  const encoded = performance.now();
  if (accept.startsWith("model/gltf-binary")) return { status: 200, type: "model/gltf-binary", body: bytes };
  const ids = Object.keys(example.graph.nodes);
  const report = {
    engine: catalogue.engine,
    quality: request.quality,
    output: request.output,
    milliseconds: { prepare: 0.2, evaluate: evaluated - started, encode: encoded - evaluated },
    nodes: Object.fromEntries(
      ids.map((id, index) => {
        const card = catalogue.nodes.find((item) => item.id === example.graph.nodes[id].type);
        const outputs = Object.fromEntries(
          card.outputs.map((output) => [
            output.name,
            { type: output.types[0], axes: index > 2 ? [{ name: "k", size: 96, closed: false }] : [] },
          ]),
        );
        return [
          id,
          {
            type: card.id,
            milliseconds: index < 3 ? 0 : (evaluated - started) / ids.length,
            cached: index < 3,
            outputs,
          },
        ];
      }),
    ),
    model: {
      bytes: bytes.length,
      vertices,
      triangles,
      position_error: 1e-4,
      sha256: createHash("sha256").update(bytes).digest("hex"),
    },
    checks: [],
    warnings: [],
  };
  const boundary = "stand-in-boundary";
  const part = (name, type, data) => [
    Buffer.from(`--${boundary}\r\nContent-Disposition: form-data; name="${name}"\r\nContent-Type: ${type}\r\n\r\n`),
    Buffer.from(data),
    Buffer.from("\r\n"),
  ];
  const body = Buffer.concat([
    ...part("report", "application/json", JSON.stringify(report)),
    ...part("model", "model/gltf-binary", bytes),
    Buffer.from(`--${boundary}--\r\n`),
  ]);
  return { status: 200, type: `multipart/form-data; boundary=${boundary}`, body };
}

function file(folder, address) {
  const full = path.join(folder, path.normalize(address === "/" ? "/index.html" : address));
  const type = MEDIA_TYPES[path.extname(full)];
  if (!full.startsWith(folder) || !type || !existsSync(full)) return problem(404, "Not found", []);
  const zipped = existsSync(`${full}.gz`);
  const cache = address.startsWith("/assets/") ? "public, max-age=31536000, immutable" : "no-cache";
  return {
    status: 200,
    type,
    body: readFileSync(zipped ? `${full}.gz` : full),
    headers: { "cache-control": cache, ...(zipped ? { "content-encoding": "gzip" } : {}) },
  };
}

/** Starts the stand-in. `options.delay` is a function of the request body: milliseconds to wait before answering. */
export function startStandIn({ port = 0, web, delay = () => 0 }) {
  const json = (value) => ({ status: 200, type: "application/json", body: JSON.stringify(value) });
  const answer = async (request, body) => {
    const { pathname } = new URL(request.url, "http://localhost");
    if (pathname === "/healthz") return json({ status: "ok" });
    if (pathname === "/version") return json({ engine: catalogue.engine, limits: {} });
    if (pathname === "/v1/nodes") return json(catalogue);
    if (pathname === "/v1/examples") return json({ examples });
    if (pathname === "/v1/evaluate") {
      const parsed = JSON.parse(body);
      await new Promise((resolve) => setTimeout(resolve, delay(parsed)));
      return evaluate(parsed, request.headers.accept ?? "");
    }
    return file(web, decodeURIComponent(pathname));
  };
  const server = createServer((request, response) => {
    const chunks = [];
    request.on("data", (chunk) => chunks.push(chunk));
    request.on("end", async () => {
      const { status, type, body, headers } = await answer(request, Buffer.concat(chunks).toString()).catch((error) =>
        problem(500, String(error), []),
      );
      response.writeHead(status, {
        "content-type": type,
        "content-security-policy": CSP,
        "x-content-type-options": "nosniff",
        ...headers,
      });
      response.end(body);
    });
  });
  return new Promise((resolve) => server.listen(port, "127.0.0.1", () => resolve(server)));
}
