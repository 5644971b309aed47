import assert from "node:assert/strict";
import { test } from "node:test";
import { boundaryOf, readMultipart } from "../src/net/multipart";

const encoder = new TextEncoder();

function body(...parts: (string | Uint8Array)[]): Uint8Array<ArrayBuffer> {
  const chunks = parts.map((part) => (typeof part === "string" ? encoder.encode(part) : part));
  const bytes = new Uint8Array(chunks.reduce((sum, chunk) => sum + chunk.length, 0));
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}

const head = (name: string, type: string): string =>
  `Content-Disposition: form-data; name="${name}"\r\ncontent-type: ${type}\r\n\r\n`;

test("the boundary is read with and without quotes", () => {
  assert.equal(boundaryOf('multipart/form-data; boundary="a b"'), "a b");
  assert.equal(boundaryOf("multipart/form-data; charset=x; boundary=abc"), "abc");
  assert.equal(boundaryOf("application/json; boundary=abc"), undefined);
});

test("both parts of an answer come out byte for byte, whatever is in them", () => {
  const model = body(
    "glTF",
    new Uint8Array([0, 13, 10, 45, 45, 13, 10]),
    "--x not a boundary",
    "--X",
    "\r\n--",
    "\r\n",
  );
  const bytes = body(
    "--X\r\n",
    head("report", "application/json"),
    "{}",
    "\r\n--X\r\n",
    head("model", "model/gltf-binary"),
    model,
    "\r\n--X--\r\n",
  );
  const parts = readMultipart(bytes, "X");
  assert.deepEqual(
    parts?.map((part) => part.name),
    ["report", "model"],
  );
  assert.deepEqual([...(parts?.[1]?.data ?? [])], [...model]);
  assert.equal(parts?.[1]?.type, "model/gltf-binary");
});

test("an empty part is a part", () => {
  const parts = readMultipart(body("--X\r\n", head("a", "b"), "\r\n--X--"), "X");
  assert.equal(parts?.length, 1);
  assert.equal(parts?.[0]?.data.length, 0);
});

test("a body that is cut short anywhere is refused", () => {
  const whole = body(
    "--X\r\n",
    head("report", "application/json"),
    "{}",
    "\r\n--X\r\n",
    head("model", "m"),
    "abc",
    "\r\n--X--",
  );
  assert.ok(readMultipart(whole, "X"));
  for (let length = 0; length < whole.length; length++) {
    assert.equal(readMultipart(whole.subarray(0, length), "X"), undefined, String(length));
  }
});
