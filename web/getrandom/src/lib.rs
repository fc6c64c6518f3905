//! In the place of the crate of this name, which brings the glue of `wasm-bindgen` with it. The crate `zip` asks for random numbers where it
//! encrypts, which nothing here does.

use std::fmt;

/// There are no random numbers.
#[derive(Clone, Copy, Debug)]
pub struct Error;

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("there are no random numbers")
    }
}

impl std::error::Error for Error {}

/// Fills bytes with random numbers, of which there are none.
///
/// # Errors
/// [`Error`], always.
pub const fn fill(_: &mut [u8]) -> Result<(), Error> {
    Err(Error)
}

/// A random number, of which there are none.
///
/// # Errors
/// [`Error`], always.
pub const fn u64() -> Result<u64, Error> {
    Err(Error)
}
