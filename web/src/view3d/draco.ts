// The Draco decoder: one worker for the page's whole life.

import { dracoWorker, type DecodedPart, type DracoAnswer, type DracoRequest } from "./draco_worker";

const LONGEST_DECODE = 10_000;
// A blocked WebAssembly decoder never answers and says nothing, so silence has to be an error of our own.
const SILENT = "The mesh decoder did not answer within 10 seconds. Its files or WebAssembly may be blocked.";

interface Waiting {
  resolve(parts: DecodedPart[]): void;
  reject(reason: Error): void;
  timer: number;
}

export class Draco {
  private readonly worker: Promise<Worker>;
  private readonly waiting = new Map<number, Waiting>();
  private next = 1;
  private address = "";
  private isGone = false;

  constructor() {
    this.worker = this.start();
    // Whoever decodes first hears of it.
    this.worker.catch(() => undefined);
  }

  /** Decodes compressed parts in order. Rejects with a readable message. */
  async decode(parts: DracoRequest["parts"]): Promise<DecodedPart[]> {
    const worker = await this.worker;
    return new Promise((resolve, reject) => {
      const id = this.next++;
      const timer = window.setTimeout(() => this.finish(id, (one) => one.reject(new Error(SILENT))), LONGEST_DECODE);
      this.waiting.set(id, { resolve, reject, timer });
      worker.postMessage({ id, parts } satisfies DracoRequest);
    });
  }

  dispose(): void {
    this.isGone = true;
    for (const id of [...this.waiting.keys()]) {
      this.finish(id, (one) => one.reject(new Error("The view is closed.")));
    }
    this.worker.then(
      (worker) => {
        worker.terminate();
        URL.revokeObjectURL(this.address);
      },
      () => undefined,
    );
  }

  private async start(): Promise<Worker> {
    const fetched = async (name: string): Promise<Response> => {
      const answer = await fetch(new URL(`draco/${name}`, document.baseURI));
      if (!answer.ok) throw new Error(`The mesh decoder could not be loaded (${answer.status}).`);
      return answer;
    };
    const [script, binary] = await Promise.all([
      fetched("draco_wasm_wrapper.js").then((answer) => answer.text()),
      fetched("draco_decoder.wasm").then((answer) => answer.arrayBuffer()),
    ]);
    if (this.isGone) throw new Error("The view is closed.");
    // A blob, because the page's policy allows workers of its own making only.
    const address = URL.createObjectURL(new Blob([script, `;(${dracoWorker.toString()})()`]));
    const worker = new Worker(address);
    this.address = address;
    worker.onmessage = ({ data }: MessageEvent<DracoAnswer>) => {
      this.finish(data.id, (one) =>
        "error" in data ? one.reject(new Error(`The mesh cannot be decoded: ${data.error}`)) : one.resolve(data.parts),
      );
    };
    worker.onerror = (event) => {
      event.preventDefault();
      for (const id of [...this.waiting.keys()]) {
        this.finish(id, (one) => one.reject(new Error("The mesh decoder failed.")));
      }
    };
    worker.postMessage(binary, [binary]);
    return worker;
  }

  private finish(id: number, settle: (one: Waiting) => void): void {
    const one = this.waiting.get(id);
    if (!one) return;
    this.waiting.delete(id);
    window.clearTimeout(one.timer);
    settle(one);
  }
}
