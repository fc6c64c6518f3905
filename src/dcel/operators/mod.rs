//! The operators. Each makes all its checks before it changes anything.

/// Announces to the attributes, if there are any, what is about to change, and returns their refusal.
macro_rules! announce {
    ($dcel:ident.$announce:ident($($argument:expr),*)) => {
        #[cfg(feature = "near")]
        if $dcel.has_attributes() {
            $dcel.$announce($($argument),*)?;
        }
    };
}

/// Tells the attributes, if there are any, what was made.
macro_rules! settle {
    ($dcel:ident.$settle:ident($($argument:expr),*)) => {
        #[cfg(feature = "near")]
        if $dcel.has_attributes() {
            $dcel.$settle($($argument),*);
        }
    };
}

mod checked;
mod connect;
mod corner;
mod flip;
#[cfg(feature = "near")]
mod following;
mod isolated;
mod move_inner;
mod remove;
mod split_edge;
mod split_vertex;
mod walk;

pub use connect::{Connected, Connection, Side, Split};
pub use corner::Corner;
pub use flip::Turn;
pub use isolated::{AddedVertex, RemovedVertex};
pub use remove::RemovedEdge;
pub use split_edge::{JoinedEdges, SplitEdge};
pub use split_vertex::{ContractedEdge, SplitVertex};
