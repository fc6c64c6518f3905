// Errors that are thrown.

/** Something that could not be done. `code` says what kind of error it is, `place` where in the input. */
export class TwinedgeError extends Error {
  constructor(code, message, place = null) {
    super(message);
    this.name = new.target.name;
    this.code = code;
    this.place = place;
  }
}

/** The input cannot be read, or is not what was asked about. */
export class InputError extends TwinedgeError {}

/** An option, or an argument, is none that there is. */
export class OptionError extends TwinedgeError {}

/** The input is larger than the memory that a page has. The program `twinedge` takes it. */
export class TooLargeError extends TwinedgeError {}

/** An error of twinedge itself. The message says where in its source. */
export class InternalError extends TwinedgeError {}

const classes = { option: OptionError, "too-large": TooLargeError, internal: InternalError };

/** The error that an answer has, or a message from a worker. */
export function errorOf({ code, message, place }) {
  return new (classes[code] ?? InputError)(code, message, place);
}
