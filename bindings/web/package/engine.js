// The module of WebAssembly and its buffers: a request goes in, an answer comes out.

import { textOf } from "./charsets.js";
import { errorOf, InternalError, TooLargeError } from "./errors.js";

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** From here on a failure to get memory is one of size: a page has 4 GiB. */
const NEARLY_ALL = 3 * 2 ** 30;

/** One module and its memory. After an error of its own it begins anew. */
export class Engine {
  constructor(module) {
    this.module = module;
    this.begin();
  }

  begin() {
    const text = (at, length) => decoder.decode(new Uint8Array(this.exports.memory.buffer, at, length));
    this.panic = null;
    this.exports = new WebAssembly.Instance(this.module, {
      twinedge: {
        stage: (at, length) => this.onStage?.(text(at, length)),
        panicked: (at, length) => (this.panic = text(at, length)),
        decode: (label, labelLength, at, length) => {
          const decoded = textOf(text(label, labelLength), new Uint8Array(this.exports.memory.buffer, at, length));
          this.decoded = decoded === null ? null : encoder.encode(decoded);
          return this.decoded?.length ?? -1;
        },
        decoded: (at) => new Uint8Array(this.exports.memory.buffer, at).set(this.decoded),
      },
    }).exports;
  }

  /** Puts bytes into a buffer, and gives its number. */
  put(bytes) {
    const id = this.exports.buffer(bytes.length);
    new Uint8Array(this.exports.memory.buffer, this.exports.address(id), bytes.length).set(bytes);
    return id;
  }

  /** The bytes of a buffer, which is dropped. */
  take(id) {
    const [at, length] = [this.exports.address(id), this.exports.length(id)];
    const bytes = new Uint8Array(this.exports.memory.buffer, at, length).slice();
    this.exports.free(id);
    return bytes;
  }

  /**
   * Answers a request: an object of JSON in which byte arrays stand for buffers. In the answer they do, too.
   * @throws {TwinedgeError}
   */
  call(request, onStage = null) {
    this.onStage = onStage;
    try {
      const json = JSON.stringify(request, (_, value) => (value instanceof Uint8Array ? { buffer: this.put(value) } : value));
      const answer = this.exports.call(this.put(encoder.encode(json)));
      const { error, ok } = JSON.parse(decoder.decode(this.take(answer)), (_, value) =>
        typeof value?.buffer === "number" ? this.take(value.buffer) : value,
      );
      if (error) throw errorOf(error);
      return ok;
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) throw this.fault(error);
      throw error;
    } finally {
      this.onStage = null;
    }
  }

  /** The error for one of the module's own, after which its memory is not to be trusted. */
  fault(error) {
    const [panic, size] = [this.panic, this.exports.memory.buffer.byteLength];
    this.begin();
    if (panic === null && (size >= NEARLY_ALL || error instanceof RangeError)) {
      return new TooLargeError("too-large", "this is larger than a page can hold: the program `twinedge` takes it");
    }
    return new InternalError("internal", `twinedge failed: ${panic ?? error.message}`);
  }
}
