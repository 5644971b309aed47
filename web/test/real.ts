// The real catalogue, as the program prints it (`dini nodes --json`; a test of the program holds them equal), and the real
// examples.

import { readdirSync, readFileSync } from "node:fs";
import { readCatalogue } from "../src/model/catalogue";
import type { Json, JsonObject } from "../src/model/json";

export const cards = JSON.parse(readFileSync("test/data/catalogue.json", "utf8")) as {
  nodes: ({ id: string } & JsonObject)[];
} & JsonObject;

export const catalogue = readCatalogue(cards as Json);

export const examples: readonly { id: string; graph: JsonObject & { nodes: JsonObject } }[] = readdirSync("../examples")
  .filter((name) => name.endsWith(".json"))
  .map((name) => ({
    id: name.replace(/\.json$/, ""),
    graph: JSON.parse(readFileSync(`../examples/${name}`, "utf8")),
  }));
