// Leaves out of three what this page never draws, as an esbuild plugin: shaders of lit materials, reflections, shadows,
// XR. Three's own bundle holds all of it in one file; its sources can be taken apart.

import { existsSync, readFileSync } from "node:fs";
import path from "node:path";

/** The shaders behind the materials in src/view3d. A material without its shader here fails to compile when drawn. */
const SHADERS = ["meshbasic", "meshmatcap", "meshnormal", "points", "linedashed", "sprite"];

/** Parts of those shaders for features that are off: they stand between #ifdef and #endif, so nothing is in the gap. */
const UNUSED_PARTS =
  /^(alphahash|alphamap|aomap|batching|bumpmap|displacementmap|dithering|envmap|fog|lightmap|morph\w+?|normalmap|skin\w+?|specularmap)(_|$)/;

/** Parts that the renderer puts before every shader by itself. */
const PREFIX_PARTS = ["colorspace_pars_fragment"];

/** Modules replaced by the least that the renderer asks of them. */
const STAND_INS = {
  "renderers/webxr/WebXRManager.js": `export class WebXRManager {
    enabled = false; isPresenting = false;
    getEnvironmentBlendMode() {} addEventListener() {} removeEventListener() {} setAnimationLoop() {} dispose() {}
  }`,
  "renderers/webgl/WebGLEnvironments.js": `export function WebGLEnvironments() {
    return { get: () => null, dispose() {} };
  }`,
  "renderers/webgl/WebGLShadowMap.js": `export function WebGLShadowMap() {
    this.enabled = false; this.render = () => {};
  }`,
  "renderers/webgl/WebGLMorphtargets.js": `export function WebGLMorphtargets() {
    return { update() {} };
  }`,
  "renderers/webgl/WebGLUniformsGroups.js": `export function WebGLUniformsGroups() {
    return { bind() {}, update() {}, dispose() {} };
  }`,
  "renderers/webgl/WebGLOutput.js": "export class WebGLOutput {}",
  "renderers/shaders/DFGLUTData.js": "export const getDFGLUT = () => null;",
};

/** Takes three from its sources and leaves those things out. `folder` is the installed package. */
export function leanThree(folder) {
  const source = path.join(folder, "src");
  for (const name of Object.keys(STAND_INS)) {
    if (!existsSync(path.join(source, name))) throw new Error(`three has no ${name} any more; mend lean_three.mjs.`);
  }
  const used = usedParts(path.join(source, "renderers/shaders"));
  return {
    name: "lean-three",
    setup(build) {
      build.onResolve({ filter: /^three$/ }, () => ({ path: path.join(source, "Three.js"), sideEffects: false }));
      build.onLoad({ filter: /three[\\/]src[\\/].*\.js$/ }, ({ path: file }) => {
        const name = path.relative(source, file).replaceAll(path.sep, "/");
        if (STAND_INS[name]) return { contents: STAND_INS[name] };
        if (name.endsWith(".glsl.js")) return { contents: shader(file, name, used) };
        return undefined;
      });
    },
  };
}

/** Names of the shader parts that the wanted shaders are put together from. */
function usedParts(folder) {
  const used = new Set(PREFIX_PARTS);
  const visit = (file) => {
    for (const [, name] of readFileSync(file, "utf8").matchAll(/^[ \t]*#include +<([\w.]+)>/gm)) {
      if (used.has(name) || UNUSED_PARTS.test(name)) continue;
      used.add(name);
      visit(path.join(folder, `ShaderChunk/${name}.glsl.js`));
    }
  };
  for (const name of SHADERS) visit(path.join(folder, `ShaderLib/${name}.glsl.js`));
  return used;
}

function shader(file, name, used) {
  const stem = path.basename(name, ".glsl.js");
  const isPart = name.includes("ShaderChunk/");
  if (isPart ? used.has(stem) : SHADERS.includes(stem)) return readFileSync(file, "utf8").replace(/`[^`]*`/g, terse);
  return isPart ? 'export default "";' : 'export const vertex = "", fragment = "";';
}

/** A shader without comments, indents and empty lines. */
function terse(text) {
  return text
    .replace(/\/\*[^]*?\*\//g, "")
    .replace(/\/\/.*$/gm, "")
    .replace(/^[ \t]+|[ \t]+$/gm, "")
    .replace(/\n{2,}/g, "\n");
}
