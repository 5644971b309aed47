// The page's decoding worker, run in node beside the shipped decoder.

import { readFileSync } from "node:fs";
import { dracoWorker, type DracoAnswer, type DracoRequest } from "../src/view3d/draco_worker";
import type { GltfNode, GltfPrimitive } from "../src/view3d/gltf";

const FOLDER = "node_modules/three/examples/jsm/libs/draco/gltf";

interface WorkerScope {
  onmessage?: (event: { data: unknown }) => void;
  postMessage?: (answer: DracoAnswer) => void;
}

let scope: WorkerScope | undefined;

/** Sends one request to the worker and waits for its answer. */
export async function decodeInWorker(parts: DracoRequest["parts"]): Promise<DracoAnswer> {
  scope ??= startWorker();
  const worker = scope;
  return new Promise((resolve) => {
    worker.postMessage = resolve;
    worker.onmessage?.({ data: { id: 1, parts } satisfies DracoRequest });
  });
}

export function allIn(nodes: GltfNode[]): GltfPrimitive[] {
  return nodes.flatMap((node) => [...node.primitives, ...allIn(node.children)]);
}

function startWorker(): WorkerScope {
  const self: WorkerScope = {};
  const script = readFileSync(`${FOLDER}/draco_wasm_wrapper.js`, "utf8");
  const wasm = readFileSync(`${FOLDER}/draco_decoder.wasm`);
  // As in the page, the script and the worker's own text make one program. Node's globals would make the script
  // believe that it should read files.
  const body = `${script}; (${dracoWorker.toString()})();`;
  new Function("self", "process", "require", "__filename", "__dirname", body)(self);
  self.onmessage?.({ data: wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength) });
  return self;
}
