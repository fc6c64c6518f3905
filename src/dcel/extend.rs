//! The interface for a structure around a [`Dcel`](super::Dcel), such as a map with coordinates: it is made of columns, its changes are undone
//! with those of the links, and records of its own have attributes.
//!
//! | to | implement or call |
//! | --- | --- |
//! | be undone and redone by a [`History`](super::History) | [`Recorder`] |
//! | be validated after each change by an [`Audited`](super::Audited) | [`Auditable`] |
//! | take back an edit of several operators | [`Dcel::begin_log`](super::Dcel::begin_log), [`Dcel::log_place`](super::Dcel::log_place), [`Dcel::roll_back`](super::Dcel::roll_back), [`Rewrite::apply`] |
//! | be made of columns | [`Assembly`] |
//! | have attributes of other records | [`Attributed`](super::Attributed) for a type of its own, and the methods of [`Attributes`] |

pub use super::assemble::{Assembly, AssemblyError};
pub use super::audited::Auditable;
pub use super::recorder::{Access, LogPlace, Recorder, Rewrite};
pub use crate::store::attributes::{Attributes, Kind, Saved, Step};
pub use crate::store::{BoundaryStart, VertexLink, Way};
