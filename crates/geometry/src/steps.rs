//! Steps of work, counted with debug assertions, so that tests bound the work of a function without a clock.

#[cfg(debug_assertions)]
std::thread_local! {
    static STEPS: core::cell::Cell<u64> = const { core::cell::Cell::new(0) };
}

/// Counts one step of work: an orientation or a step in a tree. Optimised programs do not count.
#[inline]
pub fn count_step() {
    #[cfg(debug_assertions)]
    STEPS.set(STEPS.get() + 1);
}

/// Runs `f`, and returns its result and the number of steps it took on this thread.
#[cfg(debug_assertions)]
pub fn steps_of<T>(f: impl FnOnce() -> T) -> (T, u64) {
    let before = STEPS.get();
    let result = f();
    (result, STEPS.get() - before)
}
