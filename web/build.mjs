// Builds the page into dist/: type check, bundle with hashed names, decoder, notices, gzip files beside.
// `node build.mjs --no-check` leaves the type check out.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import esbuild from "esbuild";

const here = path.dirname(fileURLToPath(import.meta.url));
const dist = path.join(here, "dist");
const require = createRequire(import.meta.url);
const packageFolder = (name) => {
  let folder = path.join(here, "node_modules", name);
  if (!existsSync(folder)) folder = path.dirname(require.resolve(`${name}/package.json`));
  return folder;
};

const LARGEST_SCRIPTS = 500_000;

async function main() {
  if (!process.argv.includes("--no-check")) typeCheck();
  rmSync(dist, { recursive: true, force: true });
  const result = await esbuild.build({
    absWorkingDir: here,
    entryPoints: {
      main: "src/main.tsx",
      styles: "src/app/styles.css",
      embed: "src/embed.tsx",
      "embed-styles": "src/embed/embed.css",
    },
    bundle: true,
    splitting: true,
    format: "esm",
    target: "es2022",
    minify: true,
    metafile: true,
    sourcemap: false,
    legalComments: "none",
    outdir: "dist/assets",
    entryNames: "[name]-[hash]",
    chunkNames: "[name]-[hash]",
    assetNames: "[name]-[hash]",
    loader: { ".woff2": "file" },
    define: { "process.env.NODE_ENV": '"production"' },
    logLevel: "warning",
  });
  // The theme is set before the first paint, so it is a classic script of its own.
  const theme = await esbuild.build({
    absWorkingDir: here,
    entryPoints: { theme: "src/app/early_theme.ts", "embed-theme": "src/embed/theme.ts" },
    bundle: true,
    format: "iife",
    target: "es2022",
    minify: true,
    metafile: true,
    outdir: "dist/assets",
    entryNames: "[name]-[hash]",
  });
  const outputs = [...Object.keys(result.metafile.outputs), ...Object.keys(theme.metafile.outputs)];
  const asset = (pattern) => outputs.find((name) => pattern.test(name)).replace(/^dist\//, "");
  const addresses = {
    favicon: copyHashed("favicon.svg"),
    font: asset(/inter-latin.*\.woff2$/),
    styles: asset(/\/styles-\w+\.css$/),
    theme: asset(/\/theme-\w+\.js$/),
    main: asset(/\/main-\w+\.js$/),
    embed: asset(/\/embed-\w+\.js$/),
    embedStyles: asset(/\/embed-styles-\w+\.css$/),
    embedTheme: asset(/\/embed-theme-\w+\.js$/),
  };
  writePage("index.html", "index.html", addresses);
  writePage("embed.html", "embed/index.html", addresses);
  for (const entry of [addresses.main, addresses.embed]) holdThreeBack(result.metafile, `dist/${entry}`);
  copyDecoder();
  writeNotices(Object.keys(result.metafile.inputs));
  compress(dist);
  reportSizes();
}

function typeCheck() {
  execFileSync(process.execPath, [path.join(packageFolder("typescript"), "bin", "tsc"), "--noEmit"], {
    cwd: here,
    stdio: "inherit",
  });
}

function writePage(template, target, addresses) {
  const page = readFileSync(path.join(here, template), "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => addresses[name]);
  mkdirSync(path.dirname(path.join(dist, target)), { recursive: true });
  writeFileSync(path.join(dist, target), page);
}

function copyHashed(name) {
  const bytes = readFileSync(path.join(here, name));
  const hash = createHash("sha256").update(bytes).digest("hex").slice(0, 8).toUpperCase();
  const { name: stem, ext } = path.parse(name);
  writeFileSync(path.join(dist, "assets", `${stem}-${hash}${ext}`), bytes);
  return `assets/${stem}-${hash}${ext}`;
}

/** Fails if the first script of a page, or one that it cannot start without, holds a part of three. */
function holdThreeBack({ outputs }, first) {
  const names = [first];
  for (const name of names) {
    const { imports, inputs } = outputs[name];
    const part = Object.keys(inputs).find((file) => /node_modules\/three\//.test(file));
    if (part) throw new Error(`${name} holds ${part}; the 3D part is to be loaded after the first paint.`);
    for (const { path: next, kind } of imports) {
      if (kind === "import-statement" && outputs[next] && !names.includes(next)) names.push(next);
    }
  }
}

function copyDecoder() {
  const from = path.join(packageFolder("three"), "examples/jsm/libs/draco/gltf");
  mkdirSync(path.join(dist, "draco"), { recursive: true });
  for (const name of ["draco_decoder.wasm", "draco_wasm_wrapper.js"]) {
    copyFileSync(path.join(from, name), path.join(dist, "draco", name));
  }
}

/** Licenses of everything that is in the bundles, and of the decoder and the font copied beside them. */
function writeNotices(inputs) {
  const names = new Set(["three", "@fontsource-variable/inter"]);
  for (const input of inputs) {
    const match = /.*node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
    if (match) names.add(match[1]);
  }
  const parts = [...names].sort().map((name) => {
    const folder = packageFolder(name);
    const { version, license } = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
    const file = readdirSync(folder).find((entry) => /^licen[sc]e/i.test(entry));
    const text = file ? readFileSync(path.join(folder, file), "utf8").trim() : sameAuthorsLicense(name);
    return `${name} ${version} (${license})\n\n${text}\n`;
  });
  const draco =
    "Draco decoder (draco/draco_decoder.wasm, draco/draco_wasm_wrapper.js), Apache-2.0\n\n" +
    "Copyright The Draco Authors. Licensed under the Apache License, Version 2.0;\n" +
    "the license is at https://www.apache.org/licenses/LICENSE-2.0\n";
  const rule = `\n${"-".repeat(80)}\n\n`;
  writeFileSync(path.join(dist, "THIRD_PARTY_NOTICES.txt"), [...parts, draco].join(rule));
}

/** A part of a larger package that comes without the license file of that one. */
function sameAuthorsLicense(name) {
  const whole = { "react-remove-scroll-bar": "react-remove-scroll" }[name];
  if (!whole) throw new Error(`${name} has no license file`);
  const [part, other] = [name, whole].map((one) =>
    JSON.parse(readFileSync(path.join(packageFolder(one), "package.json"), "utf8")),
  );
  if (part.license !== other.license || part.author !== other.author) throw new Error(`${name} is not of ${whole}`);
  return readFileSync(path.join(packageFolder(whole), "LICENSE"), "utf8").trim();
}

function filesBelow(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const full = path.join(folder, entry.name);
    return entry.isDirectory() ? filesBelow(full) : [full];
  });
}

function compress(folder) {
  for (const file of filesBelow(folder)) {
    if (/\.(js|css|html|svg|wasm|txt)$/.test(file))
      writeFileSync(`${file}.gz`, gzipSync(readFileSync(file), { level: 9 }));
  }
}

function reportSizes() {
  let total = 0;
  for (const file of filesBelow(path.join(dist, "assets")).filter((name) => /\.(js|css)\.gz$/.test(name))) {
    const size = readFileSync(file).length;
    if (file.endsWith(".js.gz")) total += size;
    console.log(`${String(size).padStart(8)}  ${path.relative(dist, file)}`);
  }
  console.log(`${String(total).padStart(8)}  all scripts, gzip (at most ${LARGEST_SCRIPTS})`);
  if (total > LARGEST_SCRIPTS) throw new Error("The scripts are too large.");
}

await main();
