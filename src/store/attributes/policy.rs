//! Policies: the rules by which the values of an attribute follow.

use super::kind::{Attributed, Corners, Edges, Faces, HalfEdges, Vertices};
use super::quantity::Quantity;
use alloc::sync::Arc;
use core::fmt;
use core::marker::PhantomData;
use core::sync::atomic::{AtomicU64, Ordering};

/// The reason for which a policy refuses.
pub(super) type Reason = &'static str;

/// The values of the two parts.
type Part<T> = dyn Fn(T) -> Result<[Option<T>; 2], Reason> + Send + Sync;

pub(super) type Making<T> = dyn Fn() -> Result<T, Reason> + Send + Sync;
pub(super) type Dropping<T> = dyn Fn(&T) -> Result<(), Reason> + Send + Sync;
pub(super) type Join<T> = dyn Fn(Option<T>, Option<T>) -> Result<Option<T>, Reason> + Send + Sync;

/// The two parts of a record that is split: the one that keeps the key, and the other.
pub(super) enum Splitting<T> {
    Keep,
    Copy,
    Share(fn(&T, f64) -> [T; 2]),
    /// As for a record that is made, also if the other part has no value.
    Make,
    Call(Arc<Part<T>>),
}

pub(super) enum Merging<T> {
    Keep,
    /// That of the record with the larger measure.
    Larger,
    Call(Arc<Join<T>>),
}

/// The rules by which the values of an [attribute](super::Attribute) follow when records are made, split, merged and dropped.
///
/// By default the part of a split record that keeps its key keeps the value, and the other part has none; of two merged records the value
/// of the one that is kept stays; a record that is made has none; that of a record that is dropped is dropped.
///
/// | event | vertices | half-edges, edges | corners | faces | features |
/// | --- | --- | --- | --- | --- | --- |
/// | made | added in a face or on an edge | drawn | at a new vertex | | `add_feature` |
/// | split | `split_vertex` | `split_edge` | an edge is drawn there | an edge closes a cycle | |
/// | merged | `contract_edge` | `join_edges` | an edge is erased there | the edge between is erased | `merge_features` |
/// | dropped | removed, or between joined edges | erased, or contracted | with its vertex, or its last edge | | `remove_feature` |
///
/// The functions may refuse, with a reason: the operator or the edit is then [refused](crate::dcel::OperatorError::Refused), and nothing has
/// changed. They are called while an operator runs, and must not panic.
pub struct Policy<K: Attributed, T> {
    pub(super) splitting: Splitting<T>,
    pub(super) merging: Merging<T>,
    pub(super) making: Option<Arc<Making<T>>>,
    pub(super) between: Option<fn(&T, &T, f64) -> T>,
    pub(super) dropping: Option<Arc<Dropping<T>>>,
    /// A number of the value, by which its record is found.
    pub(super) number: Option<fn(&T) -> u128>,
    /// The next id, if ids are given.
    pub(super) counter: Option<Arc<AtomicU64>>,
    of: PhantomData<K>,
}

impl<K: Attributed, T> Default for Policy<K, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<K: Attributed, T> Policy<K, T> {
    /// The default policy, for an attribute of records of any kind.
    #[must_use]
    pub const fn new() -> Self {
        let (splitting, merging) = (Splitting::Keep, Merging::Keep);
        let (making, between, dropping, number, counter) = (None, None, None, None, None);
        Self { splitting, merging, making, between, dropping, number, counter, of: PhantomData }
    }

    /// Gives a copy to the other part of a record that is split.
    #[must_use]
    pub fn split_copy(mut self) -> Self {
        self.splitting = Splitting::Copy;
        self
    }

    /// Gives to the other part of a record that is split what [a record that is made](Self::make_with) gets, whether the first part has a value or not.
    #[must_use]
    pub fn split_make(mut self) -> Self {
        self.splitting = Splitting::Make;
        self
    }

    /// Gives to the parts of a record that is split what a function makes of its value, if anything: first that of the part that keeps the
    /// key. It may refuse.
    #[must_use]
    pub fn split_with(
        mut self,
        split: impl Fn(T) -> Result<[Option<T>; 2], &'static str> + Send + Sync + 'static,
    ) -> Self {
        self.splitting = Splitting::Call(Arc::new(split));
        self
    }

