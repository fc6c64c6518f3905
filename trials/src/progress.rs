//! Progress of a run, and the way to stop it.

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
