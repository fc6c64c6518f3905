// The module and its worker, which are in the page itself: a page from a folder may load nothing.

// The bundler puts both here.
import packed from "module.wasm.gz";
import workerText from "site-worker";

/** The module of WebAssembly. */
export function wasm() {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream);
}

/** A worker with the text that is in the page. */
export function spawn() {
  return new Worker(URL.createObjectURL(new Blob([workerText], { type: "text/javascript" })));
}
