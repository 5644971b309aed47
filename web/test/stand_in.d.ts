declare module "*/stand_in/cards.mjs" {
  export const catalogue: { nodes: { id: string }[] };
}

declare module "*/stand_in/examples.mjs" {
  export const examples: { id: string; graph: Record<string, unknown> }[];
}
