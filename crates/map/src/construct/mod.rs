//! Building a map from rings, lines and points, all at once.
//!
//! ```text
//!   features ─► gathered: distinct points and segments, rings as darts
//!            ─► cut: segments that meet are cut, if asked for
//!            ─► arranged: rotations, cycles, faces
//!            ─► covered: which features cover which faces
//! ```

mod arrange;
mod builder;
mod counted;
mod cover;
mod cut;
mod error;
mod gathered;
mod rings;
mod unmatched;

pub use builder::Builder;
pub use cut::{Noding, usual_cuts};
pub use error::BuildError;
pub use unmatched::UnmatchedVertex;
