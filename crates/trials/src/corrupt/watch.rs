//! Detecting a validation that takes very long, or does not return.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The time after which a validation counts as hung.
pub const HUNG: Duration = Duration::from_secs(1);

/// The number of times that a validation is timed before it counts as hung: the machine may be busy, or the program suspended.
const TRIES: usize = 3;

/// The time between two looks, and the number of consecutive looks that must find a thread in the same validation before it is
/// taken not to return. Looks are counted instead of seconds, because a suspended program does not look either.
const PAUSE: Duration = Duration::from_millis(500);
const LOOKS: u32 = 120;

pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[derive(Debug)]
pub(super) struct Watchpoint<A> {
    /// The number of starts and ends of validations: odd while one runs.
    steps: AtomicU64,
    about: Mutex<Option<A>>,
}

impl<A> Watchpoint<A> {
    /// Runs a validation and measures its time; again if it takes suspiciously long, and then the shortest time counts.
    pub(super) fn time<T>(&self, about: A, validation: impl Fn() -> T) -> (T, Duration) {
        *lock(&self.about) = Some(about);
        let once = || {
            self.steps.fetch_add(1, Ordering::Relaxed);
            let start = Instant::now();
            let result = validation();
            let time = start.elapsed();
            self.steps.fetch_add(1, Ordering::Relaxed);
            (result, time)
        };
        let mut best = once();
        for _ in 1..TRIES {
            if best.1 <= HUNG {
                break;
            }
            let again = once();
            best.1 = best.1.min(again.1);
        }
        best
    }
}

/// Watches the validations of all threads. `A` describes a validation.
#[derive(Debug)]
pub(super) struct Watch<A> {
    threads: Mutex<Vec<Arc<Watchpoint<A>>>>,
    over: AtomicBool,
}

/// Ends the watch when it is dropped, so that a panic of the work does not leave it running.
struct Over<'a>(&'a AtomicBool, std::thread::Thread);

impl Drop for Over<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
        self.1.unpark();
    }
}

impl<A: Copy + Send> Watch<A> {
    pub(super) const fn new() -> Self {
        Self { threads: Mutex::new(Vec::new()), over: AtomicBool::new(false) }
    }

    pub(super) fn thread(&self) -> Arc<Watchpoint<A>> {
        let watched = Arc::new(Watchpoint { steps: AtomicU64::new(0), about: Mutex::new(None) });
        lock(&self.threads).push(watched.clone());
        watched
    }

    /// Runs `work` under watch. If a validation does not end, calls `hangs`, which should end the program: a thread cannot be
    /// stopped.
    pub(super) fn during<T>(&self, work: impl FnOnce() -> T, hangs: impl Fn(A) + Sync) -> T {
        self.during_with(PAUSE, work, hangs)
    }

    fn during_with<T>(&self, pause: Duration, work: impl FnOnce() -> T, hangs: impl Fn(A) + Sync) -> T {
        std::thread::scope(|scope| {
            let watching = scope.spawn(|| {
                // The step of each thread, and the number of looks that found it there.
                let mut seen: Vec<(u64, u32)> = Vec::new();
                while !self.over.load(Ordering::Relaxed) {
                    std::thread::park_timeout(pause);
                    if let Some(about) = self.look(&mut seen) {
                        hangs(about);
                    }
                }
            });
            let _over = Over(&self.over, watching.thread().clone());
            work()
        })
    }

    /// Returns the validation, if any, that does not return.
    fn look(&self, seen: &mut Vec<(u64, u32)>) -> Option<A> {
        let threads = lock(&self.threads);
        seen.resize(threads.len(), (0, 0));
        threads.iter().zip(seen).find_map(|(watched, (last, looks))| {
            let step = watched.steps.load(Ordering::Relaxed);
            *looks = if step == *last && step % 2 == 1 { *looks + 1 } else { 0 };
            *last = step;
            if *looks >= LOOKS { *lock(&watched.about) } else { None }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_validation_that_does_not_return_is_named() {
        let (watch, told) = (Watch::new(), Mutex::new(None));
        let work = || {
            watch.thread().time("the third", || {
                while lock(&told).is_none() {
                    std::thread::yield_now();
                }
            });
        };
        watch.during_with(Duration::from_millis(1), work, |about| *lock(&told) = Some(about));
        assert_eq!(*lock(&told), Some("the third"));
    }

    #[test]
    fn a_validation_that_is_slow_only_once_does_not_hang() {
        let watch = Watch::new();
        let stopped = AtomicBool::new(true);
        let ((), time) = watch.thread().time((), || {
            if stopped.swap(false, Ordering::Relaxed) {
                std::thread::sleep(HUNG + Duration::from_millis(10));
            }
        });
        assert!(time <= HUNG);
    }

    #[test]
    fn a_panic_of_the_work_ends_the_watch() {
        let watch = Watch::<()>::new();
        let work = || watch.during(|| panic!("the work"), |()| {});
        assert!(twinedge::program::panics::catch(work).is_err());
    }
}
