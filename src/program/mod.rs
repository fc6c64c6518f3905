//! Programs: sequences of operators as data, for everything that tests a structure by changing it.
//!
//! A structure that implements [`Kernel`] can be driven by them; [`Dcel`](crate::dcel::Dcel) does, over every store.

pub mod canonical;
pub mod census;
mod dcel;
mod every;
mod interpret;
mod kernel;
mod op;
mod rust;
mod text;

pub use crate::dcel::{Side, Turn};
pub use every::{every_op, try_every_op};
pub use interpret::{Outcome, Runner};
pub use kernel::{Corner, CornerOf, Kernel, Refusal};
pub use op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
pub use text::{Expected, ParseError};
