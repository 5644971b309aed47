// The open graph as commands for a shell.

import { fileName } from "../model/format";
import type { Session } from "./session";

/** A curl call that answers the model in final quality; undefined before a graph is open. */
export function curlText(session: Session): string | undefined {
  const body = session.body();
  const title = session.store.get().document?.title;
  if (!body || title === undefined) return undefined;
  const address = new URL("v1/evaluate", document.baseURI).href;
  const json = JSON.stringify({ ...body, quality: "final" });
  return `curl -sf ${quoted(address)} -H 'content-type: application/json' -o ${fileName(title)}.glb -d ${quoted(json)}`;
}

/** The same on the command line; the graph is taken from the examples' folder. */
export function commandLineText(session: Session): string | undefined {
  const { exampleId, values, document: open } = session.store.get();
  if (!open || exampleId === null) return undefined;
  const settings = Object.entries(values).map(([name, value]) => {
    const text = typeof value === "object" ? JSON.stringify(value) : String(value);
    return ` --set ${quoted(`${name}=${text}`)}`;
  });
  return `dini eval examples/${exampleId}.json${settings.join("")} -o ${fileName(open.title)}.glb`;
}

function quoted(text: string): string {
  return /^[\w./:=-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}
