// Opens every primitive of a GLB and checks it against its accessors: counts, bounds bit for bit, finite values, unit
// normals, indices in range.

const componentArrays = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const typeWidths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const dracoExtension = 'KHR_draco_mesh_compression';

// One entry per node with a mesh: { name, primitives, triangles, positions, normals, indices }, its primitives joined.
export function openPrimitives(glb, draco, problems) {
  const { gltf, binary } = splitGlb(glb);
  const parts = [];
  for (const node of gltf.nodes.filter(({ mesh }) => mesh !== undefined)) {
    const part = { name: node.name, primitives: 0, triangles: 0, positions: [], normals: [], indices: [] };
    gltf.meshes[node.mesh].primitives.forEach((primitive, index) => {
      const complain = (text) => problems.push(`mesh ${node.mesh} primitive ${index}: ${text}`);
      const extension = primitive.extensions?.[dracoExtension];
      const open = extension ? decodeDraco : readPlain;
      const opened = open(gltf, binary, primitive, draco, complain);
      checkValues(gltf, primitive, opened, complain);
      const base = part.positions.length / 3;
      for (const value of opened.attributes.POSITION) part.positions.push(value);
      for (const value of opened.attributes.NORMAL ?? []) part.normals.push(value);
      for (const value of opened.indices ?? []) part.indices.push(base + value);
      part.primitives += 1;
      if (primitive.mode === 4) part.triangles += opened.indices.length / 3;
    });
    parts.push(part);
  }
  return parts;
}

function splitGlb(glb) {
  const jsonSize = glb.readUInt32LE(12);
  const gltf = JSON.parse(glb.subarray(20, 20 + jsonSize).toString());
  return { gltf, binary: glb.subarray(20 + jsonSize + 8) };
}

function viewBytes(gltf, binary, index) {
  const { byteOffset = 0, byteLength } = gltf.bufferViews[index];
  return binary.subarray(byteOffset, byteOffset + byteLength);
}

function decodeDraco(gltf, binary, primitive, draco, complain) {
  const { bufferView, attributes: ids } = primitive.extensions[dracoExtension];
  const bytes = viewBytes(gltf, binary, bufferView);
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  const status = decoder.DecodeArrayToMesh(new Int8Array(bytes), bytes.length, mesh);
  if (!status.ok()) throw new Error(status.error_msg());
  const attributes = {};
  for (const [name, id] of Object.entries(ids)) {
    const accessor = gltf.accessors[primitive.attributes[name]];
    const attribute = decoder.GetAttributeByUniqueId(mesh, id);
    if (attribute.num_components() !== typeWidths[accessor.type]) complain(`${name} has another width`);
    attributes[name] = copyOut(draco, accessor, mesh.num_points() * attribute.num_components(), (size, pointer) => {
      const types = { 5121: draco.DT_UINT8, 5123: draco.DT_UINT16, 5126: draco.DT_FLOAT32 };
      const type = types[accessor.componentType];
      decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type, size, pointer);
    });
  }
  const accessor = gltf.accessors[primitive.indices];
  const indices = copyOut(draco, accessor, mesh.num_faces() * 3, (size, pointer) => {
    decoder.GetTrianglesUInt32Array(mesh, size, pointer);
  });
  if (Object.keys(ids).sort().join() !== Object.keys(primitive.attributes).sort().join()) {
    complain('the compressed attributes are not those of the primitive');
  }
  draco.destroy(mesh);
  draco.destroy(decoder);
  return { attributes, indices };
}

function copyOut(draco, accessor, length, fill) {
  const Values = componentArrays[accessor.componentType];
  const size = length * Values.BYTES_PER_ELEMENT;
  const pointer = draco._malloc(size);
  fill(size, pointer);
  const values = new Values(draco.HEAPU8.slice(pointer, pointer + size).buffer);
  draco._free(pointer);
  return values;
}

function readPlain(gltf, binary, primitive) {
  const read = (index) => {
    const { bufferView, byteOffset = 0, componentType, type, count } = gltf.accessors[index];
    const Values = componentArrays[componentType];
    const size = count * typeWidths[type] * Values.BYTES_PER_ELEMENT;
    const bytes = viewBytes(gltf, binary, bufferView).subarray(byteOffset, byteOffset + size);
    return new Values(new Uint8Array(bytes).buffer);
  };
  const attributes = Object.fromEntries(
    Object.entries(primitive.attributes).map(([name, index]) => [name, read(index)]),
  );
  return { attributes, indices: primitive.indices === undefined ? undefined : read(primitive.indices) };
}

function checkValues(gltf, primitive, { attributes, indices }, complain) {
  const vertices = attributes.POSITION.length / 3;
  for (const [name, values] of Object.entries(attributes)) {
    const accessor = gltf.accessors[primitive.attributes[name]];
    const width = typeWidths[accessor.type];
    if (values.length !== accessor.count * width) complain(`${name}: ${values.length / width} of ${accessor.count}`);
    if (!values.every(Number.isFinite)) complain(`${name} has values that are not finite`);
    for (let axis = 0; accessor.min && axis < width; ++axis) {
      const ofAxis = values.filter((_, i) => i % width === axis);
      const minimum = ofAxis.reduce((a, b) => Math.min(a, b));
      const maximum = ofAxis.reduce((a, b) => Math.max(a, b));
      if (minimum !== accessor.min[axis] || maximum !== accessor.max[axis]) {
        complain(`${name} axis ${axis} spans ${minimum}..${maximum}, announced ${accessor.min[axis]}..${accessor.max[axis]}`);
      }
    }
  }
  const normals = attributes.NORMAL ?? [];
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]);
    if (!(Math.abs(length - 1) < 1e-4)) return complain(`normal ${i / 3} has length ${length}`);
  }
  if (!indices) return;
  if (indices.length !== gltf.accessors[primitive.indices].count) complain('another number of indices than announced');
  if (!indices.every((index) => index < vertices)) complain('an index is out of range');
}
