// The model as a file, always in final quality.

import { fileName } from "../model/format";
import { fetchModel } from "../net/api";
import { problemText } from "../net/problem";
import type { Session } from "./session";

/** Saves the model of the present values. Answers what went wrong, or an empty text. */
export async function downloadModel(session: Session): Promise<string> {
  const { document: open, shown, revision, problem } = session.store.get();
  const body = session.body();
  if (!open || !body) return "Nothing is open.";
  const isCurrent = shown?.revision === revision && shown.quality === "final" && !problem;
  try {
    const model = isCurrent ? shown.model : await fetchModel(body);
    if (!(model instanceof Uint8Array)) return problemText(model);
    saveBlob(new Blob([model], { type: "model/gltf-binary" }), `${fileName(open.title)}.glb`);
    return "";
  } catch {
    return "The server did not answer.";
  }
}

/** Hands a file to the browser to save. */
export function saveBlob(blob: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
