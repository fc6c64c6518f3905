//! Programs: sequences of operators as data, for everything that tests a structure by changing it.
//!
//! A structure that implements [`Kernel`] can be driven by them; [`Dcel`](crate::dcel::Dcel) does, over every store.

#[cfg(feature = "arbitrary")]
mod arbitrary;
pub mod canonical;
pub mod census;
pub mod choose;
pub mod conformance;
mod dcel;
mod every;
mod interpret;
mod kernel;
mod op;
#[cfg(feature = "quickcheck")]
mod quickcheck;
mod retarget;
mod rust;
mod shrink;
mod simpler;
mod text;
mod textbook;

pub use crate::dcel::{Side, Turn};
pub use every::{every_op, try_every_op};
pub use interpret::{Outcome, Runner};
pub use kernel::{Corner, CornerOf, Kernel, Refusal};
pub use op::{CornerPick, FacePick, HalfEdgePick, InnerPick, Op, Program, SecondPick, VertexPick};
pub use shrink::{candidates, shrink};
pub use text::{Expected, ParseError};
pub use textbook::{Textbook, TextbookFace, TextbookHalfEdge, TextbookVertex};
