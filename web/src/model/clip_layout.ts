// Where nodes go that were written without places, such as a document from the documentation.

import type { Catalogue } from "./catalogue";
import { type Clip, paste } from "./clip";
import type { GraphDocument } from "./document";
import { viewGraph } from "./graph";
import { layeredLayout, partOf } from "./layout";

/** The clip with its nodes from left to right as their wires go, unless its text says where any of them is. */
export function withPlaces(clip: Clip, document: GraphDocument, catalogue: Catalogue): Clip {
  if (clip.isPlaced) return clip;
  const { edit, ids } = paste(document, clip, { x: 0, y: 0 }, false);
  const part = partOf(viewGraph(edit(document), catalogue), new Set(ids));
  const places = layeredLayout(part);
  const placed = Object.keys(clip.nodes).map((id, index) => {
    return [id, places.get(ids[index] ?? "") ?? { x: 0, y: 0 }] as const;
  });
  return { ...clip, places: new Map(placed), isPlaced: true };
}
