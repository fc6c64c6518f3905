//! Policies: the rules by which attribute values follow operators. The kinds of records, and quantities that are shared out.

use crate::store::keys::{FaceKey, HalfEdgeKey, VertexKey};
use alloc::sync::Arc;
use core::fmt;
use core::fmt::Debug;
use core::marker::PhantomData;
use core::sync::atomic::{AtomicU64, Ordering};
use slotmap::Key;

pub(super) type Reason = &'static str;

type Part<T> = dyn Fn(T) -> Result<[Option<T>; 2], Reason> + Send + Sync;

pub(super) type Making<T> = dyn Fn() -> Result<T, Reason> + Send + Sync;
pub(super) type Dropping<T> = dyn Fn(&T) -> Result<(), Reason> + Send + Sync;
pub(super) type Join<T> = dyn Fn(Option<T>, Option<T>) -> Result<Option<T>, Reason> + Send + Sync;

/// Splits a record: the first part keeps the key.
pub(super) enum Splitting<T> {
    Keep,
    Copy,
    Share(fn(&T, f64) -> [T; 2]),
    /// The value of a new record, even if the first part has no value.
    Make,
    Call(Arc<Part<T>>),
}

pub(super) enum Merging<T> {
    Keep,
    /// The value of the record with the larger measure.
    Larger,
    Call(Arc<Join<T>>),
}

/// The rules by which the values of an [attribute](super::Attribute) follow when records are made, split, merged and dropped.
///
/// By default a split record keeps its value, and the other part has none; a merged record keeps the value of the surviving record; a
/// new record has no value; and a dropped record's value is dropped.
///
/// | event | vertices | half-edges, edges | corners | faces | features |
/// | --- | --- | --- | --- | --- | --- |
/// | made | added in a face or on an edge | drawn | at a new vertex | | `add_feature` |
/// | split | `split_vertex` | `split_edge` | an edge is drawn there | an edge closes a cycle | |
/// | merged | `contract_edge` | `join_edges` | an edge is erased there | the edge between is erased | `merge_features` |
/// | dropped | removed, or between joined edges | erased, or contracted | with its vertex, or its last edge | | `remove_feature` |
///
/// The functions may refuse, with a reason: the operator or the edit is then [refused](crate::dcel::OperatorError::Refused), and
/// nothing changes. They run inside operators, and must not panic.
pub struct Policy<K: Attributed, T> {
    pub(super) splitting: Splitting<T>,
    pub(super) merging: Merging<T>,
    pub(super) making: Option<Arc<Making<T>>>,
    pub(super) between: Option<fn(&T, &T, f64) -> T>,
    pub(super) dropping: Option<Arc<Dropping<T>>>,
    /// The number of a value, by which its record is found.
    pub(super) number: Option<fn(&T) -> u128>,
    pub(super) counter: Option<Arc<AtomicU64>>,
    of: PhantomData<K>,
}

impl<K: Attributed, T> Default for Policy<K, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<K: Attributed, T> Policy<K, T> {
    /// Creates the default policy, for an attribute of any kind of record.
    #[must_use]
    pub const fn new() -> Self {
        let (splitting, merging) = (Splitting::Keep, Merging::Keep);
        let (making, between, dropping, number, counter) = (None, None, None, None, None);
        Self { splitting, merging, making, between, dropping, number, counter, of: PhantomData }
    }

    /// Copies the value of a split record to the other part.
    #[must_use]
    pub fn split_copy(mut self) -> Self {
        self.splitting = Splitting::Copy;
        self
    }

    /// Gives the other part of a split record the value of [a new record](Self::make_with), even if the first part has no value.
    #[must_use]
    pub fn split_make(mut self) -> Self {
        self.splitting = Splitting::Make;
        self
    }

    /// Splits the value of a split record, if it has one, with a function, which returns the value of the part that keeps the key, then
    /// the other value. The function may refuse.
    #[must_use]
    pub fn split_with(
        mut self,
        split: impl Fn(T) -> Result<[Option<T>; 2], &'static str> + Send + Sync + 'static,
    ) -> Self {
        self.splitting = Splitting::Call(Arc::new(split));
        self
    }

