//! Panics of what is on trial: a finding, not the end of the program.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// What this thread last panicked with, while its panics are caught.
    static CAUGHT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// What a panic said and where, in one line.
fn in_words(info: &PanicHookInfo<'_>) -> String {
    let message = info.payload_as_str().unwrap_or("no message").lines().collect::<Vec<_>>().join(" ");
    info.location().map_or_else(|| message.clone(), |at| format!("{message} ({}:{})", at.file(), at.line()))
}

/// Runs `work`. If it panics, gives what the panic said instead of printing it.
pub(crate) fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
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
    CAUGHT.set(Some(String::new()));
    let done = catch_unwind(AssertUnwindSafe(work));
    let said = CAUGHT.take().unwrap_or_default();
    done.map_err(|_| said)
}

#[cfg(test)]
mod tests {
    use super::caught;

    #[test]
    fn what_a_panic_said_is_kept_in_one_line() {
        assert_eq!(caught(|| 7), Ok(7));
        let said = caught(|| panic!("first\nsecond")).unwrap_err();
        assert!(said.starts_with("first second (") && said.contains("caught.rs:"), "{said}");
        let said = caught(|| std::panic::panic_any(7)).unwrap_err();
        assert!(said.starts_with("no message ("), "{said}");
    }
}
