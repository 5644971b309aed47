// The graphs that pictures are made of, and the generated docs/gallery.md: every example with its picture.

import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
export const pageFile = path.join(root, "docs/images/page.png");
export const galleryFile = path.join(root, "docs/gallery.md");

/**
 * The examples, and the small ones of one node each: where the graphs and the pictures are, what a picture is asked for
 * by, its size in pixels and the most bytes of its file. Smooth shapes on a plain ground stay far below these; more
 * would weigh on the repository.
 */
export const examples = {
  graphs: path.join(root, "examples"),
  pictures: path.join(root, "docs/images/examples"),
  prefix: "",
  width: 960,
  height: 600,
  most: 320_000,
};
export const nodeExamples = {
  graphs: path.join(root, "examples/nodes"),
  pictures: path.join(root, "docs/images/nodes"),
  prefix: "nodes/",
  width: 480,
  height: 300,
  most: 50_000,
};
export const assetFolder = path.join(root, "examples/assets");

/** The graphs of a folder by id, with what the gallery says of each. */
export function readExamples(folder = examples.graphs) {
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
export function galleryText(all) {
  const order = (example) => Number(example.figure) || Infinity;
  const rows = [...all]
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
[Nodes](nodes.md) has a small example with a picture for every node.

| | |
| --- | --- |
${rows.join("\n")}
`;
}

/** Text that stays in its cell of a table. */
function cell(text) {
  return String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("|", "&#124;").replace(/\s+/g, " ");
}
