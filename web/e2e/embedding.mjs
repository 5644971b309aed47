// Pages of other origins, which are the examples of docs/embedding.md, and graphs for them.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";
import esbuild from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const packages = path.resolve(here, "../node_modules");
const draco = "three/examples/jsm/libs/draco/gltf";

/** What a site has, by path. */
const FILES = new Map([
  ["/model-viewer.min.js", "@google/model-viewer/dist/model-viewer.min.js"],
  ["/draco/draco_decoder.wasm", `${draco}/draco_decoder.wasm`],
  ["/draco/draco_wasm_wrapper.js", `${draco}/draco_wasm_wrapper.js`],
]);

const TYPES = { ".js": "text/javascript", ".wasm": "application/wasm" };

/** The first example below a heading of docs/embedding.md, as it stands there but for the address of the server. */
export function example(heading, dini) {
  const text = readFileSync(path.resolve(here, "../../docs/embedding.md"), "utf8");
  const section = text.split("\n## ").find((part) => part.startsWith(`${heading}\n`));
  const code = /^```(?:html|jsx)\n([\s\S]*?)^```$/m.exec(section ?? "")?.[1];
  if (!code?.includes("https://dini.example/")) throw new Error(`There is no example below “${heading}”.`);
  return code.replaceAll("https://dini.example", dini);
}

/** The component of the example in a page. */
async function reactPage(dini) {
  const { outputFiles } = await esbuild.build({
    stdin: {
      contents: `${example("React", dini)}
        import { createRoot } from "react-dom/client";
        createRoot(document.getElementById("root")).render(<Ring />);`,
      loader: "jsx",
      resolveDir: here,
    },
    ...{ bundle: true, write: false, format: "esm", jsx: "automatic", minify: true },
    define: { "process.env.NODE_ENV": '"production"' },
  });
  return `<div id="root"></div>
    <script>self.ModelViewerElement = { dracoDecoderLocation: "/draco/" };</script>
    <script type="module" src="/model-viewer.min.js"></script>
    <script type="module">${outputFiles[0].text.replaceAll("</script", "<\\/script")}</script>`;
}

/** What stands at the addresses of a site. */
const PAGES = {
  "/viewer": ({ dini }) => example("model-viewer", dini),
  "/react": ({ dini }) => reactPage(dini),
  "/three": ({ dini }) => example("three.js", dini),
  "/frame": ({ dini }) => example("A frame", dini),
  "/isolated": ({ dini }) => example("A frame", dini),
};

/** A web site of an origin of its own. */
export class Site {
  #server;

  static async start() {
    const site = new Site();
    site.#server = createServer((request, response) => void site.#answer(request, response));
    await new Promise((done) => site.#server.listen(0, "127.0.0.1", done));
    // Another name than the server's, so that it is another site and not just another port.
    site.origin = `http://localhost:${site.#server.address().port}`;
    return site;
  }

  stop() {
    this.#server.closeAllConnections?.();
    return new Promise((done) => this.#server.close(done));
  }

  async #answer(request, response) {
    const { pathname, searchParams } = new URL(request.url, "http://localhost");
    // Nothing but what lies in the package, whatever is asked for.
    const inThree = /^\/three\/((?:[\w-]+\/)*[\w.-]+\.(?:js|wasm))$/.exec(pathname)?.[1];
    const file = FILES.get(pathname) ?? (inThree && `three/${inThree}`);
    if (file) {
      response.setHeader("content-type", TYPES[path.extname(file)]);
      return response.end(readFileSync(path.join(packages, file)));
    }
    const page = PAGES[pathname];
    if (!page) {
      response.statusCode = pathname === "/favicon.ico" ? 204 : 404;
      return response.end();
    }
    response.setHeader("content-type", "text/html; charset=utf-8");
    if (pathname === "/isolated") {
      response.setHeader("cross-origin-opener-policy", "same-origin");
      response.setHeader("cross-origin-embedder-policy", "require-corp");
    }
    return response.end(`<!doctype html><title>A site</title>${await page(Object.fromEntries(searchParams))}`);
  }
}

export const closeSites = (...sites) => Promise.all(sites.map((site) => site?.stop()));

/** Keeps a ball whose size varies, one that no size is good for, and one that is too large at the end of its slider. The
 * first goes by the name of the graph of the examples: of a ball it is known how large it has to be. */
export async function balls(url) {
  const graph = (radius, reach) => ({
    format: 1,
    meta: { title: "A ball" },
    parameters: { reach: { type: "number", default: 1, min: 0.05, max: 2, label: "Reach", unit: "m", ...reach } },
    nodes: {
      ball: { type: "sphere_mesh", inputs: { radius } },
      out: { type: "export", inputs: { model: { from: "ball" } } },
    },
  });
  const reach = { parameter: "reach" };
  for (const [id, document] of [
    ["ring", graph(reach)],
    ["broken", graph(-1)],
    ["fragile", graph(reach, { max: 1e12 })],
  ]) {
    const answer = await fetch(`${url}/v1/graphs/${id}`, {
      method: "PUT",
      headers: { "content-type": "application/json", "if-none-match": "*" },
      body: JSON.stringify(document),
    });
    if (!answer.ok) throw new Error(await answer.text());
  }
}
