//! Runs a program: the rules judge after each step, and panics are caught.

use crate::peer::{Applied, Peer};
use crate::program::Program;
use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;
use twinedge::validate::Report;

/// The result of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// No finding: every step left a structure that keeps the rules.
    Sound {
        /// The number of calls that were made and returned.
        done: usize,
        /// The number of calls that returned an error.
        refused: usize,
        /// The number of calls that were not made.
        skipped: usize,
    },
    /// A finding.
    Finding(Finding),
}

/// A broken rule, a panic, or a call that did not return.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The operator called last.
    pub operator: String,
    /// The effect, in the same words for the same cause: `breaks L3`, `panics at src/cdt.rs:120`.
    pub what: String,
    /// The violation or the message.
    pub detail: String,
}

impl Finding {
    /// The key by which findings are counted.
    #[must_use]
    pub fn signature(&self) -> String {
        format!("{} {}", self.operator, self.what)
    }
}

/// Runs a program on the empty structure, up to the first finding. The closure is called before each call.
pub fn run<P: Peer>(program: &Program, before: &mut dyn FnMut(&str)) -> Verdict {
    let mut peer = P::new();
    let (mut done, mut refused, mut skipped) = (0, 0, 0);
    for step in &program.0 {
        let operator = P::OPERATORS[step.operator].name;
        let found = |what, detail| Verdict::Finding(Finding { operator: operator.to_owned(), what, detail });
        before(operator);
        match caught(|| peer.apply(operator, &step.arguments)) {
            Ok(Applied::Done) => done += 1,
            Ok(Applied::Refused) => refused += 1,
            Ok(Applied::Skipped) => {
                skipped += 1;
                continue;
            }
            Err((place, message)) => return found(format!("panics at {place}"), message),
        }
        match caught(|| first_broken(&peer.report())) {
            Ok(None) => {}
            Ok(Some((rule, text))) => {
                let own = match caught(|| peer.own_check()) {
                    Ok(Some(true)) => ", and the crate's own check accepts",
                    Ok(Some(false)) => ", and the crate's own check refuses",
                    Ok(None) => "",
                    Err(_) => ", and the crate's own check panics",
                };
                return found(format!("breaks {rule}{own}"), text);
            }
            Err((place, message)) => return found(format!("leaves what cannot be read, {place}"), message),
        }
    }
    Verdict::Sound { done, refused, skipped }
}

/// Returns the first broken rule with its first violation.
#[must_use]
pub fn first_broken(report: &Report) -> Option<(String, String)> {
    let violation = report.first()?;
    Some((violation.rule().to_string().split(' ').next().unwrap_or_default().to_owned(), violation.message()))
}

/// Returns the result of the closure, or the place and the message of its panic.
///
/// # Errors
/// If the closure panics.
pub fn caught<T>(closure: impl FnOnce() -> T) -> Result<T, (String, String)> {
    static HOOK: Once = Once::new();
    thread_local! {
        static LAST: RefCell<Option<(String, String)>> = const { RefCell::new(None) };
    }
    HOOK.call_once(|| {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            let place = info.location().map_or(String::new(), |place| format!("{}:{}", place.file(), place.line()));
            if !place.contains(concat!(env!("CARGO_PKG_NAME"), "/tests")) && !place.starts_with("tests/") {
                let message = info.payload_as_str().unwrap_or("a panic without text").replace(['\n', '\t'], " ");
                LAST.with_borrow_mut(|last| *last = Some((short(&place), message)));
            } else {
                before(info);
            }
        }));
    });
    catch_unwind(AssertUnwindSafe(closure)).map_err(|_| {
        LAST.with_borrow_mut(Option::take).unwrap_or_else(|| ("an unknown place".to_owned(), String::new()))
    })
}

/// The place relative to Cargo's folder of the crate.
fn short(place: &str) -> String {
    let parts = place.split('/').collect::<Vec<_>>();
    let from = parts.iter().rposition(|part| *part == "src").unwrap_or(0);
    parts[from.saturating_sub(1)..].join("/")
}
