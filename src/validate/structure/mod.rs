//! The structure to validate: the trait that it implements, and the parts that it stores.

mod answers;
mod columns;
mod delegate;
mod only;
mod parts;
mod view;

pub use columns::HalfEdgeColumns;
pub use only::Only;
pub use parts::{Part, Parts};
pub use view::{BoundaryPlace, Link, Start, View};
