import { createRoot } from "react-dom/client";
import { App } from "./app/App";
import { exampleInAddress, keepAddress, showStateOn } from "./app/address";
import { leaveKeysToInputMethods } from "./app/input_method";
import { filesOf } from "./files/Files";
import { recallSight } from "./files/tab";
import { Editor } from "./session/editor";
import { Session } from "./session/session";

leaveKeysToInputMethods();
const session = new Session();
showStateOn(document.documentElement, session.store);
keepAddress(session);
// One press of the pointer, or one stay in a field, is one step of undo.
for (const name of ["pointerdown", "pointerup", "focusin"]) {
  document.addEventListener(name, () => session.endGesture(), { capture: true });
}
const root = document.getElementById("root");
if (root) createRoot(root).render(<App editor={new Editor(session)} />);
void filesOf(session)
  .beginning()
  .then((first) => session.start(exampleInAddress(), first, recallSight()));
