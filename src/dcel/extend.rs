//! The interface for a structure around a [`Dcel`](super::Dcel), such as a map with coordinates: building it from
//! columns, undoing its own changes together with changes of links, and attributes of its own records.
//!
//! | to | implement or call |
//! | --- | --- |
//! | undo and redo with a [`History`](super::History) | [`Recorder`] |
//! | validate after each change with [`Audited`](super::Audited) | [`Auditable`] |
//! | roll back an edit of several operators | [`Dcel::begin_log`](super::Dcel::begin_log), [`Dcel::log_place`](super::Dcel::log_place), [`Dcel::roll_back`](super::Dcel::roll_back), [`Rewrite::apply`] |
//! | build from columns | [`Assembly`] |
//! | attach attributes to other records | [`Attributed`](super::Attributed) for a type of its own, and the methods of [`Attributes`] |

pub use super::assemble::{Assembly, AssemblyError};
pub use super::audited::Auditable;
pub use super::recorder::{Access, LogPlace, Recorder, Rewrite};
pub use crate::store::attributes::{Attributes, Kind, Saved, Step};
pub use crate::store::{BoundaryStart, VertexLink, Way};
