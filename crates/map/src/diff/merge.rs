//! Merging two sets of changes to one map.

use super::Diff;
use super::compare::diff;
use super::error::{Conflict, MergeError};
use super::ids::Ids;
use super::record::{Change, Record};
use crate::PlanarMap;
use std::collections::{BTreeMap, BTreeSet};

/// Merges the changes that two sides made to `base`.
///
/// Values are merged record by record, without policies. If one side splits a face and the other changes its value, the part that
/// keeps the id gets the changed value, and the other parts keep the values from the side that split. If both sides split a face,
/// each part gets an id that a side gave to this part or to a part around it. A fence drawn by both sides counts as two
/// conflicting lines with their own ids. Values of features, half-edges and corners are not compared: the values of `base` stay.
///
/// The merged map uses the keys of `base` for surviving records. New features of `theirs` follow those of `ours`. O(n log n).
///
/// # Errors
/// [`MergeError::Conflicts`] names the records that both sides changed. [`MergeError::Together`] reports changes to different
/// records that don't fit together: lines of one side cross lines of the other, or both cut a face so that no part has its id for
/// both and the parts differ in values or features.
pub fn merge(base: &PlanarMap, ours: &PlanarMap, theirs: &PlanarMap, ids: &Ids) -> Result<PlanarMap, MergeError> {
    let both = diff(base, ours, ids)?.merge(&diff(base, theirs, ids)?)?;
    let mut merged = base.clone();
    both.apply(&mut merged, ids).map_err(MergeError::Together)?;
    Ok(merged)
}

impl Diff {
    /// Combines two diffs of the same map. A change made on both sides is applied once. O(n log n) for n changes.
    ///
    /// # Errors
    /// [`MergeError::Conflicts`], with all of them; [`MergeError::DifferentMaps`], as far as detectable.
    pub fn merge(&self, theirs: &Self) -> Result<Self, MergeError> {
        if self.features != theirs.features {
            return Err(MergeError::DifferentMaps);
        }
        // New features have no ids: the new features of both sides count as the same only if the diffs are equal.
        if self == theirs {
            return Ok(self.clone());
        }
        let renumbered = |change: &Change| match change {
            Change::Features { from, to } => {
                let to = to.iter().map(|f| if *f < self.features { *f } else { f.saturating_add(self.names.len()) });
                Change::Features { from: from.clone(), to: to.collect() }
            }
            change => change.clone(),
        };
        let theirs_changes: Vec<_> =
            theirs.changes.iter().map(|(record, change)| (*record, renumbered(change))).collect();
        let by_record = |changes: &[(Record, Change)]| {
            let mut all: BTreeMap<Record, Vec<Change>> = BTreeMap::new();
            for (record, change) in changes {
                all.entry(*record).or_default().push(change.clone());
            }
            all
        };
        let (ours, others) = (by_record(&self.changes), by_record(&theirs_changes));
        let mut conflicts = Vec::new();
        for (record, change) in &self.changes {
            for other in
                others.get(record).into_iter().flatten().filter(|other| *other != change && change.excludes(other))
            {
                conflicts.push(Conflict { ours: (*record, change.clone()), theirs: (*record, other.clone()) });
            }
        }
        // Edges that one side draws to vertices dropped by the other, and features that one side assigns and the other drops.
        let loose = |changes: &[(Record, Change)], other: &BTreeMap<Record, Vec<Change>>| {
            let mut loose = Vec::new();
            for (record, change) in changes {
                let needs = change.needs(*record).into_iter();
                let dropped = needs.filter(|need| other.get(need).is_some_and(|all| all.contains(&Change::Dropped)));
                loose.extend(dropped.map(|need| ((*record, change.clone()), (need, Change::Dropped))));
            }
            loose
        };
        let our_loose = loose(&self.changes, &others).into_iter();
        conflicts.extend(our_loose.map(|(ours, theirs)| Conflict { ours, theirs }));
        let their_loose = loose(&theirs_changes, &ours).into_iter();
        conflicts.extend(their_loose.map(|(theirs, ours)| Conflict { ours, theirs }));
        // Edges that both sides drop, one permanently, the other to redraw them another way between the same ends.
        let drawn = [Ways::new(&self.changes), Ways::new(&theirs.changes)];
        for (record, change) in self.changes.iter().filter(|(_, change)| *change == Change::Dropped) {
            let by_both = others.get(record).is_some_and(|all| all.contains(change));
            let (Record::Edge(a, b), true) = (*record, by_both) else { continue };
            match drawn.each_ref().map(|ways| ways.first_edge(a, b)) {
                [Some(edge), None] => {
                    conflicts.push(Conflict { ours: (edge, Change::Drawn), theirs: (*record, Change::Dropped) });
                }
                [None, Some(edge)] => {
                    conflicts.push(Conflict { ours: (*record, Change::Dropped), theirs: (edge, Change::Drawn) });
                }
                _ => {}
            }
        }
        if !conflicts.is_empty() {
            return Err(MergeError::Conflicts(conflicts));
        }
        let mut changes = self.changes.clone();
        changes.extend(
            theirs_changes
                .into_iter()
                .filter(|(record, change)| !ours.get(record).is_some_and(|all| all.contains(change))),
        );
        let names = self.names.iter().chain(&theirs.names).cloned().collect();
        Ok(Self { features: self.features, names, changes }.in_order())
    }
}

/// The lines that one side draws through its new vertices.
struct Ways {
    /// For each vertex where such a line ends, the connected group of lines and its first edge.
    ends: BTreeMap<u128, BTreeMap<usize, Record>>,
}

impl Ways {
    fn new(changes: &[(Record, Change)]) -> Self {
        let mut beside: BTreeMap<u128, Vec<u128>> = BTreeMap::new();
        for (record, change) in changes {
            match (*record, change) {
                (Record::Vertex(v), Change::Added(_)) => drop(beside.entry(v).or_default()),
                (Record::Edge(a, b), Change::Drawn) => {
                    beside.entry(a).or_default().push(b);
                    beside.entry(b).or_default().push(a);
                }
                _ => {}
            }
        }
        let added = changes.iter().filter(|(_, change)| matches!(change, Change::Added(_)));
        let mut waiting: BTreeSet<Record> = added.map(|(record, _)| *record).collect();
        let mut ends: BTreeMap<u128, BTreeMap<usize, Record>> = BTreeMap::new();
        let mut pieces = 0;
        while let Some(Record::Vertex(first)) = waiting.pop_first() {
            let mut reached = vec![first];
            while let Some(v) = reached.pop() {
                for next in beside.get(&v).into_iter().flatten() {
                    if waiting.remove(&Record::Vertex(*next)) {
                        reached.push(*next);
                    }
                    let edge = Record::Edge(v.min(*next), v.max(*next));
                    ends.entry(*next).or_default().entry(pieces).or_insert(edge);
                }
            }
            pieces += 1;
        }
        Self { ends }
    }

    fn first_edge(&self, a: u128, b: u128) -> Option<Record> {
        let (from, to) = (self.ends.get(&a)?, self.ends.get(&b)?);
        from.iter().find(|(piece, _)| to.contains_key(piece)).map(|(_, edge)| *edge)
    }
}
