// Where there is a graphics processor, light is computed: the view is told that there is one, and draws in its way.

import assert from "node:assert/strict";
import { test } from "node:test";
import { RING, useServer, withRing } from "./fixture.mjs";
import { canvasOf, changes, covered, eventually } from "./harness.mjs";

const used = useServer();
/** What WebGL calls the name of its renderer. */
const UNMASKED_RENDERER = 0x9246;

const withStudio = (run) =>
  withRing(
    used,
    {
      hash: RING,
      // Drawn by the processor it takes long: the picture is small.
      ...{ width: 960, height: 540 },
      beforeOpening: (page) =>
        page.addInitScript((wanted) => {
          const { getParameter } = WebGL2RenderingContext.prototype;
          WebGL2RenderingContext.prototype.getParameter = function (name) {
            return name === wanted ? "A graphics processor" : getParameter.call(this, name);
          };
        }, UNMASKED_RENDERER),
    },
    run,
  );

test("a model is lit in a studio, turned, cut open, drawn with lines and colored by curvature", () =>
  withStudio(async (page) => {
    await covered(page, 0.05);
    const isOccluded = () => canvasOf(page).getAttribute("data-occluded");
    await eventually(isOccluded, "true", "darkened where surfaces are near to each other");
    await changes(page, "turning", async () => {
      await canvasOf(page).focus();
      await page.keyboard.press("ArrowLeft");
    });
    await changes(page, "a section", () => page.getByRole("button", { name: "Section", exact: true }).click());
    await changes(page, "no section", () => page.getByRole("button", { name: "Section", exact: true }).click());
    await changes(page, "lines", () => page.getByRole("radio", { name: "Lines" }).click());
    await changes(page, "curvature", () => page.getByRole("radio", { name: "Curvature" }).click());
    await eventually(() => page.getByRole("group", { name: "Curvature legend" }).isVisible(), true);
    assert.equal(await isOccluded(), "false", "colors that tell numbers stay as they are");
    await page.getByRole("radio", { name: "Shaded" }).click();
    await covered(page, 0.05);
  }));

test("the software renderer darkens nothing and draws the model once", () =>
  withRing(used, { hash: RING }, async (page) => {
    await covered(page, 0.05);
    assert.equal(await canvasOf(page).getAttribute("data-occluded"), "false");
  }));
