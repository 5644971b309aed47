import { createRoot } from "react-dom/client";
import { EmbedPage } from "./embed/EmbedPage";
import { Show } from "./embed/show";
import { graphInPath, readAsked } from "./net/stored";

const show = new Show();
const page = document.documentElement;
// What others see of the page's state from outside, tests among them.
show.store.subscribe(() => {
  const { busy, problem, shown, document: graph } = show.store.get();
  page.dataset["state"] = problem ? "failed" : busy ? "busy" : "idle";
  page.dataset["shown"] = String(shown);
  document.title = graph?.title ?? "Dini";
});
const root = document.getElementById("root");
if (root) createRoot(root).render(<EmbedPage show={show} />);
void show.start(graphInPath(location.pathname), readAsked(location.search));
