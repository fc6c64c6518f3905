//! Settings of a run: threads, the part of the work, progress, and the estimate of its time.

use crate::shard::Shard;
use std::fmt;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Receives the progress of a run, and can stop it.
///
/// ```
/// use std::time::{Duration, Instant};
/// use twinedge_trials::Progress;
/// /// Stops a run at a point in time.
/// struct Until(Instant);
/// impl Progress for Until {
///     fn is_stopped(&self) -> bool {
///         Instant::now() >= self.0
///     }
/// }
/// # assert!(!Until(Instant::now() + Duration::from_secs(60)).is_stopped());
/// ```
pub trait Progress: Sync {
    /// A stage of the work begins, with this number of pieces, if it is known.
    fn begin(&self, stage: &str, pieces: Option<usize>) {
        let _ = (stage, pieces);
    }

    /// One piece of the current stage is done. Called by all threads.
    fn advance(&self) {}

    /// The current stage is over.
    fn end(&self) {}

    /// Returns true to stop the run. Called often, by all threads, so it should be fast.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// Shows nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {}

/// The settings of a run. By default: on all cores, the whole work, silently.
///
/// ```
/// use twinedge_trials::{Run, Shard};
/// // One thread, the first of four parts of the work.
/// let run = Run::default().threads(1).shard(Shard::new(0, 4)?);
/// # Ok::<(), twinedge_trials::ShardError>(())
/// ```
#[derive(Clone, Copy)]
pub struct Run<'a> {
    threads: usize,
    shard: Shard,
    progress: &'a dyn Progress,
}

impl Default for Run<'_> {
    fn default() -> Self {
        Self { threads: cores(), shard: Shard::WHOLE, progress: &Silent }
    }
}

impl fmt::Debug for Run<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Run").field("threads", &self.threads).field("shard", &self.shard).finish_non_exhaustive()
    }
}

impl<'a> Run<'a> {
    /// Sets the number of threads; 0 counts as 1.
    #[must_use]
    pub const fn threads(mut self, threads: usize) -> Self {
        self.threads = if threads == 0 { 1 } else { threads };
        self
    }

    /// Selects one part of the work.
    #[must_use]
    pub const fn shard(mut self, shard: Shard) -> Self {
        self.shard = shard;
        self
    }

    /// Sets the receiver of progress.
    #[must_use]
    pub const fn progress(mut self, progress: &'a dyn Progress) -> Self {
        self.progress = progress;
        self
    }

    pub(crate) const fn part(&self) -> Shard {
        self.shard
    }

    pub(crate) fn reporter(&self) -> &'a dyn Progress {
        self.progress
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.progress.is_stopped()
    }

    /// Does `each` for every number below `count`, on all threads, until stopped. Returns the states of the threads.
    pub(crate) fn each<L: Send>(
        &self,
        stage: &str,
        count: usize,
        state: impl Fn() -> L + Sync,
        each: impl Fn(&mut L, usize) + Sync,
    ) -> Vec<L> {
        let taken = AtomicUsize::new(0);
        let work = || {
            let mut local = state();
            while !self.is_stopped() {
                let number = taken.fetch_add(1, Ordering::Relaxed);
                if number >= count {
                    break;
                }
                each(&mut local, number);
                self.progress.advance();
            }
            local
        };
        self.progress.begin(stage, Some(count));
        let states = std::thread::scope(|scope| {
            let workers: Vec<_> = (1..self.threads).map(|_| scope.spawn(work)).collect();
            let mut states = vec![work()];
            for worker in workers {
                match worker.join() {
                    Ok(state) => states.push(state),
                    Err(panic) => std::panic::resume_unwind(panic),
                }
            }
            states
        });
        self.progress.end();
        states
    }
}

fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, Into::into)
}

/// The approximate amount of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Estimate {
    /// The number of units.
    pub amount: u128,
    /// The unit, in the plural.
    pub unit: &'static str,
    /// The number of units per second and thread: on a machine of 2024, or on this one if the work measures it.
    pub per_second: u64,
}

impl Estimate {
    /// Returns the approximate number of seconds for one part on this many cores.
    ///
    /// ```
    /// use twinedge_trials::{Estimate, Shard};
    /// let estimate = Estimate { amount: 8_000, unit: "maps", per_second: 100 };
    /// assert_eq!(estimate.seconds(2, Shard::new(0, 4)?), 10);
    /// # Ok::<(), twinedge_trials::ShardError>(())
    /// ```
    #[must_use]
    pub fn seconds(&self, cores: usize, shard: Shard) -> u128 {
        self.amount / u128::from(self.per_second.max(1)) / cores.max(1) as u128 / u128::from(shard.count())
    }
}