    /// Gives to a merged record what a function makes of the values of both, if they have one: first that of the one that keeps its
    /// key. It may refuse.
    #[must_use]
    pub fn merge_with(
        mut self,
        merge: impl Fn(Option<T>, Option<T>) -> Result<Option<T>, &'static str> + Send + Sync + 'static,
    ) -> Self {
        self.merging = Merging::Call(Arc::new(merge));
        self
    }

    /// Refuses to merge records that do not have the same value. That one has none, and the other one has, counts as a difference.
    #[must_use]
    pub fn merge_equal(self) -> Self
    where
        T: PartialEq,
    {
        self.merge_with(
            |kept, dropped| {
                if kept == dropped { Ok(kept) } else { Err("the values of the merged records differ") }
            },
        )
    }

    /// Gives the sum of both values to a merged record.
    #[must_use]
    pub fn merge_sum(self) -> Self
    where
        T: Quantity,
    {
        self.merge_with(|kept, dropped| {
            Ok(match (kept, dropped) {
                (Some(kept), Some(dropped)) => Some(kept.sum(&dropped)),
                (kept, dropped) => kept.or(dropped),
            })
        })
    }

    /// Gives a default value to a record that is made.
    #[must_use]
    pub fn make_default(self) -> Self
    where
        T: Default + 'static,
    {
        self.make_with(T::default)
    }

    /// Gives to a record that is made what a function returns.
    #[must_use]
    pub fn make_with(mut self, make: impl Fn() -> T + Send + Sync + 'static) -> Self {
        self.making = Some(Arc::new(move || Ok(make())));
        self
    }

    /// Shows a function each value that is dropped with its record. It may refuse.
    #[must_use]
    pub fn drop_with(mut self, dropped: impl Fn(&T) -> Result<(), &'static str> + Send + Sync + 'static) -> Self {
        self.dropping = Some(Arc::new(dropped));
        self
    }
}

impl<K: Attributed, T> Policy<K, T> {
    /// Keeps an index of numbers of the values, by which [`find`](crate::dcel::Dcel::find) finds records. No two records should have the same:
    /// of these it finds one at most.
    ///
    /// A UUID is a number of this size. Here a function that issues such ids numbers the faces; [`ids`](Self::ids) is shorter.
    ///
    /// ```
    /// use std::sync::atomic::{AtomicU64, Ordering};
    /// use twinedge::dcel::{Dcel, OperatorError, Policy, Split};
    ///
    /// /// In place of that of a crate: an id of 128 bits that was never issued before.
    /// fn uuid() -> u128 {
    ///     static NEXT: AtomicU64 = AtomicU64::new(0);
    ///     0xf81d_4fae_7dec_41d0_a765_0000_0000_0000 | u128::from(NEXT.fetch_add(1, Ordering::Relaxed))
    /// }
    ///
    /// let mut map = Dcel::new();
    /// let ids = Policy::of_faces().make_with(uuid).split_make().identified_by(|id| *id);
    /// let id = map.add_attribute(ids);
    /// let outside = map.unbounded_face().key();
    /// let v = map.add_isolated_vertex(outside)?.vertex;
    /// let inside = map.connect(v, v, Split::default())?.new_face().unwrap();
    /// let number = *map.value(id, inside).unwrap();
    /// assert_eq!(map.find(id, &number), Some(inside));
    /// # Ok::<(), OperatorError>(())
    /// ```
    #[must_use]
    pub fn identified_by(mut self, number: fn(&T) -> u128) -> Self {
        self.number = Some(number);
        self
    }
}

impl<K: Attributed, T> Policy<K, T> {
    pub(super) fn next_id(&self) -> Option<u64> {
        self.counter.as_ref().map(|next| next.load(Ordering::Relaxed))
    }

    /// True if it numbers records.
    #[must_use]
    pub const fn counts(&self) -> bool {
        self.counter.is_some()
    }

    /// Has records numbered from above this number, so that none gets it once more.
    pub(super) fn count_on_from(&self, number: u128) {
        if let (Some(next), Ok(number)) = (&self.counter, u64::try_from(number)) {
            next.fetch_max(number.saturating_add(1), Ordering::Relaxed);
        }
    }
}

