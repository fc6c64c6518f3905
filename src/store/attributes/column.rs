//! The values of one attribute, and the changes that operators make to them.

use super::policy::{Attributed, Kind, Merging, Policy, Reason, Splitting};
use alloc::boxed::Box;
use alloc::collections::BTreeSet;
use alloc::sync::Arc;
use alloc::vec::Vec;
use core::any::Any;
use core::fmt::Debug;
use core::mem;
use hashbrown::HashMap;
use slotmap::{Key, KeyData, SecondaryMap};

/// One effect of an operator on the records of a kind. A new record comes last.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Step {
    /// Makes a record.
    Make(KeyData),
    /// Makes a vertex on the edge between two vertices.
    Between(KeyData, KeyData, KeyData),
    /// Splits the second record off the first.
    Split(KeyData, KeyData),
    /// Moves the value of the first record to the second.
    Move(KeyData, KeyData),
    /// Merges the second record into the first.
    Merge(KeyData, KeyData),
    /// Drops this record.
    Drop(KeyData),
}

pub(super) trait AnyColumn: Any + Debug + Send + Sync {
    fn id(&self) -> u32;
    fn kind(&self) -> Kind;
    fn follow(&mut self, step: Step, is_larger: bool, log: &mut Vec<Saved>) -> Result<(), Reason>;
    fn shares(&self) -> bool;
    fn is_by_measure(&self) -> bool;
    fn interpolates(&self) -> bool;
    /// Shares the remaining value of the first part with the second by measure.
    fn share(&mut self, parts: [KeyData; 2], part: f64, log: &mut Vec<Saved>);
    fn interpolate(&mut self, vertex: KeyData, ends: [KeyData; 2], part: f64, log: &mut Vec<Saved>);
    /// Moves the values of some records to others, or drops them.
    fn transfer(&mut self, moves: &mut dyn Iterator<Item = (KeyData, Option<KeyData>)>, log: &mut Vec<Saved>);
    /// Copies values of the same attribute of another structure to records without a value.
    fn absorb(&mut self, other: &dyn AnyColumn, log: &mut Vec<Saved>);
    /// Changes the keys of all values; a value without a new key is dropped.
    fn rename(&mut self, key: &dyn Fn(KeyData) -> Option<KeyData>);
    fn copied(&self) -> Box<dyn AnyColumn>;
    fn as_any(&self) -> &dyn Any;
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

/// An overwritten value.
#[derive(Debug)]
pub struct Saved(Box<dyn AnySaved>);

impl Clone for Saved {
    fn clone(&self) -> Self {
        Self(self.0.copied())
    }
}

impl Saved {
    pub(super) fn id(&self) -> u32 {
        self.0.id()
    }

    pub(super) fn exchange(&mut self, column: &mut dyn AnyColumn) {
        self.0.exchange(column);
    }
}

trait AnySaved: Debug + Send + Sync {
    fn id(&self) -> u32;
    fn exchange(&mut self, column: &mut dyn AnyColumn);
    fn copied(&self) -> Box<dyn AnySaved>;
}

#[derive(Clone, Debug)]
struct SavedValue<K: Attributed, T> {
    id: u32,
    key: K::Key,
    value: Option<T>,
}

impl<K: Attributed, T: Value> AnySaved for SavedValue<K, T> {
    fn id(&self) -> u32 {
        self.id
    }

    fn exchange(&mut self, column: &mut dyn AnyColumn) {
        if let Some(column) = column.as_any_mut().downcast_mut::<Column<K, T>>() {
            self.value = column.replace(self.key, self.value.take());
        }
    }

