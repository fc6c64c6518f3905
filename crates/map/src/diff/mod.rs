//! Differences between two maps by the ids of their records: displayed, saved, applied and merged.
//!
//! Two people edit copies of a map. [`diff`](diff()) lists changes, and [`merge`](merge()) applies both or names conflicts.
//!
//! ```
//! use twinedge::dcel::{Faces, Policy};
//! use twinedge_map::diff::{Ids, MergeError, diff, merge};
//! use twinedge_map::PlanarMap;
//!
//! let mut base = PlanarMap::new();
//! let (corner, parcel) = (base.add_attribute(Policy::of_vertices().ids(1)), base.add_attribute(Policy::of_faces().ids(1)));
//! let owner = base.add_attribute(Policy::<Faces, String>::of_faces().split_copy().merge_equal());
//! let ids = Ids::new(corner, parcel).values("owner", owner, String::clone, |text| Some(text.into()));
//! let inside = base.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?.faces_split[0].1;
//! base.set_value(owner, inside, "Ada")?;
//!
//! // One copy is divided, in the other one a corner moves.
//! let (mut ours, mut theirs) = (base.clone(), base.clone());
//! let v = |id| base.find(corner, &id).unwrap();
//! ours.insert_segment(v(1), v(3))?;
//! theirs.move_vertex(v(2), [5.0, 0.0])?;
//! assert_eq!(diff(&base, &theirs, &ids)?.to_string(), "vertex 2 moved from (4, 0) to (5, 0)\n");
//! let merged = merge(&base, &ours, &theirs, &ids)?;
//! assert_eq!((merged.dcel().face_count(), merged[v(2)]), (3, [5.0, 0.0].into()));
//!
//! ours.move_vertex(v(2), [6.0, 0.0])?;
//! let refused = merge(&base, &ours, &theirs, &ids);
//! assert!(matches!(refused, Err(MergeError::Conflicts(conflicts)) if conflicts.len() == 1));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Vertices and faces are identified by ids, edges by their ends. A diff contains the outline of each new or reshaped face, so
//! that applying the diff can find it. Records made on two sides must have different ids. Clones of a map share the counter of
//! [`Policy::ids`](twinedge::dcel::Policy::ids), but copies that were loaded separately each start at their given number. Use
//! globally unique ids there, such as UUIDs: [`identified_by`](twinedge::dcel::Policy::identified_by) has an example.
//!
//! All maps must have the same attributes, as clones do. Maps that were loaded separately get them from the first map by
//! [`add_attributes_of`](PlanarMap::add_attributes_of), and then their values by [`set_value`](PlanarMap::set_value).

mod apply;
mod compare;
mod error;
mod faces;
mod ids;
mod merge;
mod record;

pub use compare::diff;
pub use error::{ApplyError, Conflict, DiffError, MergeError};
pub use ids::{Compared, Ids};
pub use merge::merge;
pub use record::{Change, Record};

#[cfg(doc)]
use crate::PlanarMap;
use std::fmt;

/// The changes that lead from one map to another, in the order in which they are applied. Displays one change per line.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Diff {
    /// The number of features of the first map.
    features: usize,
    names: Vec<Option<String>>,
    changes: Vec<(Record, Change)>,
}

impl Diff {
    /// Returns the changes in the order in which they are applied, each with its record.
    #[must_use]
    pub fn changes(&self) -> &[(Record, Change)] {
        &self.changes
    }

    /// Returns the names of the added features.
    #[must_use]
    pub fn names(&self) -> &[Option<String>] {
        &self.names
    }

    /// Returns true if the maps do not differ.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.names.is_empty() && self.changes.is_empty()
    }

    /// Sorts the changes into the order in which they are applied.
    fn in_order(mut self) -> Self {
        self.changes.sort_by_key(|(record, change)| (change.stage(*record), *record));
        self
    }
}

impl fmt::Display for Diff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in self.names.iter().enumerate() {
            writeln!(f, "feature {} added: {}", self.features.saturating_add(i), name.as_deref().unwrap_or("no name"))?;
        }
        self.changes.iter().try_for_each(|(record, change)| writeln!(f, "{record} {change}"))
    }
}
