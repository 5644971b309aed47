// GLB bytes to a scene of the page's look.

import { BufferAttribute, BufferGeometry, Group, type Mesh, type Object3D } from "three";
import type { JsonObject } from "../model/json";
import { Draco } from "./draco";
import type { DecodedPart } from "./draco_worker";
import { dress } from "./dress";
import { readGltf, type GltfNode, type GltfPrimitive } from "./gltf";
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

/** Names of glTF attributes in the scene; what is not listed is not drawn. */
const NAMES: Readonly<Record<string, string>> = {
  POSITION: "position",
  NORMAL: "normal",
  TEXCOORD_0: "uv",
  COLOR_0: "color",
  _GAUSS: "gauss",
  _MEAN: "mean",
};

export class Decoder {
  private readonly draco = new Draco();

  constructor(private readonly materials: Materials) {}

  /** Decodes a GLB. Rejects with a readable message if it cannot be read or takes longer than ten seconds. */
  async decode(bytes: Uint8Array<ArrayBuffer>): Promise<DecodedModel> {
    const started = performance.now();
    const file = readGltf(bytes);
    const compressed = allPrimitives(file.roots).flatMap(({ draco }) => (draco ? [draco] : []));
    const decoded = compressed.length > 0 ? await this.draco.decode(compressed) : [];
    const scene = new Group();
    const made: Made = { meshes: [], triangles: 0, vertices: 0, decoded };
    for (const root of file.roots) scene.add(this.object(root, made));
    const { meshes, triangles, vertices } = made;
    const decodeMilliseconds = performance.now() - started;
    return { scene, meshes, triangles, vertices, decodeMilliseconds, dispose: () => freeGeometries(scene) };
  }

  dispose(): void {
    this.draco.dispose();
  }

  private object(node: GltfNode, made: Made): Group {
    const group = new Group();
    group.name = node.name;
    group.userData = node.extras satisfies JsonObject;
    group.quaternion.fromArray(node.rotation);
    group.position.fromArray(node.translation);
    group.scale.fromArray(node.scale);
    for (const primitive of node.primitives) {
      const geometry = primitive.draco ? compressedGeometry(made.decoded.shift()) : plainGeometry(primitive);
      const object = dress(geometry, primitive, this.materials);
      made.vertices += geometry.getAttribute("position").count;
      if (primitive.mode === "triangles") {
        made.meshes.push(object as Mesh);
        made.triangles += (geometry.getIndex() ?? geometry.getAttribute("position")).count / 3;
      }
      group.add(object);
    }
    for (const child of node.children) group.add(this.object(child, made));
    return group;
  }
}

/** What grows while the nodes are walked; `decoded` shrinks in the same order. */
interface Made {
  meshes: Mesh[];
  triangles: number;
  vertices: number;
  decoded: DecodedPart[];
}

function allPrimitives(nodes: GltfNode[]): GltfPrimitive[] {
  return nodes.flatMap((node) => [...node.primitives, ...allPrimitives(node.children)]);
}

function compressedGeometry(part: DecodedPart | undefined): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const { name, size, array } of part?.attributes ?? []) {
    const target = NAMES[name];
    if (target) geometry.setAttribute(target, new BufferAttribute(array, size, !(array instanceof Float32Array)));
  }
  if (!part || !geometry.hasAttribute("position")) throw new Error("A part of the model has no positions.");
  geometry.setIndex(new BufferAttribute(part.indices, 1));
  return geometry;
}

function plainGeometry(primitive: GltfPrimitive): BufferGeometry {
  const geometry = new BufferGeometry();
  for (const [name, { array, size, normalized }] of primitive.attributes) {
    const target = NAMES[name];
    if (target) geometry.setAttribute(target, new BufferAttribute(array, size, normalized));
  }
  if (primitive.indices) geometry.setIndex(new BufferAttribute(primitive.indices, 1));
  return geometry;
}

/** Frees the GPU memory of everything below `root`; materials are shared and stay (materials.ts). */
export function freeGeometries(root: Object3D): void {
  root.traverse((object) => (object as Mesh).geometry?.dispose());
}
