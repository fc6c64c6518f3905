//! The operators. Each completes all its checks before it changes anything.

mod connect;
mod corner;
mod flip;
mod following;
mod inner;
mod remove;
mod split_edge;
mod split_vertex;
mod walk;

pub use connect::{Connected, Connection, Side, Split};
pub use corner::Corner;
pub use flip::Turn;
pub use inner::{AddedVertex, RemovedVertex};
pub use remove::RemovedEdge;
pub use split_edge::{JoinedEdges, SplitEdge};
pub use split_vertex::{ContractedEdge, SplitVertex};
