// The generated docs/gallery.md: every example with its picture.

import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
export const pictureFolder = path.join(root, "docs/images/examples");
export const galleryFile = path.join(root, "docs/gallery.md");

/** The built-in examples by id: what the gallery says of each. */
export function readExamples() {
  const folder = path.join(root, "examples");
  return readdirSync(folder)
    .filter((name) => name.endsWith(".json"))
    .sort()
    .map((name) => {
      const { meta = {} } = JSON.parse(readFileSync(path.join(folder, name), "utf8"));
      const id = path.parse(name).name;
      return { id, title: meta.title ?? id, description: meta.description ?? "", figure: meta.figure ?? "" };
    });
}

/** The text of docs/gallery.md: the figures of the paper in their order, then what belongs to none. */
export function galleryText(examples) {
  const order = (example) => Number(example.figure) || Infinity;
  const rows = [...examples]
    .sort((a, b) => order(a) - order(b) || a.id.localeCompare(b.id))
    .map(({ id, title, description, figure }) => {
      const picture = `<img src="images/examples/${id}.png" width="400" alt="${cell(title)}">`;
      const source = figure ? `Figure ${cell(figure)}` : "Not in the paper";
      const graph = `[examples/${id}.json](../examples/${id}.json)`;
      const command = `\`dini eval examples/${id}.json -o ${id}.glb\``;
      return `| ${picture} | **${cell(title)}** · ${source}<br>${cell(description)}<br>${graph}<br>${command} |`;
    });
  return `# Gallery

Every example as the page shows it. In the page, \`#example=<name>\` opens one; on the command line, the line below each
picture writes its model. \`scripts/render-examples\` makes the pictures and this file; change the examples, not the file.

| | |
| --- | --- |
${rows.join("\n")}
`;
}

/** Text that stays in its cell of a table. */
function cell(text) {
  return String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("|", "&#124;").replace(/\s+/g, " ");
}
