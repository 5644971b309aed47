// GLB bytes to a scene of the page's look.

import { type BufferGeometry, type Group, Line, Mesh, type Object3D, Points } from "three";
import { DRACOLoader } from "three/examples/jsm/loaders/DRACOLoader.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { dress } from "./dress";
import type { Materials } from "./materials";

/** A model ready to be drawn. */
export interface DecodedModel {
  scene: Group;
  meshes: Mesh[];
  triangles: number;
  vertices: number;
  decodeMilliseconds: number;
  dispose(): void;
}

const LONGEST_MILLISECONDS = 10_000;
// A blocked WebAssembly decoder never answers and says nothing, so silence has to be an error of our own.
const SILENT = "The mesh decoder did not answer within 10 seconds. Its files or WebAssembly may be blocked.";

export class Decoder {
  private readonly draco = new DRACOLoader();
  private readonly loader = new GLTFLoader();

  constructor(private readonly materials: Materials) {
    this.draco.setDecoderPath(new URL("../draco/", import.meta.url).href);
    // One answer comes after the other; a second worker would only wait.
    this.draco.setWorkerLimit(1);
    this.draco.preload();
    this.loader.setDRACOLoader(this.draco);
  }

  /** Decodes a GLB. Rejects with a readable message if it cannot be read or takes longer than ten seconds. */
  async decode(bytes: Uint8Array<ArrayBuffer>): Promise<DecodedModel> {
    const started = performance.now();
    const { scene } = await inTime(this.loader.parseAsync(bytes.slice().buffer, ""));
    // The root of a file scales from the unit of the document to meters; the view counts as the document does.
    for (const root of scene.children) root.scale.setScalar(1);
    const model = { scene, meshes: [] as Mesh[], triangles: 0, vertices: 0, dispose: () => freeGeometries(scene) };
    scene.traverse((object) => {
      if (!isDrawn(object)) return;
      dress(object, this.materials);
      const { geometry } = object;
      const position = geometry.getAttribute("position");
      if (!position) throw new Error("A part of the model has no positions.");
      model.vertices += position.count;
      if (!(object instanceof Mesh)) return;
      model.meshes.push(object);
      model.triangles += (geometry.getIndex() ?? position).count / 3;
    });
    return { ...model, decodeMilliseconds: performance.now() - started };
  }

  dispose(): void {
    this.draco.dispose();
  }
}

/** Frees the GPU memory of everything below `root`; materials are shared and stay (materials.ts). */
export function freeGeometries(root: Object3D): void {
  root.traverse((object) => (object as Mesh).geometry?.dispose());
}

function isDrawn(object: Object3D): object is Mesh<BufferGeometry> | Line<BufferGeometry> | Points<BufferGeometry> {
  return object instanceof Mesh || object instanceof Line || object instanceof Points;
}

async function inTime<Value>(work: Promise<Value>): Promise<Value> {
  let timer = 0;
  const late = new Promise<never>((_, reject) => {
    timer = window.setTimeout(() => reject(new Error(SILENT)), LONGEST_MILLISECONDS);
  });
  try {
    return await Promise.race([
      work.catch((error: unknown) => {
        const reason = error instanceof Error ? error.message.replace(/^THREE\.\w+: /, "") : "it is broken";
        throw new Error(`The model cannot be read: ${reason}`);
      }),
      late,
    ]);
  } finally {
    window.clearTimeout(timer);
  }
}
