//! Catches panics of a structure under test: a panic is a finding, not the end of the run.

#[cfg(feature = "std")]
pub use with_std::catch;

/// Runs `work`. Without `std`, a panic ends the program.
///
/// # Errors
/// None.
#[cfg(not(feature = "std"))]
pub fn catch<T>(work: impl FnOnce() -> T) -> Result<T, alloc::string::String> {
    Ok(work())
}

#[cfg(feature = "std")]
mod with_std {
    use std::cell::RefCell;
    use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
    use std::prelude::v1::*;
    use std::sync::Once;

    std::thread_local! {
        /// The message of the last panic of this thread, while its panics are being caught.
        static CAUGHT: RefCell<Option<String>> = const { RefCell::new(None) };
    }

    fn in_words(info: &PanicHookInfo<'_>) -> String {
        let payload = info.payload();
        let literal = payload.downcast_ref::<&str>().copied();
        let message = literal.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        let message = message.unwrap_or("no message").lines().collect::<Vec<_>>().join(" ");
        info.location().map_or_else(|| message.clone(), |at| std::format!("{message} ({}:{})", at.file(), at.line()))
    }

    /// Runs `work`. The first call installs a panic hook that forwards all other panics to the previous hook. Caught panics print
    /// nothing, and never reach a hook that ends the program, such as libFuzzer's.
    ///
    /// # Errors
    /// The message of a panic.
    pub fn catch<T>(work: impl FnOnce() -> T) -> Result<T, String> {
        static HOOK: Once = Once::new();
        HOOK.call_once(|| {
            let others = take_hook();
            set_hook(Box::new(move |info| {
                let said = CAUGHT.with_borrow_mut(|caught| caught.as_mut().map(|said| *said = in_words(info)));
                if said.is_none() {
                    others(info);
                }
            }));
        });
        let outer = CAUGHT.replace(Some(String::new()));
        let done = catch_unwind(AssertUnwindSafe(work));
        let said = CAUGHT.replace(outer).unwrap_or_default();
        done.map_err(|_| said)
    }
}
