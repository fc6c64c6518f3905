//! Panics of the structure under test: a finding, not the end of the run.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// The message of the last panic of this thread, while its panics are caught.
    static CAUGHT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// The message and the place of a panic, in one line.
fn in_words(info: &PanicHookInfo<'_>) -> String {
    let payload = info.payload();
    let literal = payload.downcast_ref::<&str>().copied();
    let message = literal.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let message = message.unwrap_or("no message").lines().collect::<Vec<_>>().join(" ");
    info.location().map_or_else(|| message.clone(), |at| format!("{message} ({}:{})", at.file(), at.line()))
}

/// Runs `work`. If it panics, returns the message instead of printing it. The first call installs a panic hook that hands all
/// other panics to the hook that was there before.
pub(crate) fn catch<T>(work: impl FnOnce() -> T) -> Result<T, String> {
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

#[cfg(test)]
mod tests {
    use super::catch;

    #[test]
    fn the_message_of_a_panic_is_kept_in_one_line() {
        assert_eq!(catch(|| 7), Ok(7));
        let said = catch(|| panic!("first\nsecond")).unwrap_err();
        assert!(said.starts_with("first second (") && said.contains("panics.rs:"), "{said}");
        let said = catch(|| std::panic::panic_any(7)).unwrap_err();
        assert!(said.starts_with("no message ("), "{said}");
    }

    #[test]
    fn catching_can_be_nested() {
        let said = catch(|| {
            assert!(catch(|| panic!("inner")).is_err());
            panic!("outer")
        });
        assert!(said.unwrap_err().starts_with("outer ("));
    }
}
