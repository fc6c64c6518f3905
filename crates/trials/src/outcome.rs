//! Outcomes of engines, and the sum of the parts of one work.

use crate::run::Run;
use crate::shard::Shard;
use std::fmt;
use std::ops::{Deref, DerefMut};
use thiserror::Error;

/// The outcome of an engine in its part of the work. It derefs to the results, with which it shares one object in JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "R: serde::Serialize, R::Work: serde::Serialize",
        deserialize = "R: serde::Deserialize<'de>, R::Work: serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub struct Outcome<R: Results> {
    /// The work.
    pub work: R::Work,
    /// The part of it.
    pub shard: Shard,
    /// True if the run was stopped early.
    pub interrupted: bool,
    /// The results of the engine.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub results: R,
}

/// The results of an engine in a part of the work.
pub trait Results: Clone {
    /// The description of the work: results of other work cannot be added.
    type Work: Clone + PartialEq + fmt::Debug;

    /// Returns the names of the structures under test. Results on other structures cannot be added.
    fn on(&self) -> Vec<&str> {
        Vec::new()
    }

    /// Returns the reasons for a failure; empty for a success. Counts are compared with published ones only if `is_complete`: if
    /// the whole work was done.
    fn reasons(&self, work: &Self::Work, is_complete: bool) -> Vec<String>;

    /// Adds the results of another part.
    #[doc(hidden)]
    fn absorb(&mut self, other: &Self);

    /// Computes the results that depend on the whole work, after all other parts were added.
    #[doc(hidden)]
    fn complete(&mut self) {}
}

impl<R: Results> Outcome<R> {
    pub(crate) fn new(work: R::Work, run: &Run<'_>, results: R) -> Self {
        Self { work, shard: run.part(), interrupted: run.is_stopped(), results }
    }

    /// Returns true if the whole work was done, so that counts can be compared with published ones.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.shard.is_whole() && !self.interrupted
    }

    /// Returns the reasons for a failure; empty for a success. Counts are compared with published ones only for the whole work.
    #[must_use]
    pub fn reasons(&self) -> Vec<String> {
        let interrupted = self.interrupted.then(|| "interrupted before the end".to_owned());
        interrupted.into_iter().chain(self.results.reasons(&self.work, self.is_complete())).collect()
    }

    /// Returns true if there are no faults and the part was finished.
    #[must_use]
    pub fn is_ok(&self) -> bool {
        self.reasons().is_empty()
    }

    /// Returns the outcome if there are no faults and the part was finished.
    ///
    /// # Errors
    /// [`Failed`], with all reasons.
    pub fn into_result(self) -> Result<Self, Failed> {
        let reasons = self.reasons();
        if reasons.is_empty() { Ok(self) } else { Err(Failed { reasons }) }
    }
}

impl<R: Results> Deref for Outcome<R> {
    type Target = R;

    fn deref(&self) -> &R {
        &self.results
    }
}

impl<R: Results> DerefMut for Outcome<R> {
    fn deref_mut(&mut self) -> &mut R {
        &mut self.results
    }
}

/// Returns the number of faults and the first findings as reasons; empty without faults.
pub(crate) fn faults<T: ToString>(what: &str, count: u64, findings: &[T]) -> Vec<String> {
    let number = (count > 0).then(|| format!("{what}: {count}"));
    number.into_iter().flat_map(|number| std::iter::once(number).chain(findings.iter().map(T::to_string))).collect()
}

/// A run found faults, or was not finished.
#[derive(Clone, PartialEq, Eq, Error)]
#[error("{}", .reasons.join("\n"))]
pub struct Failed {
    /// The reasons, one each.
    pub reasons: Vec<String>,
}

/// Equal to `Display`, since `unwrap` shows it.
impl fmt::Debug for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
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
pub fn sum<R: Results>(parts: &[Outcome<R>]) -> Result<Outcome<R>, SumError> {
    let first = parts.first().ok_or(SumError::Empty)?;
    let count = first.shard.count();
    let mut found = std::collections::BTreeSet::new();
    for (position, part) in parts.iter().enumerate() {
        let shard = part.shard;
        if part.work != first.work || part.results.on() != first.results.on() {
            let [first, other] = [first, part].map(|part| match part.results.on() {
                on if on.is_empty() => format!("{:?}", part.work),
                on => format!("{:?} on {}", part.work, on.join(", ")),
            });
            return Err(SumError::OtherWork { position, first, other });
        }
        if shard.count() != count {
            return Err(SumError::OtherCount { position, first: first.shard, other: shard });
        }
        if part.interrupted {
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
    let mut parts: Vec<&Outcome<R>> = parts.iter().collect();
    parts.sort_by_key(|part| part.shard);
    let mut whole = Outcome { shard: Shard::WHOLE, ..parts[0].clone() };
    parts[1..].iter().for_each(|part| whole.results.absorb(&part.results));
    whole.results.complete();
    Ok(whole)
}
