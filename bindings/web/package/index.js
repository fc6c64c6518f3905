// The functions, in a worker: the page stays usable, and work can be cancelled.

import { errorOf, InternalError } from "./errors.js";
import { moduleOf, progressOf, read, requests, returned } from "./sync.js";

export * from "./errors.js";

const isNode = typeof process === "object" && Boolean(process.versions?.node);

/** A worker of a browser. */
const browserWorker = () => new Worker(new URL("./worker.js", import.meta.url), { type: "module" });

async function workerOf(spawn) {
  if (!isNode) {
    const worker = spawn();
    return {
      post: (message) => worker.postMessage(message),
      on: (what, handler) => worker.addEventListener(what, (event) => handler(what === "message" ? event.data : event)),
      end: () => worker.terminate(),
    };
  }
  const { Worker: NodeWorker } = await import(/* webpackIgnore: true */ "node:worker_threads");
  const worker = new NodeWorker(new URL("./worker.js", import.meta.url));
  // Node may end when nothing is asked.
  worker.unref();
  return {
    post: (message) => worker.postMessage(message),
    on: (what, handler) => worker.on(what, handler),
    end: () => void worker.terminate(),
    hold: (isHeld) => (isHeld ? worker.ref() : worker.unref()),
  };
}

/** The functions, over a worker of their own. */
export class TwinedgeWorker {
  #source;
  #spawn;
  #module = null;
  #worker = null;
  #waiting = new Map();
  #next = 0;

  /** `source` says from where the module is loaded, as `load` of `twinedge/sync` takes it, and `spawn` makes the worker in a browser. */
  constructor(source, spawn = browserWorker) {
    this.#source = source;
    this.#spawn = spawn;
    for (const name of Object.keys(requests)) {
      this[name] = async (input, ...rest) => returned(name, await this.#ask(requests[name](await read(input), ...rest), rest), rest.at(-1));
    }
  }

  async #ask(request, args) {
    const signal = args.at(-1)?.signal instanceof AbortSignal ? args.at(-1).signal : null;
    signal?.throwIfAborted();
    this.#module ??= moduleOf(this.#source ?? new URL("./twinedge.wasm", import.meta.url));
    this.#worker ??= this.#begin();
    const worker = await this.#worker.catch((error) => {
      [this.#module, this.#worker] = [null, null];
      throw error;
    });
    signal?.throwIfAborted();
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      const cancel = () => this.#end(signal.reason, id);
      const settle = (act) => (value) => {
        signal?.removeEventListener("abort", cancel);
        this.#waiting.delete(id);
        if (this.#waiting.size === 0) worker.hold?.(false);
        act(value);
      };
      this.#waiting.set(id, { resolve: settle(resolve), reject: settle(reject), progress: progressOf(args), request });
      signal?.addEventListener("abort", cancel, { once: true });
      worker.hold?.(true);
      worker.post({ id, request });
    });
  }

  async #begin() {
    const [worker, module] = [await workerOf(this.#spawn), await this.#module];
    worker.on("message", ({ id, stage, ok, error }) => {
      const asked = this.#waiting.get(id);
      if (!asked) return;
      if (stage !== undefined) asked.progress?.(stage);
      else if (error) asked.reject(errorOf(error));
      else asked.resolve(ok);
    });
    worker.on("error", (event) => this.#end(new InternalError("internal", `the worker failed: ${event?.message ?? event}`)));
    worker.post({ module });
    return worker;
  }

  /** Ends the worker. The request with this number is refused with the reason, or all are; others are asked again of a new worker. */
  async #end(reason, id = null) {
    const worker = this.#worker;
    this.#worker = null;
    const rest = [...this.#waiting];
    (await worker)?.end();
    for (const [number, asked] of rest) {
      if (id === null || number === id) asked.reject(reason);
    }
    if (this.#waiting.size === 0) return;
    this.#worker ??= this.#begin();
    const next = await this.#worker;
    for (const [number, { request }] of this.#waiting) next.post({ id: number, request });
  }

  /** Ends the worker and refuses what was asked of it. The next request starts another one. */
  close() {
    return this.#end(new InternalError("internal", "the worker was closed"));
  }
}

const shared = new TwinedgeWorker();

export const { audit, auditPage, auditWithPage, acceptAll, findings, clean, convert, neighbours, voronoi, validate, check } = shared;

/** Ends the worker that the functions share. */
export const close = () => shared.close();
