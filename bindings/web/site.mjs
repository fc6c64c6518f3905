// Puts the static site together: each page is one file, with its style, its script and the module of WebAssembly in it.
//
//     node site.mjs FOLDER        with esbuild in FOLDER/node_modules

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { gzipSync } from "node:zlib";
import { LIMIT } from "./page/refusal.js";

const { build } = createRequire(`${process.argv[2]}/node_modules/`)("esbuild");
const here = (path) => new URL(path, import.meta.url);
const text = (path) => readFile(here(path), "utf8");

const packed = async (module) => ({ contents: gzipSync(await readFile(here(`package/${module}.wasm`)), { level: 9 }), loader: "binary" });

/** A script with all that it imports, for a page without modules. */
async function script(entry, inline = {}) {
  const plugin = {
    name: "inline",
    setup({ onResolve, onLoad }) {
      onResolve({ filter: /^(module\.wasm\.gz|site-worker)$/ }, ({ path }) => ({ path, namespace: "inline" }));
      onLoad({ filter: /.*/, namespace: "inline" }, ({ path }) => inline[path]);
    },
  };
  const { outputFiles } = await build({
    entryPoints: [here(entry).pathname],
    bundle: true,
    write: false,
    format: "iife",
    target: "es2022",
    minify: true,
    legalComments: "none",
    external: ["node:*"],
    logOverride: { "empty-import-meta": "silent" },
    plugins: [plugin],
  });
  // A text that ends the element of the script must not stand in it.
  return outputFiles[0].text.replaceAll("</script", "<\\/script");
}

const worker = { contents: await script("package/worker.js"), loader: "text" };
// The colours are those of the report.
const colours = (await text("../../crates/report/src/html/style.css")).split("* { box-sizing")[0];
const style = colours + (await text("page/style.css"));
const pages = {
  index: { html: "page/index.html", style, script: "page/app.js", module: "twinedge" },
  lecture: { html: "page/lecture/index.html", style: style + (await text("page/lecture/style.css")), script: "page/lecture/app.js", module: "lecture" },
};
await mkdir(here("site/"), { recursive: true });
for (const [name, { html, style, script: entry, module }] of Object.entries(pages)) {
  const inline = { "module.wasm.gz": await packed(module), "site-worker": worker };
  const parts = { style, script: await script(entry, inline), limit: String(LIMIT / 2 ** 20) };
  const page = (await text(html)).replace(/\{(style|script|limit)\}/g, (_, part) => parts[part]);
  await writeFile(here(`site/${name}.html`), page);
}
