// Times an audit in Node: the module is loaded and warm, as in a page that stays open.
//
//     node bench.mjs FILE [LAYER]

import { readFile } from "node:fs/promises";
import { load } from "./package/sync.js";

const [file, layer] = process.argv.slice(2);
const bytes = await readFile(file);
const twinedge = await load();
for (let i = 0; i < 5; i++) {
  const [start, before] = [performance.now(), process.cpuUsage()];
  twinedge.audit({ name: file, bytes }, layer ? { layer } : {});
  const { user } = process.cpuUsage(before);
  console.log(`${(performance.now() - start).toFixed(0)} ms, ${(user / 1000).toFixed(0)} ms of them of a processor`);
}
