// Parts of a multipart body (RFC 7578): the server answers report and model at once.

export interface Part {
  name: string;
  type: string;
  data: Uint8Array<ArrayBuffer>;
}

const CR = 13;
const LF = 10;
const DASH = 45;

/** The boundary of a multipart content type, or undefined if it is another type. */
export function boundaryOf(contentType: string): string | undefined {
  if (!/^\s*multipart\//i.test(contentType)) return undefined;
  const match = /;\s*boundary=(?:"([^"]+)"|([^;\s]+))/i.exec(contentType);
  return match?.[1] ?? match?.[2];
}

/** Splits a body into its parts. Parts share the body's memory. Undefined if it is cut short or malformed. */
export function readMultipart(body: Uint8Array<ArrayBuffer>, boundary: string): Part[] | undefined {
  const mark = new TextEncoder().encode(`--${boundary}`);
  const parts: Part[] = [];
  let at = indexOf(body, mark, 0);
  while (at >= 0) {
    let start = at + mark.length;
    if (body[start] === DASH && body[start + 1] === DASH) return parts;
    start = endOfLine(body, start);
    if (start < 0) return undefined;
    const next = nextMark(body, mark, start - 2);
    if (next < 0) return undefined;
    const part = readPart(body.subarray(start, Math.max(start, next - 2)));
    if (!part) return undefined;
    parts.push(part);
    at = next;
  }
  return undefined;
}

/** The next mark that stands at the start of a line. */
function nextMark(body: Uint8Array, mark: Uint8Array, from: number): number {
  for (let at = indexOf(body, mark, from); at >= 0; at = indexOf(body, mark, at + 1)) {
    if (body[at - 1] === LF && body[at - 2] === CR) return at;
  }
  return -1;
}

function endOfLine(body: Uint8Array, from: number): number {
  let at = from;
  while (body[at] === 32 || body[at] === 9) at++;
  return body[at] === CR && body[at + 1] === LF ? at + 2 : -1;
}

function readPart(bytes: Uint8Array<ArrayBuffer>): Part | undefined {
  const headers = new Map<string, string>();
  let at = 0;
  for (;;) {
    const end = bytes.indexOf(CR, at);
    if (end < 0 || bytes[end + 1] !== LF) return undefined;
    const line = new TextDecoder().decode(bytes.subarray(at, end));
    at = end + 2;
    if (line === "") break;
    const colon = line.indexOf(":");
    headers.set(line.slice(0, colon).trim().toLowerCase(), line.slice(colon + 1).trim());
  }
  const name = /;\s*name="([^"]*)"/i.exec(headers.get("content-disposition") ?? "")?.[1] ?? "";
  return { name, type: headers.get("content-type") ?? "", data: bytes.subarray(at) };
}

function indexOf(body: Uint8Array, mark: Uint8Array, from: number): number {
  const first = mark[0] ?? DASH;
  for (let at = body.indexOf(first, from); at >= 0; at = body.indexOf(first, at + 1)) {
    let matched = 1;
    while (matched < mark.length && body[at + matched] === mark[matched]) matched++;
    if (matched === mark.length) return at;
  }
  return -1;
}
