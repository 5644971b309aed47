// GLB bytes to a scene. One Draco decoder with two workers serves the page for its whole life.

import { type BufferGeometry, type Group, type Material, Mesh, type Object3D } from "three";
import { DRACOLoader } from "three/examples/jsm/loaders/DRACOLoader.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

/** A model ready to be drawn. */
export interface DecodedModel {
  scene: Group;
  triangles: number;
  vertices: number;
  decodeMilliseconds: number;
  dispose(): void;
}

const WORKERS = 2;
const LONGEST_DECODE = 10_000;

export class Decoder {
  private readonly draco = new DRACOLoader();
  private readonly loader = new GLTFLoader();

  constructor() {
    this.draco.setDecoderPath(new URL("draco/", document.baseURI).href);
    this.draco.setWorkerLimit(WORKERS);
    this.draco.preload();
    this.loader.setDRACOLoader(this.draco);
  }

  /** Decodes a GLB. Rejects with a readable message if it cannot be read or takes longer than ten seconds. */
  async decode(bytes: Uint8Array<ArrayBuffer>): Promise<DecodedModel> {
    const started = performance.now();
    let timer = 0;
    const late = new Promise<never>((_, reject) => {
      // A blocked WebAssembly decoder never answers and says nothing, so silence has to be an error of our own.
      const message = "The mesh decoder did not answer within 10 seconds. Its files or WebAssembly may be blocked.";
      timer = window.setTimeout(() => reject(new Error(message)), LONGEST_DECODE);
    });
    try {
      const file = await Promise.race([this.loader.parseAsync(bytes.buffer, ""), late]);
      const { scene } = file;
      const decodeMilliseconds = performance.now() - started;
      return { ...count(scene), scene, decodeMilliseconds, dispose: () => dispose(scene) };
    } finally {
      window.clearTimeout(timer);
    }
  }

  dispose(): void {
    this.draco.dispose();
  }
}

function count(scene: Object3D): { triangles: number; vertices: number } {
  let [triangles, vertices] = [0, 0];
  scene.traverse((object) => {
    const geometry = (object as Mesh).geometry as BufferGeometry | undefined;
    if (!geometry) return;
    const points = geometry.getAttribute("position")?.count ?? 0;
    vertices += points;
    if (object instanceof Mesh) triangles += Math.floor((geometry.getIndex()?.count ?? points) / 3);
  });
  return { triangles, vertices };
}

/** Frees GPU memory of everything below `root`; materials of meshes are shared and stay (materials.ts). */
export function dispose(root: Object3D): void {
  root.traverse((object) => {
    const drawn = object as Mesh;
    drawn.geometry?.dispose();
    if (object instanceof Mesh) return;
    const materials = (Array.isArray(drawn.material) ? drawn.material : [drawn.material]) as (Material | undefined)[];
    for (const material of materials) material?.dispose();
  });
}
