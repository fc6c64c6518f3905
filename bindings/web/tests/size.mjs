// The modules are no larger than a page may be.

import { readFile } from "node:fs/promises";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const LARGEST = { twinedge: 1_600_000, lecture: 240_000 };

for (const [name, largest] of Object.entries(LARGEST)) {
  const bytes = await readFile(new URL(`../package/${name}.wasm`, import.meta.url));
  const gzip = gzipSync(bytes, { level: 9 }).length;
  const brotli = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } }).length;
  console.log(`${name}.wasm: ${bytes.length} bytes, gzip ${gzip}, brotli ${brotli}`);
  const imports = WebAssembly.Module.imports(new WebAssembly.Module(bytes)).map(({ module }) => module);
  if (imports.some((module) => module !== "twinedge")) throw new Error(`${name} imports from ${[...new Set(imports)]}`);
  if (Math.min(gzip, brotli) > largest) throw new Error(`${name} has more than ${largest} bytes, compressed`);
}
