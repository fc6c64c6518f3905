//! Values that belong to records, and follow what operators do to them.
//!
//! An operator announces what it does to the records of each kind before it writes anything, and says afterwards which records it made. So
//! a policy that refuses is heard while nothing has changed but values, and these are taken back by the log.

mod column;
mod kind;
mod policy;
mod quantity;

pub use column::{Saved, Step, Value};
pub use kind::{Attributed, Corners, Edges, Faces, HalfEdges, Kind, Vertices};
pub use policy::Policy;
pub use quantity::Quantity;

use crate::store::issuer::structure_offset;
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use column::{AnyColumn, Column};
use core::marker::PhantomData;
use core::{fmt, mem};
use slotmap::{KeyData, SecondaryMap};

/// The name of an attribute of a structure: of values of type `T` that records of one kind have.
///
/// Clones of the structure accept it, and so do those that took over its attributes; other structures do not.
pub struct Attribute<K, T> {
    id: u32,
    of: PhantomData<fn() -> (K, T)>,
}

impl<K, T> Clone for Attribute<K, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<K, T> Copy for Attribute<K, T> {}

impl<K, T> fmt::Debug for Attribute<K, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Attribute").field(&self.id).finish()
    }
}

/// The attributes of a structure, with their values. A structure around a [`Dcel`](crate::dcel::Dcel) says here what it does to records of its own,
/// and by which measures values are shared out.
#[derive(Debug, Default)]
pub struct Attributes {
    columns: Vec<Box<dyn AnyColumn>>,
    /// The values that were overwritten: by the last operator, or by the change that is being made if it is recorded.
    log: Vec<Saved>,
    /// Of two faces that are about to be merged, the one whose area is larger.
    larger: Option<KeyData>,
}

/// A clone has the values, and no log.
impl Clone for Attributes {
    fn clone(&self) -> Self {
        let columns = self.columns.iter().map(|column| column.copied()).collect();
        Self { columns, log: Vec::new(), larger: None }
    }
}

impl Attributes {
    /// Adds an attribute with these values. If the policy gives ids, the other `records` get theirs.
    pub(crate) fn add<K: Attributed, T: Value>(
        &mut self,
        policy: Policy<K, T>,
        values: impl IntoIterator<Item = (K::Key, T)>,
        records: Vec<KeyData>,
    ) -> Attribute<K, T> {
        let id = structure_offset();
        let mut column = Column::new(id, policy);
        for (key, value) in values {
            column.put(key, Some(value), &mut self.log);
        }
        for key in records {
            column.number(key.into(), &mut self.log);
        }
        self.columns.push(Box::new(column));
        Attribute { id, of: PhantomData }
    }

    fn column<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&Column<K, T>> {
        self.columns.iter().find(|column| column.id() == of.id)?.as_any().downcast_ref()
    }

    /// The values of an attribute; none if it is one of another structure.
    pub(crate) fn values<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&SecondaryMap<K::Key, T>> {
        self.column(of).map(|column| &column.values)
    }

    /// The record with this value, if records are found by it.
    pub(crate) fn find<K: Attributed, T: Value>(&self, of: Attribute<K, T>, value: &T) -> Option<K::Key> {
        self.column(of)?.find(value)
    }

    /// The number that the next record gets, if the attribute gives ids.
    pub(crate) fn next_id<K: Attributed>(&self, of: Attribute<K, u64>) -> Option<u64> {
        self.column(of)?.next_id()
    }

    /// Writes a value, or takes it away. Returns the one that was there; an error if the attribute is one of another structure.
    pub(crate) fn put<K: Attributed, T: Value>(
        &mut self,
        of: Attribute<K, T>,
        key: K::Key,
        value: Option<T>,
    ) -> Result<Option<T>, ()> {
        let column = self.columns.iter_mut().find(|column| column.id() == of.id).ok_or(())?;
        let column = column.as_any_mut().downcast_mut::<Column<K, T>>().ok_or(())?;
        Ok(column.put(key, value, &mut self.log))
    }

