//! The structure that is validated: the trait that it implements, and the parts that it stores.

mod answers;
mod columns;
mod delegate;
#[cfg(feature = "geometry")]
mod embedding;
mod only;
mod parts;
mod view;

pub use columns::HalfEdgeColumns;
#[cfg(feature = "geometry")]
pub use embedding::Embedding;
pub use only::Only;
pub use parts::{Part, Parts};
pub use view::{BoundaryPlace, Link, Start, View};