    /// Merges the values of two records, if they have any, with a function, whose first argument belongs to the surviving record. The
    /// function may refuse.
    #[must_use]
    pub fn merge_with(
        mut self,
        merge: impl Fn(Option<T>, Option<T>) -> Result<Option<T>, &'static str> + Send + Sync + 'static,
    ) -> Self {
        self.merging = Merging::Call(Arc::new(merge));
        self
    }

    /// Refuses to merge records with different values. A missing value differs from any value.
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

    /// Sums the values of merged records.
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

    /// Gives new records the value that a function returns.
    #[must_use]
    pub fn make_with(mut self, make: impl Fn() -> T + Send + Sync + 'static) -> Self {
        self.making = Some(Arc::new(move || Ok(make())));
        self
    }

    /// Calls a function with each value that is dropped with its record. The function may refuse.
    #[must_use]
    pub fn drop_with(mut self, dropped: impl Fn(&T) -> Result<(), &'static str> + Send + Sync + 'static) -> Self {
        self.dropping = Some(Arc::new(dropped));
        self
    }
}

impl<K: Attributed, T> Policy<K, T> {
    /// Indexes the values by number, so that [`find`](crate::dcel::Dcel::find) finds their records. Numbers should be unique: of
    /// several records with the same number, at most one is found.
    ///
    /// A UUID is a number of this size. In this example a function issues ids for faces; [`ids`](Self::ids) is shorter.
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

    /// Tells whether the policy assigns ids.
    #[must_use]
    pub const fn counts(&self) -> bool {
        self.counter.is_some()
    }

    /// Assigns only ids above this number from now on.
    pub(super) fn count_on_from(&self, number: u128) {
        if let (Some(next), Ok(number)) = (&self.counter, u64::try_from(number)) {
            next.fetch_max(number.saturating_add(1), Ordering::Relaxed);
        }
    }
}

impl<K: Attributed> Policy<K, u64> {
    /// Assigns numbers, from `first` on, to all existing records when the attribute is added, to new records, and to the other part of
    /// split records. A record keeps its number as long as its key, and beyond: when keys change, as by
    /// [`compact`](crate::dcel::Dcel::compact), and when it is saved.
    ///
    /// Numbers are never reused, even after undo or by clones; setting a number by hand raises the next one above it. The last number,
    /// [`u64::MAX`], is not assigned: once it is next, operators that make records are [refused](crate::dcel::OperatorError::Refused),
    /// and an added feature has no number. Records are [found](Self::identified_by) by number. To continue in a loaded structure, save
    /// the numbers and the [next number](crate::dcel::Dcel::next_id); pass the latter as `first`, and add the attribute [with the saved
    /// numbers](crate::dcel::Dcel::add_attribute_with).
    ///
    /// Of two merged faces the survivor keeps its number; with [`merge_larger`](Self::merge_larger) the merged face gets the number of
    /// the larger one. The unbounded face has no number unless one is set.
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

impl<T> Policy<Faces, T> {
    /// Gives a merged face the value of the face with the larger area (the unbounded face has infinite area).
    ///
    /// On a tie, and on a `Dcel` without coordinates, the surviving face keeps its value.
    #[must_use]
    pub fn merge_larger(mut self) -> Self {
        self.merging = Merging::Larger;
        self
    }
}

impl<T: Quantity> Policy<Vertices, T> {
    /// Gives a vertex that splits an edge a value interpolated between the two ends by distance.
    ///
    /// On a `Dcel` without coordinates it is the mean. If an end has no value, the vertex gets the value of a new vertex.
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

/// A kind of records that have attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Vertices.
    Vertex,
    /// Half-edges.
    HalfEdge,
    /// Edges.
    Edge,
    /// Corners.
    Corner,
    /// Faces.
    Face,
    /// Records of a structure around the [`Dcel`](crate::dcel::Dcel), such as the features of a map. No operator writes to them.
    Other,
}

/// A kind of record with [attributes](super::Attribute): [`Vertices`], [`HalfEdges`], [`Edges`], [`Corners`], [`Faces`], or a kind
/// defined by a structure around a [`Dcel`](crate::dcel::Dcel), which is [`Kind::Other`].
pub trait Attributed: Debug + Send + Sync + 'static {
    /// The keys of these records.
    type Key: Key + Send + Sync;

