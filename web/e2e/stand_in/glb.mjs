// Draco-compressed GLBs, as the server makes them: Z up turned into Y up at the root node.

import draco3d from "draco3d";
import { normalsOf } from "./geometry.mjs";

const modulePromise = draco3d.createEncoderModule({});

function encode(draco, mesh) {
  const encoder = new draco.Encoder();
  const builder = new draco.MeshBuilder();
  const target = new draco.Mesh();
  const vertices = mesh.positions.length / 3;
  builder.AddFacesToMesh(target, mesh.indices.length / 3, new Uint32Array(mesh.indices));
  const attributes = {
    POSITION: builder.AddFloatAttribute(target, draco.POSITION, vertices, 3, new Float32Array(mesh.positions)),
    NORMAL: builder.AddFloatAttribute(target, draco.NORMAL, vertices, 3, new Float32Array(normalsOf(mesh))),
    TEXCOORD_0: builder.AddFloatAttribute(target, draco.TEX_COORD, vertices, 2, new Float32Array(mesh.uvs)),
  };
  encoder.SetSpeedOptions(7, 7);
  encoder.SetAttributeQuantization(draco.POSITION, 14);
  encoder.SetAttributeQuantization(draco.NORMAL, 10);
  encoder.SetAttributeQuantization(draco.TEX_COORD, 12);
  const output = new draco.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(target, output);
  const bytes = Buffer.alloc(length);
  for (let i = 0; i < length; i++) bytes[i] = output.GetValue(i);
  for (const object of [output, target, builder, encoder]) draco.destroy(object);
  return { bytes, attributes, vertices, indices: mesh.indices.length };
}

function colorOf(color) {
  if (Array.isArray(color)) return [...color.map((x) => Math.min(1, Math.max(0, x)) ** 2.2), 1];
  if (typeof color !== "string") return undefined;
  return [...[1, 3, 5].map((at) => (parseInt(color.slice(at, at + 2), 16) / 255) ** 2.2), 1];
}

/** The file and its counts. */
export async function makeGlb(meshes, extras) {
  const draco = await modulePromise;
  const gltf = {
    asset: { version: "2.0", generator: "stand-in", extras },
    extensionsUsed: ["KHR_draco_mesh_compression"],
    extensionsRequired: ["KHR_draco_mesh_compression"],
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2], children: [] }],
    meshes: [],
    materials: [],
    accessors: [],
    bufferViews: [],
    buffers: [],
  };
  const chunks = [];
  let [offset, vertices, triangles] = [0, 0, 0];
  for (const mesh of meshes) {
    const part = encode(draco, mesh);
    const padded = Buffer.concat([part.bytes, Buffer.alloc((4 - (part.bytes.length % 4)) % 4)]);
    const view = gltf.bufferViews.push({ buffer: 0, byteOffset: offset, byteLength: part.bytes.length }) - 1;
    offset += padded.length;
    chunks.push(padded);
    const bounds = [0, 1, 2].map((k) => mesh.positions.filter((_, i) => i % 3 === k));
    const accessor = (type, count, componentType, more = {}) =>
      gltf.accessors.push({ type, count, componentType, ...more }) - 1;
    const factor = colorOf(mesh.color);
    gltf.materials.push({
      doubleSided: true,
      pbrMetallicRoughness: { ...(factor ? { baseColorFactor: factor } : {}), metallicFactor: 0 },
    });
    gltf.meshes.push({
      primitives: [
        {
          attributes: {
            POSITION: accessor("VEC3", part.vertices, 5126, {
              min: bounds.map((list) => list.reduce((a, b) => Math.min(a, b))),
              max: bounds.map((list) => list.reduce((a, b) => Math.max(a, b))),
            }),
            NORMAL: accessor("VEC3", part.vertices, 5126),
            TEXCOORD_0: accessor("VEC2", part.vertices, 5126),
          },
          indices: accessor("SCALAR", part.indices, 5125),
          material: gltf.materials.length - 1,
          extensions: { KHR_draco_mesh_compression: { bufferView: view, attributes: part.attributes } },
        },
      ],
    });
    gltf.nodes[0].children.push(gltf.nodes.push({ mesh: gltf.meshes.length - 1 }) - 1);
    vertices += part.vertices;
    triangles += part.indices / 3;
  }
  gltf.buffers.push({ byteLength: offset });
  const json = Buffer.from(JSON.stringify(gltf));
  const text = Buffer.concat([json, Buffer.alloc((4 - (json.length % 4)) % 4, 0x20)]);
  const head = Buffer.alloc(12);
  head.write("glTF", 0);
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + 8 + text.length + 8 + offset, 8);
  const chunkHead = (length, type) => {
    const buffer = Buffer.alloc(8);
    buffer.writeUInt32LE(length, 0);
    buffer.writeUInt32LE(type, 4);
    return buffer;
  };
  const bytes = Buffer.concat([
    head,
    chunkHead(text.length, 0x4e4f534a),
    text,
    chunkHead(offset, 0x004e4942),
    ...chunks,
  ]);
  return { bytes, vertices, triangles };
}
