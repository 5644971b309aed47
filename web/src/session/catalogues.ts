// The catalogue as a document sees it: the server's nodes, and the document's groups.

import type { Catalogue } from "../model/catalogue";
import { type GraphDocument, lookedAt } from "../model/document";
import { withGroups } from "../model/group_cards";
import type { Json } from "../model/json";
import type { Inside } from "../model/scope";

/** Of the group that is looked at, and of the whole document. */
const KEPT = 2;

interface Kept {
  groups: Json;
  inside: readonly Inside[];
  catalogue: Catalogue;
}

export class Catalogues {
  /** The server's own; undefined before it has come. */
  nodes: Catalogue | undefined;
  private kept: Kept[] = [];

  /** With the groups that may stand in what is looked at; the same object as long as they are the same. */
  of(document: GraphDocument): Catalogue | undefined {
    if (!this.nodes) return undefined;
    const groups = document.json["groups"];
    const { inside } = document;
    const known = this.kept.find((one) => one.groups === groups && isSamePlace(one.inside, inside));
    if (known) return known.catalogue;
    const catalogue = withGroups(this.nodes, document);
    this.kept = [{ groups, inside, catalogue }, ...this.kept].slice(0, KEPT);
    return catalogue;
  }

  /** With every group of the document. */
  ofWhole(document: GraphDocument): Catalogue | undefined {
    return this.of(lookedAt(document, []));
  }
}

function isSamePlace(a: readonly Inside[], b: readonly Inside[]): boolean {
  return a === b || (a.length === b.length && a.every(({ group }, at) => group === b[at]?.group));
}
