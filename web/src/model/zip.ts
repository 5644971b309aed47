// A ZIP archive of files that are small already: nothing in it is compressed.

export interface ZipFile {
  /** Of letters of ASCII. */
  name: string;
  bytes: Uint8Array;
}

const LOCAL_HEADER = 0x04034b50;
const CENTRAL_HEADER = 0x02014b50;
const END = 0x06054b50;
const LOCAL_BYTES = 30;
const CENTRAL_BYTES = 46;
const END_BYTES = 22;
const VERSION = 20;
/** 1 January 1980, the first day that the format knows: the same files make the same archive. */
const DATE = 0x21;

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

/** The checksum of the format (CRC-32). */
export function checksum(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) value = (TABLE[(value ^ byte) & 0xff] ?? 0) ^ (value >>> 8);
  return (value ^ 0xffffffff) >>> 0;
}

/** The files as one archive, in their order. */
export function zipOf(files: readonly ZipFile[]): Uint8Array<ArrayBuffer> {
  const entries = files.map(({ name, bytes }) => ({
    name: new TextEncoder().encode(name),
    bytes,
    sum: checksum(bytes),
  }));
  const total = entries.reduce(
    (sum, { name, bytes }) => sum + LOCAL_BYTES + CENTRAL_BYTES + 2 * name.length + bytes.length,
    END_BYTES,
  );
  const archive = new Uint8Array(total);
  const view = new DataView(archive.buffer);
  let at = 0;
  const short = (value: number): void => {
    view.setUint16(at, value, true);
    at += 2;
  };
  const word = (value: number): void => {
    view.setUint32(at, value, true);
    at += 4;
  };
  const put = (bytes: Uint8Array): void => {
    archive.set(bytes, at);
    at += bytes.length;
  };
  /** What both headers say alike, up to the lengths of name and extras. */
  const common = ({ name, bytes, sum }: (typeof entries)[number]): void => {
    for (const value of [VERSION, 0, 0, 0, DATE]) short(value);
    for (const value of [sum, bytes.length, bytes.length]) word(value);
    short(name.length);
    short(0);
  };
  const places = entries.map((entry) => {
    const place = at;
    word(LOCAL_HEADER);
    common(entry);
    put(entry.name);
    put(entry.bytes);
    return place;
  });
  const directory = at;
  entries.forEach((entry, index) => {
    word(CENTRAL_HEADER);
    short(VERSION);
    common(entry);
    for (const value of [0, 0, 0]) short(value);
    word(0);
    word(places[index] ?? 0);
    put(entry.name);
  });
  const size = at - directory;
  word(END);
  for (const value of [0, 0, files.length, files.length]) short(value);
  word(size);
  word(directory);
  short(0);
  return archive;
}
