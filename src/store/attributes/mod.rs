//! Values that belong to records and follow operators.
//!
//! An operator applies its steps, by kind of record, before it writes anything. When a policy refuses, only values have changed, and
//! the log restores them.

mod column;
mod policy;

pub use column::{Saved, Step, Value};
pub use policy::{Attributed, Corners, Edges, Faces, HalfEdges, Kind, Policy, Quantity, Vertices};

use crate::store::issuer::structure_offset;
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use column::{AnyColumn, Column};
use core::marker::PhantomData;
use core::{fmt, mem};
use slotmap::{KeyData, SecondaryMap};

/// Names an attribute of a structure: values of type `T` for records of one kind.
///
/// Clones of the structure, and structures that copied its attributes, accept the name; other structures do not.
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

/// The attributes of a structure, with their values. A structure around a [`Dcel`](crate::dcel::Dcel) applies steps on its own records
/// here, and the measures by which values are shared.
#[derive(Debug, Default)]
pub struct Attributes {
    columns: Vec<Box<dyn AnyColumn>>,
    /// The values overwritten by the last operator, or by the current change if it is recorded.
    log: Vec<Saved>,
    /// The face with the larger area, of two about to be merged.
    larger: Option<KeyData>,
}

/// Clones the values, but not the log.
impl Clone for Attributes {
    fn clone(&self) -> Self {
        let columns = self.columns.iter().map(|column| column.copied()).collect();
        Self { columns, log: Vec::new(), larger: None }
    }
}

impl Attributes {
    /// Adds an attribute with these values. If the policy assigns ids, the other `records` get ids.
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
            if !column.values.contains_key(key.into()) {
                // A record stays without a number if all are used up.
                let _ = column.follow(Step::Make(key), false, &mut self.log);
            }
        }
        self.columns.push(Box::new(column));
        Attribute { id, of: PhantomData }
    }

    fn column<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&Column<K, T>> {
        self.columns.iter().find(|column| column.id() == of.id)?.as_any().downcast_ref()
    }

    pub(crate) fn values<K: Attributed, T: Value>(&self, of: Attribute<K, T>) -> Option<&SecondaryMap<K::Key, T>> {
        self.column(of).map(|column| &column.values)
    }

    pub(crate) fn find<K: Attributed, T: Value>(&self, of: Attribute<K, T>, value: &T) -> Option<K::Key> {
        self.column(of)?.find(value)
    }

    pub(crate) fn next_id<K: Attributed>(&self, of: Attribute<K, u64>) -> Option<u64> {
        self.column(of)?.next_id()
    }

    /// Sets or removes a value, and returns the previous one; an error if the attribute belongs to another structure.
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

    /// Applies the steps of an operator. If a policy refuses, nothing changes.
    ///
    /// # Errors
    /// The reason of the policy that refuses.
    #[cold]
    pub fn follow(&mut self, steps: &[(Kind, Step)]) -> Result<(), &'static str> {
        let start = self.log.len();
        let larger = self.larger.take();
        for (kind, step) in steps {
            let is_larger = matches!(step, Step::Merge(_, dropped) if Some(*dropped) == larger);
            for column in self.columns.iter_mut().filter(|column| column.kind() == *kind) {
                if let Err(reason) = column.follow(*step, is_larger, &mut self.log) {
                    self.rewind(start);
                    return Err(reason);
                }
            }
        }
        Ok(())
    }

    /// Adds the attributes of another structure. Where both have the same attribute, records keep their own values, and a number
    /// already in use is not given to another record.
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

    /// Restores all values logged after the first `start`.
    fn rewind(&mut self, start: usize) {
        let mut failed = self.log.split_off(start);
        failed.iter_mut().rev().for_each(|saved| self.exchange(saved));
    }

    /// Exchanges a saved value with the current one.
    pub fn exchange(&mut self, saved: &mut Saved) {
        if let Some(column) = self.columns.iter_mut().find(|column| column.id() == saved.id()) {
            saved.exchange(&mut **column);
        }
    }

    /// Takes all overwritten values out of the log.
    #[must_use]
    pub fn take_log(&mut self) -> Vec<Saved> {
        mem::take(&mut self.log)
    }

    /// Returns the number of overwritten values. O(1).
    #[must_use]
    pub fn log_len(&self) -> usize {
        self.log.len()
    }

    /// Takes the overwritten values after the first `at` out of the log.
    #[must_use]
    pub fn split_log(&mut self, at: usize) -> Vec<Saved> {
        self.log.split_off(at)
    }

    /// Clears the log.
    pub fn clear_log(&mut self) {
        self.log.clear();
    }

    /// Changes the keys of all values; a value without a new key is dropped.
    pub(crate) fn rename(&mut self, key: &dyn Fn(Kind, KeyData) -> Option<KeyData>) {
        self.log.clear();
        for column in &mut self.columns {
            let kind = column.kind();
            column.rename(&|old| key(kind, old));
        }
    }
}

impl Attributes {
    /// Tells whether splitting a record of this kind shares out a value by measures.
    #[must_use]
    pub fn shares(&self, kind: Kind) -> bool {
        self.columns.iter().any(|column| column.kind() == kind && column.shares())
    }

    /// Tells whether the areas of merged faces matter.
    #[must_use]
    pub fn is_by_area(&self) -> bool {
        self.columns.iter().any(|column| column.is_by_measure())
    }

    /// Tells whether a vertex on an edge interpolates values of the ends.
    #[must_use]
    pub fn interpolates(&self) -> bool {
        self.columns.iter().any(|column| column.interpolates())
    }

    /// Sets the face with the larger area, if one is larger, of two about to be merged.
    pub const fn set_larger(&mut self, face: Option<KeyData>) {
        self.larger = face;
    }

    /// Shares the values of a split record: the second part gets the fraction `part`.
    pub fn share(&mut self, kind: Kind, parts: [KeyData; 2], part: f64) {
        for column in self.columns.iter_mut().filter(|column| column.kind() == kind) {
            column.share(parts, part, &mut self.log);
        }
    }

    /// Interpolates the values of a vertex on an edge, at the fraction `part` of the way between its ends.
    pub fn interpolate(&mut self, vertex: KeyData, ends: [KeyData; 2], part: f64) {
        for column in self.columns.iter_mut().filter(|column| column.kind() == Kind::Vertex) {
            column.interpolate(vertex, ends, part, &mut self.log);
        }
    }

    /// Returns the same attributes for faces cut into parts, given with their areas, the largest first, and for other records that are
    /// not part of a [`Dcel`](crate::dcel::Dcel). All remaining records have no value.
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
                None => all.follow(&[(Kind::Face, Step::Drop(*old))])?,
            }
        }
        let others: BTreeMap<KeyData, Option<KeyData>> = others.iter().copied().collect();
        for (old, _) in others.iter().filter(|(_, new)| new.is_none()) {
            all.follow(&[(Kind::Other, Step::Drop(*old))])?;
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
                all.follow(&[(Kind::Face, Step::Split(largest, *part))])?;
                all.share(Kind::Face, [largest, *part], (area / rest).clamp(0.0, 1.0));
                rest -= area;
            }
            all.log.clear();
        }
        Ok(all)
    }

    /// Moves values between records, or drops them, all at once and without consulting policies.
    pub fn transfer(&mut self, moves: &[(Kind, KeyData, Option<KeyData>)]) {
        for column in &mut self.columns {
            let kind = column.kind();
            let mut of_kind = moves.iter().filter(|(of, ..)| *of == kind).map(|(_, from, to)| (*from, *to));
            column.transfer(&mut of_kind, &mut self.log);
        }
    }
}