    fn copied(&self) -> Box<dyn AnySaved> {
        Box::new(Self { id: self.id, key: self.key, value: self.value.clone() })
    }
}

/// A type of values: cloneable, `Send`, `Sync` and without borrows.
pub trait Value: Clone + Debug + Send + Sync + 'static {}

impl<T: Clone + Debug + Send + Sync + 'static> Value for T {}

#[derive(Debug)]
pub(super) struct Column<K: Attributed, T> {
    id: u32,
    policy: Arc<Policy<K, T>>,
    pub(super) values: SecondaryMap<K::Key, T>,
    /// The record for each number of a value, if records are found by value.
    index: HashMap<u128, K::Key>,
    /// Further records with the same number, until their numbers are unique again.
    others: HashMap<u128, BTreeSet<K::Key>>,
}

impl<K: Attributed, T: Value> Column<K, T> {
    pub(super) fn new(id: u32, policy: Policy<K, T>) -> Self {
        let (index, others) = (HashMap::new(), HashMap::new());
        Self { id, policy: Arc::new(policy), values: SecondaryMap::new(), index, others }
    }

    pub(super) fn find(&self, value: &T) -> Option<K::Key> {
        self.policy.number.and_then(|number| self.index.get(&number(value)).copied())
    }

    pub(super) fn next_id(&self) -> Option<u64> {
        self.policy.next_id()
    }

    fn replace(&mut self, key: K::Key, value: Option<T>) -> Option<T> {
        let had = self.values.remove(key);
        if let Some(number) = self.policy.number {
            had.as_ref().into_iter().for_each(|had| self.unlist(number(had), key));
            value.as_ref().into_iter().for_each(|value| self.list(number(value), key));
        }
        if let Some(value) = value {
            self.values.insert(key, value);
        }
        had
    }

    /// Makes this number find this record.
    fn list(&mut self, number: u128, key: K::Key) {
        self.policy.count_on_from(number);
        if let Some(other) = self.index.insert(number, key) {
            self.others.entry(number).or_default().insert(other);
        }
    }

    /// Makes this number find another record with the same number, if there is one.
    fn unlist(&mut self, number: u128, key: K::Key) {
        let mut others = self.others.remove(&number).unwrap_or_default();
        if self.index.get(&number) != Some(&key) {
            others.remove(&key);
        } else if let Some(other) = others.pop_last() {
            self.index.insert(number, other);
        } else {
            self.index.remove(&number);
        }
        if !others.is_empty() {
            self.others.insert(number, others);
        }
    }

    pub(super) fn put(&mut self, key: K::Key, value: Option<T>, log: &mut Vec<Saved>) -> Option<T> {
        let writes = value.is_some();
        let had = self.replace(key, value);
        if had.is_some() || writes {
            log.push(Saved(Box::new(SavedValue::<K, T> { id: self.id, key, value: had.clone() })));
        }
        had
    }

    fn made(&self) -> Result<Option<T>, Reason> {
        self.policy.making.as_ref().map(|make| make()).transpose()
    }

    /// Splits a value, and returns the other part's.
    fn split(&mut self, key: K::Key, log: &mut Vec<Saved>) -> Result<Option<T>, Reason> {
        let policy = self.policy.clone();
        if let Splitting::Make = policy.splitting {
            return self.made();
        }
        let Some(value) = self.values.get(key) else { return Ok(None) };
        Ok(match &policy.splitting {
            Splitting::Keep | Splitting::Make => None,
            Splitting::Copy => Some(value.clone()),
            // Nothing has been measured yet.
            Splitting::Share(share) => Some(share(value, 0.0)[1].clone()),
            Splitting::Call(split) => {
                let [kept, other] = split(value.clone())?;
                self.put(key, kept, log);
                other
            }
        })
    }

    /// Merges the values of two records, and drops the second one's.
    fn merge(&mut self, key: K::Key, gone: K::Key, is_larger: bool, log: &mut Vec<Saved>) -> Result<Option<T>, Reason> {
        let (kept, dropped) = (self.values.get(key).cloned(), self.values.get(gone).cloned());
        let merged = match &self.policy.merging {
            Merging::Larger if is_larger => dropped,
            Merging::Keep | Merging::Larger => kept,
            Merging::Call(merge) => merge(kept, dropped)?,
        };
        self.put(gone, None, log);
        Ok(merged)
    }
}

impl<K: Attributed, T: Value> AnyColumn for Column<K, T> {
    fn id(&self) -> u32 {
        self.id
    }

