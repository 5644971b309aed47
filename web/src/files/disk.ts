// Files of the computer: through the File System Access API where the browser has it, else as up- and downloads.

import { saveBlob } from "../session/download";

/** The parts of the File System Access API that are used; TypeScript's library does not know its dialogs. */
interface FileHandle {
  name: string;
  getFile(): Promise<File>;
  createWritable(): Promise<{ write(text: string): Promise<void>; close(): Promise<void> }>;
}

interface Dialogs {
  showOpenFilePicker?(options: object): Promise<FileHandle[]>;
  showSaveFilePicker?(options: object): Promise<FileHandle>;
}

export interface OpenedFile {
  file: File;
  /** Where it can be written back without asking. */
  handle?: FileHandle;
}

export type { FileHandle };

const GRAPH_TYPES = [{ description: "Graph", accept: { "application/json": [".json"] } }];
const READABLE = ".json,.glb,.obj,.ply,.stl";

/** Asks for a file to open; undefined if the person changes their mind. */
export async function askForFile(): Promise<OpenedFile | undefined> {
  const { showOpenFilePicker } = window as Dialogs;
  if (!showOpenFilePicker) return askByField();
  try {
    const types = [
      {
        description: "Graphs and meshes",
        accept: { "application/json": [".json"], "model/obj": [".obj", ".ply", ".stl", ".glb"] },
      },
    ];
    const [handle] = await showOpenFilePicker.call(window, { types, multiple: false });
    return handle && { file: await handle.getFile(), handle };
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") return undefined;
    return askByField();
  }
}

/** Writes a text to a known file, or asks where. Answers where it is, "download" if the browser took it, or undefined. */
export async function writeFile(
  text: string,
  name: string,
  known: FileHandle | undefined,
): Promise<FileHandle | "download" | undefined> {
  const { showSaveFilePicker } = window as Dialogs;
  try {
    const handle = known ?? (await showSaveFilePicker?.call(window, { suggestedName: name, types: GRAPH_TYPES }));
    if (handle) {
      const stream = await handle.createWritable();
      await stream.write(text);
      await stream.close();
      return handle;
    }
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") return undefined;
    // Not allowed to write there: the browser's downloads are always allowed.
  }
  saveBlob(new Blob([text], { type: "application/json" }), name);
  return "download";
}

function askByField(): Promise<OpenedFile | undefined> {
  return new Promise((resolve) => {
    const field = document.createElement("input");
    field.type = "file";
    field.accept = READABLE;
    field.addEventListener("change", () => resolve(field.files?.[0] && { file: field.files[0] }));
    field.addEventListener("cancel", () => resolve(undefined));
    field.click();
  });
}
