//! Programs: sequences of operators as data, for everything that tests a structure by changing it.
//!
//! A structure that implements [`Kernel`] can be driven by them; [`Dcel`](crate::dcel::Dcel) does, over every store.

mod dcel;
mod kernel;

pub use kernel::{Corner, CornerOf, Kernel, Refusal};
