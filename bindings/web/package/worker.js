// The module in a worker: a request comes as a message, and the answer goes back as one.

import { Engine } from "./engine.js";

const isNode = typeof process === "object" && Boolean(process.versions?.node);

/** Answers the messages that `listen` hears by `post`. */
function serve(listen, post) {
  let engine = null;
  listen(({ module, id, request }) => {
    if (module) {
      engine = new Engine(module);
      return;
    }
    const answer = { id };
    try {
      answer.ok = engine.call(request, (stage) => post({ id, stage }));
    } catch ({ code = "internal", message, place = null }) {
      answer.error = { code, message, place };
    }
    post(answer);
  });
}

if (isNode) {
  import(/* webpackIgnore: true */ "node:worker_threads").then(({ parentPort: port }) => {
    serve((handler) => port.on("message", handler), (message) => port.postMessage(message));
  });
} else {
  serve((handler) => self.addEventListener("message", ({ data }) => handler(data)), (message) => self.postMessage(message));
}
