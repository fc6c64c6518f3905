import type { Functions } from "./index.js";

export * from "./index.js";

/** The functions, each done when it returns. */
export type Twinedge = {
  [Name in keyof Functions]: Functions[Name] extends {
    (input: infer I, options: infer O): Promise<infer R>;
    (input: infer J, options?: infer P): Promise<infer S>;
  }
    ? { (input: I, options: O): R; (input: J, options?: P): S }
    : Functions[Name] extends (...args: infer A) => Promise<infer R>
      ? (...args: A) => R
      : never;
};

/** Loads the module, from where the package is unless something else is given. */
export function load(
  source?: WebAssembly.Module | Uint8Array | ArrayBuffer | Response | URL | string | Promise<Response>,
): Promise<Twinedge>;
