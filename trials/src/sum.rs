//! Adding up the parts of one work.

use crate::error::Failed;
use crate::shard::Shard;
use thiserror::Error;

/// The findings of an engine in its part of the work.
pub trait Outcome: Clone {
    /// The identity of the work: the outcomes of other work cannot be added.
    type Work: PartialEq + std::fmt::Debug;

    /// Returns the work to which this part belongs.
    fn work(&self) -> Self::Work;

    /// Returns the part.
    fn shard(&self) -> Shard;

    /// Returns true if the part was not finished.
    fn is_interrupted(&self) -> bool;

    /// Returns the reasons for a failure; empty for a success. Counts are compared with published ones only for the whole work.
    fn reasons(&self) -> Vec<String>;

    /// Adds the findings of another part.
    #[doc(hidden)]
    fn absorb(&mut self, other: &Self);

    /// Makes it the outcome of the whole work, after all other parts were added.
    #[doc(hidden)]
    fn complete(&mut self);

    /// Returns true if there are no faults and the part was finished.
    fn is_ok(&self) -> bool {
        self.reasons().is_empty()
    }

    /// Returns the outcome if there are no faults and the part was finished.
    ///
    /// # Errors
    /// [`Failed`], with all reasons.
    fn into_result(self) -> Result<Self, Failed> {
        Failed::unless_empty(self.reasons()).map(|()| self)
    }
}

/// The error of outcomes that do not add up to one whole work. Positions count the outcomes from 0.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SumError {
    /// There are no outcomes.
    #[error("there is nothing to add up")]
    Empty,
    /// An outcome belongs to other work.
    #[error("this is a part of other work: {other}, and not {first}")]
    OtherWork {
        /// The outcome.
        position: usize,
        /// The work of the first outcome.
        first: String,
        /// Its work.
        other: String,
    },
    /// An outcome belongs to another number of parts.
    #[error("this is part {other}, but the first is part {first}")]
    OtherCount {
        /// The outcome.
        position: usize,
        /// The part of the first outcome.
        first: Shard,
        /// Its part.
        other: Shard,
    },
    /// An outcome was not finished.
    #[error("part {shard} was interrupted")]
    Interrupted {
        /// The outcome.
        position: usize,
        /// Its part.
        shard: Shard,
    },
    /// A part occurs twice.
    #[error("part {shard} is there twice")]
    Repeated {
        /// The second of the two outcomes.
        position: usize,
        /// The part.
        shard: Shard,
    },
    /// Parts are missing.
    #[error("{} missing: {}", missing_words(*.count), list(.first))]
    Missing {
        /// The number of missing parts.
        count: u32,
        /// The first of them.
        first: Vec<Shard>,
    },
}

fn missing_words(count: u32) -> String {
    if count == 1 { "1 part is".to_owned() } else { format!("{count} parts are") }
}

fn list(shards: &[Shard]) -> String {
    shards.iter().map(Shard::to_string).collect::<Vec<_>>().join(", ")
}

impl SumError {
    /// Returns the faulty outcome, if there is one; counted from 0.
    #[must_use]
    pub const fn position(&self) -> Option<usize> {
        match self {
            Self::OtherWork { position, .. }
            | Self::OtherCount { position, .. }
            | Self::Interrupted { position, .. }
            | Self::Repeated { position, .. } => Some(*position),
            Self::Empty | Self::Missing { .. } => None,
        }
    }
}

const NAMED: usize = 10;

/// Returns the outcome of the whole work from the outcomes of its parts, in any order. All counts equal the counts of one run.
///
/// ```
/// use twinedge_trials::tables::TablesWork;
/// use twinedge_trials::{Run, Shard, Validator, sum, tables};
/// let part = |k| tables(TablesWork { half_edges: 0 }, &Validator, &Run::default().shard(Shard::new(k, 2).unwrap()));
/// let whole = sum(&[part(0), part(1)])?;
/// assert_eq!(whole, tables(TablesWork { half_edges: 0 }, &Validator, &Run::default()));
/// # Ok::<(), twinedge_trials::SumError>(())
/// ```
///
/// # Errors
/// [`SumError`] if a part is missing, repeated, unfinished, or of other work.
pub fn sum<O: Outcome>(parts: &[O]) -> Result<O, SumError> {
    let first = parts.first().ok_or(SumError::Empty)?;
    let (work, count) = (first.work(), first.shard().count());
    let mut found = std::collections::BTreeSet::new();
    for (position, part) in parts.iter().enumerate() {
        let shard = part.shard();
        if part.work() != work {
            let [first, other] = [work, part.work()].map(|work| format!("{work:?}"));
            return Err(SumError::OtherWork { position, first, other });
        }
        if shard.count() != count {
            return Err(SumError::OtherCount { position, first: first.shard(), other: shard });
        }
        if part.is_interrupted() {
            return Err(SumError::Interrupted { position, shard });
        }
        if !found.insert(shard.index()) {
            return Err(SumError::Repeated { position, shard });
        }
    }
    if found.len() < count as usize {
        let missing = (0..count).filter(|index| !found.contains(index));
        let first = missing.take(NAMED).filter_map(|index| Shard::new(index, count).ok()).collect();
        return Err(SumError::Missing { count: count - found.len() as u32, first });
    }
    let mut parts: Vec<&O> = parts.iter().collect();
    parts.sort_by_key(|part| part.shard());
    let mut whole = parts[0].clone();
    parts[1..].iter().for_each(|part| whole.absorb(part));
    whole.complete();
    Ok(whole)
}
