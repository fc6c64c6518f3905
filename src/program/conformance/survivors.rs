//! Do the vertices keep their handles?
//!
//! Data is kept by handles. A structure that gives a vertex another handle is the same map, and what was kept of the vertex is lost.

use super::answers::Vertices;
use super::difference::Difference;
use super::settings::End;
use crate::program::operators::{Call, Op};
use crate::program::pointer_model::{PointerModel, PointerModelVertex};
use crate::program::run::runner::Runner;
use crate::program::subject::Subject;
use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

/// The vertices of which an operator may give one the handle of another.
pub(super) enum Exchange {
    Nothing,
    /// Two vertices become one: the ends of an edge, and those of which the handle may be kept.
    Merged {
        ends: [PointerModelVertex; 2],
        may_be_kept: Vec<PointerModelVertex>,
    },
    /// One vertex becomes two.
    Split,
}

impl Exchange {
    /// Tells which vertices an operator may exchange, before it is run.
    pub(super) fn of<K: Subject>(
        op: Op,
        reference: &Runner<PointerModel>,
        subject: &Runner<K>,
        survivor: Option<End>,
    ) -> Self {
        if matches!(op, Op::SplitVertex { .. }) {
            return Self::Split;
        }
        let Some([h, twin]) = merging(op, reference) else { return Self::Nothing };
        let model = reference.subject();
        let (Ok(origin), Ok(target)) = (model.origin_of(h), model.origin_of(twin)) else { return Self::Nothing };
        // A half-edge of the border that is not stored stands for its twin, of which the ends are the other way round.
        let is_stored = merging(op, subject).is_some_and(|[h, _]| subject.subject().next_of(h).is_ok());
        let may_be_kept = match survivor.filter(|_| is_stored) {
            None => vec![origin, target],
            Some(End::Origin) => vec![origin],
            Some(End::Target) => vec![target],
        };
        Self::Merged { ends: [origin, target], may_be_kept }
    }

    /// Finds a vertex that has lost its handle. O(n log n), and O(n) more for a vertex that is split.
    pub(super) fn compare<K: Subject>(&self, before: &Vertices<K>, now: &Vertices<K>) -> Result<(), Difference> {
        for (vertex, was) in before.iter() {
            let Some(is) = now.get(vertex) else { continue };
            let allowed = match self {
                Self::Merged { ends, may_be_kept } if ends.contains(&vertex) => {
                    may_be_kept.iter().filter_map(|end| before.get(*end)).collect()
                }
                Self::Split if now.iter().any(|(other, handle)| handle == was && before.get(other).is_none()) => {
                    continue;
                }
                _ => vec![was],
            };
            if !allowed.contains(&is) {
                let expected: Vec<_> = allowed.iter().map(|handle| format!("{handle:?}")).collect();
                return Err(Difference::Vertex { expected, found: format!("{is:?}") });
            }
        }
        Ok(())
    }
}

/// The half-edge whose two ends an operator makes one, and its twin.
fn merging<K: Subject>(op: Op, on: &Runner<K>) -> Option<[K::HalfEdge; 2]> {
    let (Op::ContractEdge { .. } | Op::MeshCollapseEdge { .. }) = op else { return None };
    match on.resolve(op) {
        Ok(Call::ContractEdge { half_edge } | Call::MeshCollapseEdge { half_edge }) => {
            Some([half_edge, on.subject().twin_of(half_edge).ok()?])
        }
        _ => None,
    }
}
