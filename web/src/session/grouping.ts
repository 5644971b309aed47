// Groups as a person makes, enters and leaves them, takes them apart, and keeps them in files.

import { addNodes, freeId, inOrder } from "../model/edit";
import { plural } from "../model/format";
import { broughtGroups, groupFile, outerGroups, wouldHoldItself } from "../model/group_files";
import { toggleOutputs } from "../model/groups";
import { asObject, type Json } from "../model/json";
import { makeGroup, ungroup } from "../model/make_group";
import { GROUP_PREFIX, groupNamed } from "../model/scope";
import { saveBlob } from "./download";
import type { Editor } from "./editor";
import type { Session } from "./session";

/** Between a graph and a group that is added to it. */
const ROOM = 260;

/** What is said where a group would be put into itself. */
export const HOLDS_ITSELF = "A group cannot hold itself. Leave the group first.";

/** Puts the selected nodes into a group. */
export function groupSelection(editor: Editor): void {
  const { document, catalogue, selection } = editor.session.store.get();
  if (!document || !catalogue) return;
  if (selection.size === 0) {
    editor.say("Select the nodes of the group first.", "refused");
    return;
  }
  const { edit, id, inputs, outputs } = makeGroup(document, catalogue, selection);
  editor.session.edit(`Group ${plural(selection.size, "node")}`, edit);
  editor.session.select([id]);
  editor.say(`Grouped ${plural(selection.size, "node")}: ${plural(inputs, "input")}, ${plural(outputs, "output")}`);
}

/** Puts the nodes of the selected groups in their place. */
export function ungroupSelection(editor: Editor): void {
  const start = editor.session.store.get();
  const chosen = [...start.selection].filter(
    (id) => groupNamed(start.document?.nodes.get(id)?.type ?? "") !== undefined,
  );
  if (!start.document || chosen.length === 0) {
    editor.say("Select a group to take it apart.", "refused");
    return;
  }
  const ids: string[] = [];
  const { catalogue } = start;
  editor.session.edit("Take the group apart", (document) => {
    if (!catalogue) return document;
    let changed = document;
    for (const id of chosen) {
      const { edit, ids: made } = ungroup(changed, catalogue, id);
      changed = edit(changed);
      ids.push(...made);
    }
    return changed;
  });
  editor.session.select(ids);
  editor.say(`Took ${plural(chosen.length, "group")} apart: ${plural(ids.length, "node")}`);
}

/** Into the selected group; out of the one that is looked at, where none is selected. True if there was one. */
export function enterOrLeave(editor: Editor): boolean {
  const { document, selection } = editor.session.store.get();
  const [id, ...others] = selection;
  const isGroup = id !== undefined && groupNamed(document?.nodes.get(id)?.type ?? "") !== undefined;
  if (isGroup && others.length === 0) enter(editor, id);
  else if (document && document.inside.length > 0) leave(editor);
  else return false;
  return true;
}

export function enter(editor: Editor, id: string): void {
  editor.closeAll();
  // What has the focus goes with its canvas; without one, no key would lead on or out.
  editor.nextFocus = { node: null };
  editor.session.enter(id);
  editor.say(`In the group ${id}. Tab leaves it.`);
}

export function leave(editor: Editor, steps = 1): void {
  editor.closeAll();
  editor.session.leave(steps);
  editor.nextFocus = { node: editor.session.store.get().selected };
  editor.say("Left the group");
}

/** Shows the outputs of the selected nodes around the group, or hides them again. */
export function toggleGroupOutputs(editor: Editor): void {
  const { document, catalogue, selection } = editor.session.store.get();
  if (!document || !catalogue || document.inside.length === 0) return;
  editor.session.edit("Change the outputs of the group", toggleOutputs(catalogue, selection));
}

/** Writes a group to a file of its own. */
export function saveGroup(editor: Editor, id: string): void {
  const { document } = editor.session.store.get();
  const name = groupNamed(document?.nodes.get(id)?.type ?? "");
  if (!document || name === undefined) return;
  const text = `${JSON.stringify(groupFile(document, name), null, 2)}\n`;
  saveBlob(new Blob([text], { type: "application/json" }), `${name}.group.json`);
  editor.say(`Saved ${name}.group.json`);
}

/** What was added, in words; undefined for a document that is no file of groups, or where no graph is open. */
export function addGroups(session: Session, json: Json): string | undefined {
  const { document } = session.store.get();
  const root = asObject(json);
  const groups = asObject(root["groups"]);
  const outer = outerGroups(groups);
  if (!document || outer.length === 0 || Object.keys(asObject(root["nodes"])).length > 0) return undefined;
  const { edit, typeOf } = broughtGroups(document, groups, asObject(asObject(root["ui"])["groups"]));
  const types = outer.map((name) => typeOf(GROUP_PREFIX + name));
  if (wouldHoldItself(edit(document), types)) return HOLDS_ITSELF;
  const places = [...document.positions.values()];
  const [x, y] = [
    Math.max(0, ...places.map((place) => place.x + ROOM)),
    Math.min(0, ...places.map((place) => place.y)),
  ];
  const taken = new Set<string>();
  const nodes = outer.map((name, index) => {
    const id = freeId(document, name, taken);
    taken.add(id);
    return { id, type: typeOf(GROUP_PREFIX + name), position: { x, y: y + ROOM * index } };
  });
  session.edit("Add a group", inOrder(edit, addNodes(nodes)));
  session.select(nodes.map(({ id }) => id));
  return `Added ${plural(nodes.length, "group")}`;
}
