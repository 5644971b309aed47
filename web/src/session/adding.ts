// Adding a found node: at a free place, wired to the loose end or into the wire it was looked for.

import { beginningValues } from "../model/beginnings";
import type { GraphDocument } from "../model/document";
import { addNodes, type Edit, freeId, inOrder, moveNodes, setInput } from "../model/edit";
import { addParameter } from "../model/edit_parameters";
import { replaceNode } from "../model/edit_replace";
import { connect, insertOnWire } from "../model/edit_wires";
import { type ViewWire, viewGraph } from "../model/graph";
import { fullHeight, HEADER_HEIGHT, NODE_WIDTH, roomFor } from "../model/layout";
import { freePlace } from "../model/place";
import type { Finding } from "../model/search";
import type { Position } from "../model/ui";
import { occupied } from "./actions";
import type { Editor, Search } from "./editor";

/** Free on both sides of a node that is put into a wire. */
const GAP = 32;
/** Height of a node's first row: a wire that is dropped runs into the socket there. */
const FIRST_ROW = 46;

/** Puts a found node into the graph as the search says. Answers its name. */
export function addFinding(editor: Editor, finding: Finding, search: Search): string | undefined {
  const { document, catalogue } = editor.session.store.get();
  const { card } = finding;
  if (!document || !catalogue) return undefined;
  if (search.replaced !== undefined) {
    editor.session.edit(`Replace by ${card.title}`, replaceNode(catalogue, search.replaced, card.id));
    editor.say(`Replaced by ${card.title}`);
    return search.replaced;
  }
  const id = freeId(document, card.id);
  const room = search.wire && roomOnWire(editor, document, search.wire);
  const made = room ? moveNodes(room.moved)(document) : document;
  const position = placeFor(editor, made, { id, type: card.id }, room ? { ...search, place: room.place } : search);
  const edits: Edit[] = [
    moveNodes(room?.moved ?? new Map()),
    addNodes([{ id, type: card.id, position, inputs: { ...beginningValues(card), ...finding.inputs } }]),
  ];
  if (finding.slider) {
    const name = freeParameterId(document, id);
    edits.push(addParameter(name, { ...finding.slider.item, label: name }));
    edits.push(setInput(id, finding.slider.input, { parameter: name }));
  }
  const { loose, wire } = search;
  if (loose && finding.socket !== undefined) {
    const ends =
      loose.side === "output"
        ? { from: loose.node, output: loose.name, to: id, input: finding.socket }
        : { from: id, output: finding.socket, to: loose.node, input: loose.name };
    edits.push(connect(catalogue, ends));
  }
  if (wire) edits.push(insertOnWire(catalogue, id, wire));
  editor.unfold([id], true);
  editor.session.edit(`Add ${card.title}`, inOrder(...edits));
  editor.session.select([id]);
  editor.say(loose ? `Added ${card.title}, connected` : `Added ${card.title}`);
  return id;
}

/** Where a node goes that is put into a wire, and where everything behind it has to go to make room. */
function roomOnWire(
  editor: Editor,
  document: GraphDocument,
  wire: ViewWire,
): { place: Position; moved: Map<string, Position> } | undefined {
  const boxes = editor.canvas?.boxes();
  const [from, to] = [boxes?.get(wire.from), boxes?.get(wire.to)];
  // A wire that runs backwards has no room between its ends.
  if (!from || !to || to.x < from.x + from.width) return undefined;
  const left = from.x + from.width + GAP;
  const lack = Math.max(0, left + NODE_WIDTH + GAP - to.x);
  const moved = new Map<string, Position>();
  for (const [id, { x, y }] of document.positions) if (lack > 0 && x >= to.x) moved.set(id, { x: x + lack, y });
  return { place: { x: (from.x + from.width + to.x + lack) / 2, y: (from.y + to.y) / 2 + FIRST_ROW }, moved };
}

/** A place near the wanted one that is free for the node. */
function placeFor(
  editor: Editor,
  document: GraphDocument,
  { id, type }: { id: string; type: string },
  search: Search,
): Position {
  const { catalogue } = editor.session.store.get();
  const added = addNodes([{ id, type, position: search.place }])(document);
  const view = catalogue && viewGraph(added, catalogue).byId.get(id);
  const size = { width: NODE_WIDTH, height: view ? roomFor(view, fullHeight(view)) : 120 };
  const { x, y } = search.place;
  const isFed = search.loose?.side === "output";
  const left = isFed ? x : search.loose ? x - size.width : x - size.width / 2;
  const top = y - (search.loose || search.wire ? FIRST_ROW : HEADER_HEIGHT / 2);
  return freePlace({ x: left, y: top }, size, occupied(editor, document));
}

function freeParameterId(document: GraphDocument, wanted: string): string {
  return freeId(document, wanted, new Set(document.parameters.map((parameter) => parameter.name)));
}