    /// Does the first part of what an operator is about to do. If a policy refuses, everything is as it was.
    ///
    /// # Errors
    /// The reason of the policy that refuses.
    #[cold]
    pub fn announce(&mut self, steps: &[(Kind, Step)]) -> Result<(), &'static str> {
        let start = self.log.len();
        let larger = self.larger.take();
        self.columns.iter_mut().for_each(|column| column.forget_announced());
        for (kind, step) in steps {
            let is_larger = matches!(step, Step::Merge(_, dropped) if Some(*dropped) == larger);
            for column in self.columns.iter_mut().filter(|column| column.kind() == *kind) {
                if let Err(reason) = column.announce(*step, is_larger, &mut self.log) {
                    self.rewind(start);
                    return Err(reason);
                }
            }
        }
        Ok(())
    }

    /// Gives their values to records that were made, in the order in which they were announced.
    #[cold]
    pub fn settle(&mut self, made: &[(Kind, KeyData)]) {
        for (kind, key) in made {
            for column in self.columns.iter_mut().filter(|column| column.kind() == *kind) {
                column.settle(*key, &mut self.log);
            }
        }
    }

    /// Takes over the attributes of another structure. Where both have the same one, a record that has a value of its own keeps it,
    /// and a number that a record has is not given to another one.
    pub fn extend(&mut self, other: Self) {
        for new in other.columns {
            if !self.columns.iter().any(|column| column.id() == new.id()) {
                let mut column = new.copied();
                column.rename(&|_| None);
                self.columns.push(column);
            }
            for column in self.columns.iter_mut().filter(|column| column.id() == new.id()) {
                column.absorb(&*new, &mut self.log);
            }
        }
    }

    /// Takes back all that was overwritten after so many values.
    fn rewind(&mut self, start: usize) {
        let mut failed = self.log.split_off(start);
        failed.iter_mut().rev().for_each(|saved| self.exchange(saved));
    }

    /// Exchanges a value for the one that is there.
    pub fn exchange(&mut self, saved: &mut Saved) {
        if let Some(column) = self.columns.iter_mut().find(|column| column.id() == saved.id()) {
            saved.exchange(&mut **column);
        }
    }

    /// The values that were overwritten, for good.
    #[must_use]
    pub fn take_log(&mut self) -> Vec<Saved> {
        mem::take(&mut self.log)
    }

    /// The number of values that were overwritten. O(1).
    #[must_use]
    pub fn log_len(&self) -> usize {
        self.log.len()
    }

    /// The values that were overwritten after so many others, for good.
    #[must_use]
    pub fn split_log(&mut self, at: usize) -> Vec<Saved> {
        self.log.split_off(at)
    }

    /// Forgets which values were overwritten.
    pub fn clear_log(&mut self) {
        self.log.clear();
    }

    /// Gives other keys to all values of all records that have one.
    pub(crate) fn rename(&mut self, key: &dyn Fn(Kind, KeyData) -> Option<KeyData>) {
        self.log.clear();
        for column in &mut self.columns {
            let kind = column.kind();
            column.rename(&|old| key(kind, old));
        }
    }
}

impl Attributes {
    /// True if there is a value to be shared out by measures when a record of this kind is split.
    #[must_use]
    pub fn shares(&self, kind: Kind) -> bool {
        self.columns.iter().any(|column| column.kind() == kind && column.shares())
    }

    /// True if the areas of merged faces make a difference.
    #[must_use]
    pub fn is_by_area(&self) -> bool {
        self.columns.iter().any(|column| column.is_by_measure())
    }

    /// True if a vertex on an edge has a value between those of its ends.
    #[must_use]
    pub fn interpolates(&self) -> bool {
        self.columns.iter().any(|column| column.interpolates())
    }

