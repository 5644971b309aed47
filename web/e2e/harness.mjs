// Starts the server and a browser for the end-to-end tests.
// DINI_URL: a running server. DINI_PROGRAM: the program to start, else build/release/dini.

import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { inspect, isDeepStrictEqual } from "node:util";
import { chromium } from "playwright-core";

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.resolve(here, "../..");
const program = process.env.DINI_PROGRAM ?? path.join(root, "build/release/dini");

/** Waits end here only where something is wrong: a machine that is ten times slower must not fail. */
export const LONGEST_WAIT = 60_000;

const CHROMIUM_ARGUMENTS = [
  "--no-sandbox",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-dev-shm-usage",
  "--hide-scrollbars",
  "--force-device-scale-factor=1",
  "--mute-audio",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** A server of our own that can be stopped and started again at the same address. */
export class Server {
  url = process.env.DINI_URL ?? "";
  isOurs = !process.env.DINI_URL;
  #child;
  #examples;
  #more;
  #data;

  /**
   * `examples`: the folder of the graphs that our own server lists, other than the usual one; `more`: further options;
   * `data`: the folder where it keeps graphs beyond its end.
   */
  constructor(examples = path.join(root, "examples"), more = [], data = "none") {
    this.#examples = examples;
    this.#more = more;
    this.#data = data;
  }

  async start() {
    if (!this.isOurs) return;
    if (!existsSync(program)) throw new Error(`${program} is not built; scripts/build makes it.`);
    const folder = mkdtempSync(path.join(tmpdir(), "dini-e2e-"));
    const portFile = path.join(folder, "port");
    const port = this.url ? new URL(this.url).port : "0";
    const common = ["--port", port, "--port-file", portFile];
    const folders = ["--web", path.join(root, "web/dist"), "--examples", this.#examples];
    const parts = ["serve", "--data", this.#data, ...common, "--log-level", "warning", ...folders, ...this.#more];
    this.#child = spawn(program, parts, { stdio: ["ignore", "ignore", "inherit"] });
    const limit = Date.now() + LONGEST_WAIT;
    const written = () => existsSync(portFile) && readFileSync(portFile, "utf8").trim() !== "";
    while (!written()) {
      if (Date.now() > limit) throw new Error(`${program} did not start`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    this.url = `http://127.0.0.1:${readFileSync(portFile, "utf8").trim()}`;
    rmSync(folder, { recursive: true, force: true });
  }

  async stop() {
    if (!this.#child) return;
    const gone = new Promise((resolve) => this.#child.once("exit", resolve));
    this.#child.kill("SIGTERM");
    await gone;
    this.#child = undefined;
  }
}

/** `more`: what the browser is to be told beside the usual. */
export function launchBrowser(more = []) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: [...CHROMIUM_ARGUMENTS, ...more],
  });
}

/** A page that keeps account of everything that must not happen: `page.offences`. */
export async function openPage(browser, url, options = {}) {
  const { hash = "", theme = "dark", width = 1280, height = 720, expectOutage = false, firstRun = false } = options;
  const { touch = false, clipboard = false, count = false, expectStatus = 422 } = options;
  const context = await browser.newContext({
    ...{ viewport: { width, height }, colorScheme: theme, acceptDownloads: true, hasTouch: touch },
    permissions: clipboard ? ["clipboard-read", "clipboard-write"] : [],
  });
  await context.addInitScript(() => {
    window.cspViolations = [];
    document.addEventListener("securitypolicyviolation", (event) =>
      window.cspViolations.push(`${event.violatedDirective} ${event.blockedURI}`),
    );
  });
  // What is said to someone new lies over the page until it is closed.
  if (!firstRun) await context.addInitScript(() => localStorage.setItem("dini.hint", "yes"));
  // The browser's own file dialogs cannot be answered by a test; without them files are up- and downloads.
  await context.addInitScript(() => {
    delete window.showOpenFilePicker;
    delete window.showSaveFilePicker;
  });
  if (count) await context.addInitScript(countThings);
  context.setDefaultTimeout(LONGEST_WAIT);
  const page = await context.newPage();
  await options.beforeOpening?.(page);
  const offences = [];
  const origin = new URL(url).origin;
  page.on("console", (message) => {
    // The browser itself reports refused evaluations (422) and a server that is away as errors.
    const text = message.text();
    const isRefused = [422, expectStatus].some((status) =>
      text.startsWith(`Failed to load resource: the server responded with a status of ${status}`),
    );
    const isAway = /^Failed to load resource: net::ERR_(CONNECTION|EMPTY)/.test(text);
    const isAllowed = isRefused || (isAway && expectOutage);
    if (message.type() === "error" && !isAllowed) offences.push(`console: ${text}`);
  });
  // Whoever listens has file dialogs go to the test. Begun with the first dialog, that may be too late for it.
  page.on("filechooser", () => undefined);
  page.on("pageerror", (error) => offences.push(`error: ${error.message}`));
  page.on("request", (request) => {
    if (!/^(blob|data):/.test(request.url()) && new URL(request.url()).origin !== origin)
      offences.push(`request to ${request.url()}`);
  });
  await page.goto(`${url}/${hash}`);
  page.offences = async () => [
    ...offences,
    ...(await page.evaluate(() => window.cspViolations)).map((text) => `policy: ${text}`),
  ];
  return page;
}

/** Runs in the page: `window.counted` has the workers that were started and the listeners that are there. */
function countThings() {
  const counted = { workers: 0, listeners: 0 };
  window.counted = counted;
  window.Worker = class extends window.Worker {
    constructor(...parts) {
      super(...parts);
      counted.workers++;
    }
  };
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  const kept = new WeakMap();
  const keyOf = (type, options) =>
    `${type} ${typeof options === "object" ? Boolean(options?.capture) : Boolean(options)}`;
  EventTarget.prototype.addEventListener = function (type, listener, options) {
    // Signals for aborting come and go with their requests.
    if (listener && !(this instanceof AbortSignal) && !options?.once && !options?.signal) {
      const target = this ?? window;
      const all = kept.get(target) ?? new Map();
      kept.set(target, all);
      const set = all.get(keyOf(type, options)) ?? new Set();
      all.set(keyOf(type, options), set);
      if (!set.has(listener)) counted.listeners++;
      set.add(listener);
    }
    return addEventListener.call(this, type, listener, options);
  };
  EventTarget.prototype.removeEventListener = function (type, listener, options) {
    if (
      kept
        .get(this ?? window)
        ?.get(keyOf(type, options))
        ?.delete(listener)
    )
      counted.listeners--;
    return removeEventListener.call(this, type, listener, options);
  };
}

/**
 * Reads until what is read equals `expected`, or fulfils it if that is a function, and answers it. What is not there
 * yet is read again too. Fails with what was read last.
 */
export async function eventually(read, expected, what = "") {
  const limit = Date.now() + LONGEST_WAIT;
  for (;;) {
    let [value, error] = [undefined, undefined];
    try {
      value = await read();
      if (typeof expected === "function" ? expected(value) : isDeepStrictEqual(value, expected)) return value;
    } catch (problem) {
      error = problem;
    }
    if (Date.now() > limit) {
      const last = error ? String(error) : inspect(value, { depth: 8, maxStringLength: 1000 });
      const wanted = typeof expected === "function" ? String(expected) : inspect(expected, { depth: 6 });
      throw new Error(`${what || String(read)} never came to be.\nexpected: ${wanted}\nread last: ${last}`);
    }
    await new Promise((done) => setTimeout(done, 40));
  }
}

/** Where an element is once it stands still: its box, and the transform of its style. */
export function still(locator) {
  const read = async () => {
    await locator.waitFor();
    return locator.evaluate(
      (element, limit) =>
        new Promise((done, fail) => {
          const end = performance.now() + limit;
          let [last, frames] = ["", 0];
          const look = () => {
            if (!element.isConnected) return fail(new Error("It was taken away."));
            if (performance.now() > end) return fail(new Error(`It never stood still: ${last}`));
            const { x, y, width, height } = element.getBoundingClientRect();
            const place = { x, y, width, height, transform: element.style.transform };
            frames = JSON.stringify(place) === last ? frames + 1 : 0;
            last = JSON.stringify(place);
            return frames < 3 ? requestAnimationFrame(look) : done(place);
          };
          look();
        }),
      LONGEST_WAIT,
    );
  };
  return eventually(read, (place) => place.width > 0, `a place of ${locator}`);
}

/** Turns the wheel where the pointer is, and waits until the page has heard it. */
export async function turnWheel(page, by) {
  await page.evaluate(() => {
    const once = { once: true, capture: true, passive: true };
    window.turned = new Promise((done) => window.addEventListener("wheel", () => done(), once));
  });
  await page.mouse.wheel(0, by);
  await page.evaluate(() => window.turned);
}

/** What the page's root element says of its state: see showStateOn() of the page. */
export const factsOf = (page) => page.evaluate(() => ({ ...document.documentElement.dataset }));

/** The document as Save writes it. */
export async function saved(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Control+Shift+s")]);
  return JSON.parse(readFileSync(await download.path(), "utf8"));
}

/** Shows the whole graph: a wide one opens at its end, where it can be read. */
export async function wholeGraph(page) {
  const graph = page.getByRole("region", { name: "Graph" });
  if (await graph.isVisible()) await graph.getByRole("button", { name: "Fit graph" }).click();
}

/** Selects a node by a click on its title. */
export async function selectNode(page, id) {
  await wholeGraph(page);
  const graph = page.getByRole("region", { name: "Graph" });
  const node = graph.getByRole("group", { name: new RegExp(`, ${id}$`) });
  await node.click({ position: { x: 24, y: 6 } });
  await page.locator(`.react-flow__node.selected[data-id="${id}"]`).waitFor();
}

/** Waits until the newest input is shown in full quality. */
export async function settled(page, timeout = LONGEST_WAIT) {
  await page.waitForFunction(
    () => {
      const { state, revision, shown, quality } = document.documentElement.dataset;
      return state === "idle" && revision === shown && quality === "final";
    },
    undefined,
    { timeout },
  );
}

/** Waits until the model fills more than this share of its view, and less than `most`. */
export function covered(page, least, most = 1) {
  return eventually(
    () => coverage(page),
    (share) => share > least && share < most,
    `a model on more than ${least} of its view`,
  );
}

export const canvasOf = (page) => page.getByRole("img", { name: /^The model/ });

/** The model's view as a picture, once nothing is drawn any more. */
export async function picture(page) {
  await quiet(page);
  return canvasOf(page).screenshot();
}

/** Waits until the view has drawn what is there, drawn it finely, and draws no more. */
export function quiet(page) {
  return canvasOf(page).evaluate(
    (canvas, limit) =>
      new Promise((done, fail) => {
        const end = performance.now() + limit;
        let [last, frames] = ["", 0];
        const look = () => {
          const { frames: drawn, still } = canvas.dataset;
          frames = still === "true" && drawn === last ? frames + 1 : 0;
          last = drawn;
          if (frames >= 3) done();
          else if (performance.now() < end) requestAnimationFrame(look);
          else fail(new Error(`The view never rested: ${JSON.stringify(canvas.dataset)}`));
        };
        look();
      }),
    LONGEST_WAIT,
  );
}

/** Fails unless `act` changes the picture. */
export async function changes(page, what, act) {
  const last = await picture(page);
  await act();
  await eventually(
    () => picture(page),
    (now) => !now.equals(last),
    `another picture after ${what}`,
  );
}

/** Share of the model view's pixels that differ clearly from its corners' background. */
async function coverage(page) {
  const shot = (await picture(page)).toString("base64");
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const surface = document.createElement("canvas");
    [surface.width, surface.height] = [image.width, image.height];
    const context = surface.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, image.width, image.height).data;
    let different = 0;
    for (let row = 0; row < image.height; row++) {
      // The background is a vertical gradient, so each row is compared with its own border.
      const edge = 4 * (row * image.width + 2);
      for (let column = 0; column < image.width; column++) {
        const at = 4 * (row * image.width + column);
        const distance =
          Math.abs(pixels[at] - pixels[edge]) +
          Math.abs(pixels[at + 1] - pixels[edge + 1]) +
          Math.abs(pixels[at + 2] - pixels[edge + 2]);
        if (distance > 60) different++;
      }
    }
    return different / (image.width * image.height);
  }, shot);
}
