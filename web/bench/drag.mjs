// Measures how a drag keeps up: npm run bench [-- example parameter]
// A slider is moved 30 times a second for some seconds; told are updates shown a second and the time from an input to
// its picture. Says nothing about right or wrong; the machine's other work is in the numbers.

import { loadavg } from "node:os";
import { launchBrowser, openPage, Server, settled } from "../e2e/harness.mjs";

const [example = "fig04_boosted_ring", label] = process.argv.slice(2);
const SECONDS = 4;
const INPUTS_PER_SECOND = 30;

const server = new Server();
await server.start();
const browser = await launchBrowser();
try {
  const page = await openPage(browser, server.url, { hash: `#example=${example}`, width: 1280, height: 720 });
  await settled(page);
  const slider = label ? page.getByRole("slider", { name: label, exact: true }) : page.getByRole("slider").first();
  // The first drafts start the decoder and compile shaders.
  for (const key of ["ArrowRight", "ArrowLeft"]) {
    await slider.press(key);
    await settled(page);
  }
  const before = loadavg()[0];
  const result = await slider.evaluate(drag, { seconds: SECONDS, rate: INPUTS_PER_SECOND });
  const { shown, latencies, triangles, longest } = result;
  latencies.sort((a, b) => a - b);
  const at = (share) => latencies[Math.min(latencies.length - 1, Math.floor(share * latencies.length))]?.toFixed(0);
  console.log(`${example}: ${(shown / SECONDS).toFixed(1)} updates/s shown of ${INPUTS_PER_SECOND} inputs/s`);
  console.log(`input to shown: median ${at(0.5)} ms, 95 of 100 within ${at(0.95)} ms`);
  console.log(`triangles of the drafts: ${[...new Set(triangles)].join(", ")}; longest task ${longest.toFixed(0)} ms`);
  console.log(`load of the machine: ${before?.toFixed(1)}`);
} finally {
  await browser.close();
  await server.stop();
}

/** Runs in the page. */
async function drag(element, { seconds, rate }) {
  const facts = document.documentElement.dataset;
  const sent = new Map();
  const latencies = [];
  const triangles = [];
  let longest = 0;
  const tasks = new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) longest = Math.max(longest, entry.duration);
  });
  tasks.observe({ entryTypes: ["longtask"] });
  let shown = 0;
  let last = facts.shown;
  const look = () => {
    if (facts.shown === last) return;
    last = facts.shown;
    shown++;
    const at = sent.get(last);
    if (at !== undefined) latencies.push(performance.now() - at);
    triangles.push(Number(document.querySelector(".statistics span")?.textContent.replace(/\D/g, "")));
  };
  const watch = new MutationObserver(look);
  watch.observe(document.documentElement, { attributeFilter: ["data-shown"] });
  const box = element.getBoundingClientRect();
  const move = (type, share) =>
    element.dispatchEvent(
      new PointerEvent(type, {
        ...{ pointerId: 1, button: 0, buttons: 1, bubbles: true, cancelable: true },
        ...{ clientX: box.left + share * box.width, clientY: box.top + box.height / 2 },
      }),
    );
  // A made-up pointer cannot be captured; the slider asks whether it is.
  element.setPointerCapture = () => undefined;
  element.hasPointerCapture = () => true;
  move("pointerdown", 0.3);
  const started = performance.now();
  for (let input = 0; input < seconds * rate; input++) {
    const due = started + (1000 * input) / rate;
    await new Promise((done) => setTimeout(done, Math.max(0, due - performance.now())));
    move("pointermove", 0.45 + 0.15 * Math.sin(input / 9));
    sent.set(facts.revision, performance.now());
  }
  const result = { shown, latencies, triangles, longest };
  move("pointerup", 0.5);
  watch.disconnect();
  tasks.disconnect();
  return result;
}
