//! Noticing that a validation does not return.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// After how long a validation counts as hung, should it ever return.
pub(super) const HUNG: Duration = Duration::from_secs(1);

/// After how long the wait for one ends.
const GIVEN_UP: Duration = Duration::from_mins(1);

/// What one thread is doing.
#[derive(Debug, Default)]
pub(super) struct Watched {
    /// When its present validation began, in milliseconds of the watch and one more; 0 between two.
    since: AtomicU64,
    /// What it is about.
    about: Mutex<String>,
}

/// Looks after the validations of all threads.
#[derive(Debug)]
pub(super) struct Watch {
    start: Instant,
    threads: Mutex<Vec<std::sync::Arc<Watched>>>,
    over: AtomicBool,
}

impl Watch {
    pub(super) fn new() -> Self {
        Self { start: Instant::now(), threads: Mutex::default(), over: AtomicBool::new(false) }
    }

    /// One more thread to be watched.
    pub(super) fn thread(&self) -> std::sync::Arc<Watched> {
        let watched = std::sync::Arc::new(Watched::default());
        self.threads.lock().unwrap_or_else(PoisonError::into_inner).push(watched.clone());
        watched
    }

    /// Runs `work` and watches meanwhile: if a validation does not return, says about what and ends the program, which is
    /// all that can be done about a thread.
    pub(super) fn during<T>(&self, work: impl FnOnce() -> T) -> T {
        std::thread::scope(|scope| {
            let watching = scope.spawn(|| {
                while !self.over.load(Ordering::Relaxed) {
                    std::thread::park_timeout(Duration::from_millis(500));
                    self.look();
                }
            });
            let done = work();
            self.over.store(true, Ordering::Relaxed);
            watching.thread().unpark();
            done
        })
    }

    fn look(&self) {
        let now = self.start.elapsed().as_millis() as u64;
        for watched in self.threads.lock().unwrap_or_else(PoisonError::into_inner).iter() {
            let since = watched.since.load(Ordering::Relaxed);
            if since > 0 && now.saturating_sub(since) > GIVEN_UP.as_millis() as u64 {
                let about = watched.about.lock().unwrap_or_else(PoisonError::into_inner);
                eprintln!("twinedge: a validation does not return: {about}");
                std::process::exit(1);
            }
        }
    }

    /// Times one validation.
    pub(super) fn time<T>(&self, watched: &Watched, validation: impl FnOnce() -> T) -> (T, Duration) {
        let start = self.start.elapsed();
        watched.since.store(start.as_millis() as u64 + 1, Ordering::Relaxed);
        let result = validation();
        watched.since.store(0, Ordering::Relaxed);
        (result, self.start.elapsed().saturating_sub(start))
    }
}

impl Watched {
    /// What the next validations are about.
    pub(super) fn about(&self, what: String) {
        *self.about.lock().unwrap_or_else(PoisonError::into_inner) = what;
    }
}