impl<K: Attributed> Policy<K, u64> {
    /// Gives the next number, from `first` on, to each record that is there when the attribute is added, to each record that is made, and to
    /// the other part of one that is split. So a record keeps its number as long as its key, and beyond: when keys change, as by
    /// [`compact`](crate::dcel::Dcel::compact), and when it is saved.
    ///
    /// No number is given twice: not after undoing, not by clones, and not if it was set by hand, after which the next one is larger. The last
    /// number, [`u64::MAX`], is not given: once it is the next one, operators that make records are
    /// [refused](crate::dcel::OperatorError::Refused), and a feature that is added has no number. Records are
    /// [found](Self::identified_by) by it. To go on where a structure was saved, save the numbers and the
    /// [next number](crate::dcel::Dcel::next_id) with it: the next number is the `first` of the loaded structure, whose attribute is added
    /// [with the saved numbers](crate::dcel::Dcel::add_attribute_with).
    ///
    /// Of two merged faces the one that keeps its key keeps its number; by [`merge_larger`](Self::merge_larger) it is that of the larger one. The unbounded
    /// face has no number, unless it is given one.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, OperatorError, Policy};
    ///
    /// let mut map = Dcel::new();
    /// let id = map.add_attribute(Policy::of_vertices().ids(100));
    /// let outside = map.unbounded_face().key();
    /// let gone = map.add_isolated_vertex(outside)?.vertex;
    /// let stays = map.add_isolated_vertex(outside)?.vertex;
    /// map.remove_isolated_vertex(gone)?;
    /// map.compact();
    /// let again = map.find(id, &101).unwrap();
    /// assert_ne!(again, stays);
    /// assert_eq!((map.value(id, again), map.find(id, &100)), (Some(&101), None));
    /// # Ok::<(), OperatorError>(())
    /// ```
    #[must_use]
    pub fn ids(self, first: u64) -> Self {
        let next = Arc::new(AtomicU64::new(first));
        let counter = Some(next.clone());
        let one_more = move || next.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |next| next.checked_add(1));
        let making: Arc<Making<u64>> = Arc::new(move || one_more().map_err(|_| "all ids are given away"));
        Self { counter, making: Some(making), ..self }.split_make().identified_by(|id| u128::from(*id))
    }
}

macro_rules! constructors {
    ($($kind:ident $name:ident $doc:literal;)*) => {$(
        impl<T> Policy<$kind, T> {
            #[doc = $doc]
            #[must_use]
            pub const fn $name() -> Self {
                Self::new()
            }
        }
    )*};
}

constructors! {
    Vertices of_vertices "The default policy, for an attribute of vertices.";
    HalfEdges of_half_edges "The default policy, for an attribute of half-edges.";
    Edges of_edges "The default policy, for an attribute of edges.";
    Corners of_corners "The default policy, for an attribute of corners.";
    Faces of_faces "The default policy, for an attribute of faces.";
}

/// Policies by the length of edges or the area of faces.
macro_rules! shares {
    ($($kind:ident $measure:literal;)*) => {$(
        impl<T> Policy<$kind, T> {
            #[doc = concat!("Shares the value of a record that is split out by ", $measure, ".")]
            ///
            /// A `Dcel` without coordinates measures nothing: there the part that keeps the key keeps everything.
            #[must_use]
            pub fn split_share(mut self) -> Self
            where
                T: Quantity,
            {
                self.splitting = Splitting::Share(T::share);
                self
            }
        }
    )*};
}

shares! {
    Edges "length";
    HalfEdges "length";
    Faces "area (the unbounded face keeps everything)";
}

impl<T> Policy<Faces, T> {
    /// Gives to a merged face the value of the one that had the larger area (that of the unbounded face is infinite).
    ///
    /// On a tie, and on a `Dcel` without coordinates, it is that of the one that keeps its key.
    #[must_use]
    pub fn merge_larger(mut self) -> Self {
        self.merging = Merging::Larger;
        self
    }
}

impl<T: Quantity> Policy<Vertices, T> {
    /// Gives to a vertex that splits an edge the value between those of the two ends, by its distance from each.
    ///
    /// On a `Dcel` without coordinates it is the mean. Where an end has no value, the vertex gets that of any vertex that is made.
    #[must_use]
    pub fn interpolate(mut self) -> Self {
        self.between = Some(T::between);
        self
    }
}

impl<K: Attributed, T> fmt::Debug for Policy<K, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Policy").finish_non_exhaustive()
    }
}
