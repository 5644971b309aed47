// A mesh file becomes a node: the server keeps the file and answers its hash, which is the node's literal.

import { type Catalogue, FILE_TYPE, type InputCard, type NodeCard } from "../model/catalogue";
import { type GraphDocument, lookedAt } from "../model/document";
import { addNodes, type Edit, freeId, inOrder } from "../model/edit";
import { setFlag } from "../model/edit_ui";
import { wholeCatalogue } from "../model/group_cards";
import { asString } from "../model/json";
import { send } from "../net/access";
import { problemText, readProblem } from "../net/problem";

export interface Uploaded {
  sha256: string;
  triangles: number;
}

/** Endings of the files that the server reads. */
export const MESH_FILE = /\.(obj|ply|glb)$/i;

/** Sends a file to the server. Answers a sentence for the person if it is refused. */
export async function uploadMesh(bytes: Blob): Promise<Uploaded | { error: string }> {
  try {
    const headers = { "content-type": "application/octet-stream" };
    const response = await send("v1/assets", { method: "POST", headers, body: bytes });
    const json = await response.json();
    if (!response.ok) return { error: problemText(readProblem(response.status, json)) };
    return { sha256: asString(json.sha256), triangles: Number(json.triangles) || 0 };
  } catch {
    return { error: "The server did not answer." };
  }
}

/** The node type that takes a file of the server's, and its input. */
export function importCard(catalogue: Catalogue): { card: NodeCard; input: InputCard } | undefined {
  for (const card of catalogue.nodes.values()) {
    const input = card.inputs.find((one) => one.namesFile);
    if (input) return { card, input };
  }
  return undefined;
}

/**
 * Adds a node with the uploaded file, flagged so that it is seen at once. In a graph that makes no file, a node that
 * does is added behind it. Answers the edit and the node's name; undefined where the catalogue takes no files.
 */
export function addImport(
  document: GraphDocument,
  catalogue: Catalogue,
  sha256: string,
): { edit: Edit; id: string } | undefined {
  const found = importCard(catalogue);
  if (!found) return undefined;
  const { card, input } = found;
  const id = freeId(document, card.id);
  const position = placeBelow(document);
  const node = { id, type: card.id, position, inputs: { [input.name]: sha256 } };
  const makesFile = (one: NodeCard | undefined): boolean =>
    one?.outputs.some(({ types }) => types.includes(FILE_TYPE)) ?? false;
  const { nodes } = wholeCatalogue(catalogue, document);
  const isFileMade = [...lookedAt(document, []).nodes.values()].some(({ type }) => makesFile(nodes.get(type)));
  // What ends a graph ends nothing within a group.
  if (isFileMade || document.inside.length > 0) {
    return { edit: inOrder(addNodes([node]), setFlag([id], "preview", true)), id };
  }
  const made = new Set(card.outputs.flatMap(({ types }) => types));
  const takes = (one: InputCard): boolean => one.types.some((type) => made.has(type));
  const last = [...catalogue.nodes.values()].find((one) => makesFile(one) && one.inputs.some(takes));
  const socket = last?.inputs.find(takes);
  if (!last || !socket) return { edit: addNodes([node]), id };
  const end = {
    id: freeId(document, last.id, new Set([id])),
    type: last.id,
    position: { x: position.x + 320, y: position.y },
    inputs: { [socket.name]: { from: id } },
  };
  return { edit: addNodes([node, end]), id };
}

function placeBelow({ positions }: GraphDocument): { x: number; y: number } {
  const all = [...positions.values()];
  if (all.length === 0) return { x: 0, y: 0 };
  return { x: Math.min(...all.map(({ x }) => x)), y: Math.max(...all.map(({ y }) => y)) + 220 };
}