    /// Says which face has the larger area, if one has, of two that are about to be merged.
    pub const fn set_larger(&mut self, face: Option<KeyData>) {
        self.larger = face;
    }

    /// Shares out the values of a record that was split, of which the second of its parts gets this part.
    pub fn share(&mut self, kind: Kind, parts: [KeyData; 2], part: f64) {
        for column in self.columns.iter_mut().filter(|column| column.kind() == kind) {
            column.share(parts, part, &mut self.log);
        }
    }

    /// Gives to a vertex on an edge the values at this part of the way between its ends.
    pub fn interpolate(&mut self, vertex: KeyData, ends: [KeyData; 2], part: f64) {
        for column in self.columns.iter_mut().filter(|column| column.kind() == Kind::Vertex) {
            column.interpolate(vertex, ends, part, &mut self.log);
        }
    }

    /// Gives to faces the values of other records that cover them: each value, and the faces, the largest first, with their areas. If the
    /// policy refuses, everything is as it was. An error if the attribute is one of another structure.
    pub(crate) fn spread<T: Value>(
        &mut self,
        of: Attribute<Faces, T>,
        values: Vec<(T, Vec<(KeyData, f64)>)>,
    ) -> Result<Result<(), &'static str>, ()> {
        let start = self.log.len();
        let column = self.columns.iter_mut().find(|column| column.id() == of.id).ok_or(())?;
        let column = column.as_any_mut().downcast_mut::<Column<Faces, T>>().ok_or(())?;
        let outcome = values.into_iter().try_for_each(|(value, parts)| column.spread(value, &parts, &mut self.log));
        if outcome.is_err() {
            self.rewind(start);
        }
        Ok(outcome)
    }

    /// The same attributes for other faces, into which these were cut: each with its parts, the largest first, and their areas; and for other
    /// records that are not those of a [`Dcel`](crate::dcel::Dcel). Nothing else has a value then.
    ///
    /// # Errors
    /// The reason of the policy that refuses.
    pub fn cut(
        &self,
        faces: &[(KeyData, Vec<(KeyData, f64)>)],
        others: &[(KeyData, Option<KeyData>)],
    ) -> Result<Self, &'static str> {
        let mut all = self.clone();
        let mut first = BTreeMap::new();
        for (old, parts) in faces {
            match parts.first() {
                Some((part, _)) => drop(first.insert(*old, *part)),
                None => all.announce(&[(Kind::Face, Step::Drop(*old))])?,
            }
        }
        let others: BTreeMap<KeyData, Option<KeyData>> = others.iter().copied().collect();
        for (old, _) in others.iter().filter(|(_, new)| new.is_none()) {
            all.announce(&[(Kind::Other, Step::Drop(*old))])?;
        }
        all.rename(&|kind, old| match kind {
            Kind::Face => first.get(&old).copied(),
            Kind::Other => others.get(&old).copied().flatten(),
            _ => None,
        });
        for (_, parts) in faces {
            let mut rest: f64 = parts.iter().map(|(_, area)| area).sum();
            for (part, area) in parts.iter().skip(1) {
                let largest = parts[0].0;
                all.announce(&[(Kind::Face, Step::Split(largest))])?;
                all.settle(&[(Kind::Face, *part)]);
                all.share(Kind::Face, [largest, *part], (area / rest).clamp(0.0, 1.0));
                rest -= area;
            }
            all.log.clear();
        }
        Ok(all)
    }

    /// Gives the values of records to others, or drops them: all at once, and policies are not asked.
    pub fn transfer(&mut self, moves: &[(Kind, KeyData, Option<KeyData>)]) {
        for column in &mut self.columns {
            let kind = column.kind();
            let mut of_kind = moves.iter().filter(|(of, ..)| *of == kind).map(|(_, from, to)| (*from, *to));
            column.transfer(&mut of_kind, &mut self.log);
        }
    }
}
