// Addresses of what the server keeps of the open graph, for people, pages and programs.

import { lookedAt } from "../model/document";
import { makesFile } from "../model/graph";
import { wholeCatalogue } from "../model/group_cards";
import { embedAddress, outputAddress } from "../net/stored";
import type { SessionState } from "../session/state";
import { storedPlace } from "./drafts";

export interface NamedAddress {
  title: string;
  text: string;
}

/** What can be copied of a stored graph; empty for one that the server does not keep. */
export function addressesOf({ document: open, catalogue, origin, values }: SessionState): NamedAddress[] {
  const place = storedPlace(origin);
  if (!place || !open || !catalogue) return [];
  // Both are told relative to a page in the folder of those for frames.
  const base = new URL("embed/", document.baseURI);
  const editor = new URL("./", document.baseURI);
  editor.hash = `graph=${place.id}`;
  const { nodes } = wholeCatalogue(catalogue, open);
  const outputs = [...lookedAt(open, []).nodes.values()].filter(({ type }) => makesFile(nodes.get(type)));
  const frame = new URL(embedAddress(place.id, values), base).href;
  return [
    { title: "Graph in the editor", text: editor.href },
    ...outputs.map(({ id }) => ({
      title: outputs.length > 1 ? `Model of ${id}` : "Model",
      text: new URL(outputAddress(place.id, id, values, "final"), base).href,
    })),
    ...(outputs.length > 0 ? [{ title: "Frame for a page", text: frameText(frame, open.title) }] : []),
  ];
}

/** True where nobody else can reach this address. */
export function isOnlyHere(hostname: string): boolean {
  return /^(localhost|.*\.localhost|127(\.\d+){3}|\[::1\])$/.test(hostname);
}

function frameText(address: string, title: string): string {
  const quoted = title.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
  const source = address.replaceAll("&", "&amp;");
  return `<iframe src="${source}" title="${quoted}" width="640" height="480" style="border: 0" loading="lazy"></iframe>`;
}
