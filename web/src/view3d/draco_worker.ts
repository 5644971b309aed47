// Runs inside the worker. Its text becomes the worker's script, so it must not use anything from outside of itself.

export interface DracoRequest {
  id: number;
  parts: { bytes: Uint8Array<ArrayBuffer>; attributes: { name: string; id: number; component: number }[] }[];
}

export interface DecodedPart {
  indices: Uint32Array<ArrayBuffer>;
  attributes: { name: string; size: number; array: DecodedArray }[];
}

export type DecodedArray = Float32Array<ArrayBuffer> | Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;

export type DracoAnswer = { id: number; parts: DecodedPart[] } | { id: number; error: string };

/** The calls of libdraco's decoder that are used. */
interface Draco {
  HEAPU8: Uint8Array<ArrayBuffer>;
  DT_FLOAT32: number;
  DT_UINT8: number;
  DT_UINT16: number;
  TRIANGULAR_MESH: number;
  Decoder: new () => DracoDecoder;
  Mesh: new () => DracoMesh;
  _malloc(size: number): number;
  _free(pointer: number): void;
  destroy(object: object): void;
}

interface DracoMesh {
  ptr: number;
  num_faces(): number;
  num_points(): number;
}

interface DracoAttribute {
  ptr: number;
  num_components(): number;
}

interface DracoDecoder {
  GetEncodedGeometryType(bytes: Int8Array): number;
  DecodeArrayToMesh(bytes: Int8Array, size: number, mesh: DracoMesh): { ok(): boolean; error_msg(): string };
  GetAttributeByUniqueId(mesh: DracoMesh, id: number): DracoAttribute;
  GetTrianglesUInt32Array(mesh: DracoMesh, size: number, pointer: number): void;
  GetAttributeDataArrayForAllPoints(
    mesh: DracoMesh,
    attribute: DracoAttribute,
    type: number,
    size: number,
    pointer: number,
  ): void;
}

declare function DracoDecoderModule(settings: {
  wasmBinary: ArrayBuffer;
  onModuleLoaded(draco: Draco): void;
}): unknown;

/** The worker's body: the first message is the decoder's WebAssembly, all others are requests. */
export function dracoWorker(): void {
  let giveDraco: (holder: { draco: Draco }) => void;
  // Held in an object: the module looks like a promise, which a promise would wait for.
  const loaded = new Promise<{ draco: Draco }>((resolve) => (giveDraco = resolve));

  const decode = (draco: Draco, decoder: DracoDecoder, part: DracoRequest["parts"][number]): DecodedPart => {
    const bytes = new Int8Array(part.bytes.buffer, part.bytes.byteOffset, part.bytes.byteLength);
    if (decoder.GetEncodedGeometryType(bytes) !== draco.TRIANGULAR_MESH) throw new Error("It holds no mesh.");
    const mesh = new draco.Mesh();
    try {
      const status = decoder.DecodeArrayToMesh(bytes, bytes.length, mesh);
      if (!status.ok() || mesh.ptr === 0) throw new Error(status.error_msg());
      const fetched = (size: number, fill: (pointer: number) => void): ArrayBuffer => {
        const pointer = draco._malloc(size);
        fill(pointer);
        const copy = draco.HEAPU8.slice(pointer, pointer + size);
        draco._free(pointer);
        return copy.buffer;
      };
      const indexBytes = 12 * mesh.num_faces();
      const indices = fetched(indexBytes, (pointer) => decoder.GetTrianglesUInt32Array(mesh, indexBytes, pointer));
      const attributes = part.attributes.map(({ name, id, component }) => {
        const attribute = decoder.GetAttributeByUniqueId(mesh, id);
        if (attribute.ptr === 0) throw new Error(`It has no ${name}.`);
        const size = attribute.num_components();
        const Numbers = component === 5121 ? Uint8Array : component === 5123 ? Uint16Array : Float32Array;
        const type =
          component === 5121 ? draco.DT_UINT8 : component === 5123 ? draco.DT_UINT16 : draco.DT_FLOAT32;
        const space = mesh.num_points() * size * Numbers.BYTES_PER_ELEMENT;
        const data = fetched(space, (pointer) =>
          decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type, space, pointer),
        );
        return { name, size, array: new Numbers(data) };
      });
      return { indices: new Uint32Array(indices), attributes };
    } finally {
      draco.destroy(mesh);
    }
  };

  self.onmessage = ({ data }: MessageEvent<ArrayBuffer | DracoRequest>) => {
    if (data instanceof ArrayBuffer) {
      DracoDecoderModule({ wasmBinary: data, onModuleLoaded: (draco) => giveDraco({ draco }) });
      return;
    }
    void loaded.then(({ draco }) => {
      const decoder = new draco.Decoder();
      try {
        const parts = data.parts.map((part) => decode(draco, decoder, part));
        const buffers = parts.flatMap((part) => [
          part.indices.buffer,
          ...part.attributes.map((attribute) => attribute.array.buffer),
        ]);
        self.postMessage({ id: data.id, parts } satisfies DracoAnswer, { transfer: buffers });
      } catch (error) {
        const text = error instanceof Error ? error.message : String(error);
        self.postMessage({ id: data.id, error: text } satisfies DracoAnswer);
      } finally {
        draco.destroy(decoder);
      }
    });
  };
}
