// The module is no larger than a page may be.

import { readFile } from "node:fs/promises";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const LARGEST = 800_000;

const bytes = await readFile(new URL("../package/twinedge.wasm", import.meta.url));
const gzip = gzipSync(bytes, { level: 9 }).length;
const brotli = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 11 } }).length;
console.log(`twinedge.wasm: ${bytes.length} bytes, gzip ${gzip}, brotli ${brotli}`);
const imports = WebAssembly.Module.imports(new WebAssembly.Module(bytes)).map(({ module }) => module);
if (imports.some((module) => module !== "twinedge")) throw new Error(`it imports from ${[...new Set(imports)]}`);
if (Math.min(gzip, brotli) > LARGEST) throw new Error(`it has more than ${LARGEST} bytes, compressed`);
