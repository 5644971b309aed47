import { createRoot } from "react-dom/client";
import { App } from "./app/App";
import { exampleInAddress, keepAddress, showStateOn } from "./app/address";
import { Session } from "./app/session";

const session = new Session();
showStateOn(document.documentElement, session.store);
keepAddress(session);
const root = document.getElementById("root");
if (root) createRoot(root).render(<App session={session} />);
void session.start(exampleInAddress());
