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

/**
 * The same on the command line: an unchanged example or file by its name, anything else through standard input, so that
 * the command works wherever it is pasted.
 */
export function commandLineText(session: Session): string | undefined {
  const { origin, isChanged, values, document: open } = session.store.get();
  if (!open) return undefined;
  const settings = Object.entries(values).map(([name, value]) => {
    const text = typeof value === "object" ? JSON.stringify(value) : String(value);
    return ` --set ${quoted(`${name}=${text}`)}`;
  });
  const command = (graph: string): string => `dini eval ${graph}${settings.join("")} -o ${fileName(open.title)}.glb`;
  if (!isChanged && origin.kind === "example") return command(`examples/${origin.id}.json`);
  if (!isChanged && origin.kind === "file") return command(quoted(origin.name));
  // The JSON is one line, so no line of it can be the word that ends it.
  return `${command("-")} <<'GRAPH'\n${JSON.stringify(open.json)}\nGRAPH`;
}

function quoted(text: string): string {
  return /^[\w./:=-]+$/.test(text) && !text.startsWith("-") ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}
