//! Replaces the crate of this name, which brings the glue of `wasm-bindgen` with it. The crate `zip` needs random
//! numbers to encrypt, which nothing here does.

use std::fmt;

/// No random numbers are available.
#[derive(Clone, Copy, Debug)]
pub struct Error;

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("there are no random numbers")
    }
}

impl std::error::Error for Error {}

/// Refuses to fill bytes with random numbers.
///
/// # Errors
/// [`Error`], always.
pub const fn fill(_: &mut [u8]) -> Result<(), Error> {
    Err(Error)
}

/// Refuses to return a random number.
///
/// # Errors
/// [`Error`], always.
pub const fn u64() -> Result<u64, Error> {
    Err(Error)
}