    fn kind(&self) -> Kind {
        K::KIND
    }

    fn follow(&mut self, step: Step, is_larger: bool, log: &mut Vec<Saved>) -> Result<(), Reason> {
        let (key, value) = match step {
            Step::Make(new) => (new, self.made()?),
            Step::Between(a, b, new) => {
                let ends = [a, b].map(|end| self.values.get(end.into()));
                let value = match (self.policy.between, ends) {
                    (Some(between), [Some(a), Some(b)]) => Some(between(a, b, 0.5)),
                    _ => self.made()?,
                };
                (new, value)
            }
            Step::Split(old, new) => (new, self.split(old.into(), log)?),
            Step::Move(from, to) => (to, self.put(from.into(), None, log)),
            Step::Merge(kept, dropped) => (kept, self.merge(kept.into(), dropped.into(), is_larger, log)?),
            Step::Drop(key) => {
                if let (Some(value), Some(dropping)) = (self.values.get(key.into()), &self.policy.dropping) {
                    dropping(value)?;
                }
                (key, None)
            }
        };
        self.put(key.into(), value, log);
        Ok(())
    }

    fn shares(&self) -> bool {
        matches!(self.policy.splitting, Splitting::Share(_))
    }

    fn is_by_measure(&self) -> bool {
        matches!(self.policy.merging, Merging::Larger)
    }

    fn interpolates(&self) -> bool {
        self.policy.between.is_some()
    }

    fn share(&mut self, [old, new]: [KeyData; 2], part: f64, log: &mut Vec<Saved>) {
        if let (Splitting::Share(share), Some(all)) = (&self.policy.splitting, self.values.get(old.into())) {
            let [kept, given] = share(all, part);
            self.put(old.into(), Some(kept), log);
            self.put(new.into(), Some(given), log);
        }
    }

    fn interpolate(&mut self, vertex: KeyData, ends: [KeyData; 2], part: f64, log: &mut Vec<Saved>) {
        let ends = ends.map(|end| self.values.get(end.into()));
        if let (Some(between), [Some(a), Some(b)]) = (self.policy.between, ends) {
            let value = between(a, b, part);
            self.put(vertex.into(), Some(value), log);
        }
    }

    fn transfer(&mut self, moves: &mut dyn Iterator<Item = (KeyData, Option<KeyData>)>, log: &mut Vec<Saved>) {
        let taken: Vec<_> = moves.map(|(from, to)| (to, self.put(from.into(), None, log))).collect();
        for (to, value) in taken {
            if let (Some(to), Some(_)) = (to, &value) {
                self.put(to.into(), value, log);
            }
        }
    }

    fn rename(&mut self, key: &dyn Fn(KeyData) -> Option<KeyData>) {
        self.index.clear();
        self.others.clear();
        for (old, value) in mem::take(&mut self.values) {
            if let Some(new) = key(old.data()) {
                self.replace(new.into(), Some(value));
            }
        }
    }

    fn absorb(&mut self, other: &dyn AnyColumn, log: &mut Vec<Saved>) {
        let number = self.policy.number.filter(|_| self.policy.counts());
        for (key, value) in other.as_any().downcast_ref::<Self>().into_iter().flat_map(|other| &other.values) {
            if !self.values.contains_key(key) {
                let is_given = number.is_some_and(|number| self.index.contains_key(&number(value)));
                let value = if is_given { self.made().unwrap_or(None) } else { Some(value.clone()) };
                self.put(key, value, log);
            }
        }
    }

    fn copied(&self) -> Box<dyn AnyColumn> {
        let (policy, values) = (self.policy.clone(), self.values.clone());
        let (index, others) = (self.index.clone(), self.others.clone());
        Box::new(Self { id: self.id, policy, values, index, others })
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}
