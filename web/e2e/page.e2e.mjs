// The page itself: themes, narrow windows, the 3D view's settings, the keyboard, a server that goes away.

import { test } from "node:test";
import { useServer, withCleanPage } from "./fixture.mjs";
import { canvasOf, changes, covered, eventually, settled, still } from "./harness.mjs";

const used = useServer();
const { server } = used;

const withPage = (options, run) => withCleanPage(used, options, run);

const themeOf = (page) => page.evaluate(() => document.documentElement.dataset.theme);

test("the theme follows the system until it is chosen, and the choice is remembered", () =>
  withPage({ theme: "light" }, async (page) => {
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    await eventually(() => themeOf(page), "light");
    await settled(page);
    const light = await background();
    await page.getByRole("button", { name: "Use the dark theme" }).click();
    await eventually(() => themeOf(page), "dark");
    const dark = await eventually(background, (color) => color !== light);
    await page.reload();
    await eventually(() => themeOf(page), "dark");
    await eventually(background, dark);
    await page.getByRole("button", { name: "Use the light theme" }).click();
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
    await settled(page);
  }));

test("text is readable in both themes", async () => {
  for (const theme of ["dark", "light"]) {
    await withPage({ theme }, async (page) => {
      await settled(page);
      const low = () =>
        page.evaluate(() => {
          const style = getComputedStyle(document.documentElement);
          const luminance = (name) => {
            const hex = style.getPropertyValue(name).trim();
            const [r, g, b] = [1, 3, 5]
              .map((at) => parseInt(hex.slice(at, at + 2), 16) / 255)
              .map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
          };
          const pairs = ["--text", "--text2", "--text3", "--error", "--accent-text"].flatMap((text) =>
            ["--bg0", "--bg1", "--bg2"].map((ground) => [text, ground]),
          );
          pairs.push(
            ["--error", "--error-soft"],
            ["--accent-text", "--accent-soft"],
            ["--text", "--warning-soft"],
            ["--text", "--bg3"],
          );
          return pairs
            .map(([text, ground]) => {
              const [a, b] = [luminance(text), luminance(ground)].sort((x, y) => y - x);
              return { text, ground, ratio: (a + 0.05) / (b + 0.05) };
            })
            .filter(({ ratio }) => ratio < 4.5);
        });
      await eventually(low, [], `contrast in the ${theme} theme`);
    });
  }
});

test("every button and field has a name", () =>
  withPage({}, async (page) => {
    await settled(page);
    const nameless = () =>
      page.evaluate(() =>
        [...document.querySelectorAll("button, input, select, [role=slider], [role=separator], [role=tab]")]
          .filter(
            (item) => !(item.getAttribute("aria-label") || item.textContent.trim() || item.labels?.[0]?.textContent),
          )
          .map((item) => item.outerHTML.slice(0, 120)),
      );
    await eventually(nameless, []);
  }));

test("a narrow window has tabs instead of panes, and the model survives the change", () =>
  withPage({ width: 800, height: 800 }, async (page) => {
    await settled(page);
    const panes = page.getByRole("tablist", { name: "Panes" });
    await panes.getByRole("tab", { name: "Examples" }).click();
    const cards = page.getByRole("navigation", { name: "Examples" }).getByRole("button");
    await cards.nth(1).click();
    await page.waitForFunction(() => location.hash.startsWith("#example="));
    await settled(page);
    await panes.getByRole("tab", { name: "Model", selected: true }).waitFor();
    await covered(page, 0.03);
    await panes.getByRole("tab", { name: "Graph" }).click();
    await page.locator(".node").first().waitFor();
    await eventually(() => page.evaluate(() => document.documentElement.scrollWidth), 800);
    await page.setViewportSize({ width: 1280, height: 720 });
    await panes.waitFor({ state: "detached" });
    // The model is drawn again in the new pane.
    await covered(page, 0.03);
  }));

test("shading, grid and axes can be chosen, and the view is turned with mouse and keys", () =>
  withPage({}, async (page) => {
    await settled(page);
    const canvas = canvasOf(page);
    const changed = (what, act) => changes(page, what, act);
    for (const mode of ["Lines", "Wire", "Normals", "Shaded"])
      await changed(mode, () => page.getByRole("radio", { name: mode, exact: true }).click());
    await changed("grid", () => page.getByRole("button", { name: "Grid", exact: true }).click());
    await changed("axes", () => page.getByRole("button", { name: "Axes", exact: true }).click());
    const { x, y, width, height } = await still(canvas);
    await changed("orbit", async () => {
      await page.mouse.move(x + width / 2, y + height / 2);
      await page.mouse.down();
      await page.mouse.move(x + width / 2 + 90, y + height / 2 + 40, { steps: 5 });
      await page.mouse.up();
    });
    await changed("zoom", () => page.mouse.wheel(0, 400));
    await changed("frame", () => page.keyboard.press("f"));
    await changed("home", () => page.keyboard.press("Home"));
    await canvas.focus();
    await changed("arrow key", () => page.keyboard.press("ArrowLeft"));
  }));

test("choosing a node tells what it is", () =>
  withPage({}, async (page) => {
    await settled(page);
    await page.locator(".react-flow__node").first().focus();
    await page.keyboard.press("Enter");
    await page.getByRole("tab", { name: "Node" }).click();
    const panel = page.getByRole("tabpanel", { name: "Node" });
    await panel.getByRole("heading", { level: 2 }).waitFor();
    await panel.getByRole("group", { name: /^Inputs of / }).waitFor();
  }));

test(
  "a server that goes away is announced, and the page goes on by itself when it is back",
  { skip: !server.isOurs },
  () =>
    withPage({ expectOutage: true }, async (page) => {
      await settled(page);
      await server.stop();
      const slider = page.getByRole("slider").first();
      await slider.press("PageUp");
      await page.getByText("The server does not answer.").waitFor();
      await page.waitForFunction(() => document.documentElement.dataset.state === "error");
      // The last picture stays.
      await covered(page, 0.03);
      const title = page.getByRole("textbox", { name: "Title of the graph" });
      await title.fill("Edited while the server was away");
      await title.press("Enter");
      await page.getByText("edited", { exact: true }).waitFor();
      await server.start();
      await settled(page);
      await eventually(() => page.getByText("The server does not answer.").count(), 0);
      await eventually(() => title.inputValue(), "Edited while the server was away");
    }),
);