    /// The kind.
    const KIND: Kind = Kind::Other;
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident $kind:ident $key:ident $of:ident $(shared by $measure:literal)?;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub enum $name {}

        impl Attributed for $name {
            type Key = $key;

            const KIND: Kind = Kind::$kind;
        }

        impl<T> Policy<$name, T> {
            #[doc = concat!("Returns the default policy for an attribute of [`", stringify!($name), "`].")]
            #[must_use]
            pub const fn $of() -> Self {
                Self::new()
            }

            $(
                #[doc = concat!("Shares the value of a record that is split out by ", $measure, ".")]
                ///
                /// Without coordinates a `Dcel` measures nothing: the part that keeps the key keeps everything.
                #[must_use]
                pub fn split_share(mut self) -> Self
                where
                    T: Quantity,
                {
                    self.splitting = Splitting::Share(T::share);
                    self
                }
            )?
        }
    )*};
}

kinds! {
    /// Attributes of vertices.
    Vertices Vertex VertexKey of_vertices;
    /// Attributes of half-edges: each side of an edge has its own value.
    HalfEdges HalfEdge HalfEdgeKey of_half_edges shared by "length";
    /// Attributes of edges. Either half-edge names the edge; values are stored under the one with the smaller index.
    Edges Edge HalfEdgeKey of_edges shared by "length";
    /// Attributes of [corners](crate::dcel::Corner), each named by the half-edge at whose origin and to whose left it lies. The corner
    /// of an isolated vertex has no attributes.
    Corners Corner HalfEdgeKey of_corners;
    /// Attributes of faces, including the unbounded face.
    Faces Face FaceKey of_faces shared by "area (the unbounded face keeps everything)";
}

/// A value that can be shared between the parts of a split record, and summed when records merge.
///
/// Implemented for the usual numbers; you can implement it for your own types.
///
/// ```
/// use twinedge::dcel::Quantity;
///
/// assert_eq!(8.0_f64.share(0.25), [6.0, 2.0]);
/// // Nothing is lost by rounding.
/// assert_eq!(7_u32.share(0.5), [3, 4]);
/// ```
pub trait Quantity: Sized {
    /// Returns the shares of the remaining part and of the other part, which gets the fraction `part`, from 0 to 1.
    #[must_use]
    fn share(&self, part: f64) -> [Self; 2];

    /// Returns the sum. Integers saturate.
    #[must_use]
    fn sum(&self, other: &Self) -> Self;

    /// Returns the value at the fraction `part`, from 0 to 1, of the way to another value.
    #[must_use]
    fn between(&self, other: &Self, part: f64) -> Self {
        self.share(part)[0].sum(&other.share(part)[1])
    }
}

macro_rules! quantities {
    (floats $($float:ident)*; integers $($integer:ident)*) => {
        $(impl Quantity for $float {
            fn share(&self, part: f64) -> [Self; 2] {
                let given = self * part as $float;
                [self - given, given]
            }

            fn sum(&self, other: &Self) -> Self {
                self + other
            }
        })*

        $(impl Quantity for $integer {
            #[allow(clippy::cast_lossless, clippy::cast_sign_loss, reason = "for all integers; the share of a number without sign has none")]
            fn share(&self, part: f64) -> [Self; 2] {
                // The cast saturates; adding a half rounds, without the standard library.
                let given = (*self as f64 * part + if *self < 0 as $integer { -0.5 } else { 0.5 }) as $integer;
                let given = if part >= 1.0 { *self } else if part <= 0.0 { 0 } else { given };
                [self.saturating_sub(given), given]
            }

            fn sum(&self, other: &Self) -> Self {
                self.saturating_add(*other)
            }
        })*
    };
}

quantities! { floats f32 f64; integers u32 u64 usize i32 i64 }
