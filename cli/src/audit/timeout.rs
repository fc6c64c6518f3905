//! An end to work that takes too long.

use crate::status::{Failure, Verdict, named};
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// The stack of the work, which reads what may be nested deeply, as that of the main thread.
const STACK: usize = 8 << 20;

/// The right to write the outcome, which one of two takes.
#[derive(Default)]
pub(super) struct Claim(Mutex<bool>);

impl Claim {
    /// Takes the right to write. If time was up before, the program ends, and this does not return.
    pub(super) fn take(&self) {
        while !self.is_taken() {
            std::thread::park();
        }
    }

    /// Takes the right to write, if nobody has it.
    fn is_taken(&self) -> bool {
        let mut taken = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        !std::mem::replace(&mut *taken, true)
    }
}

/// Does the work. If it has taken so many seconds and not yet claimed to write its outcome, `late` is done instead, and the program ends.
pub(super) fn within(
    seconds: Option<f64>,
    work: impl FnOnce(&Claim) -> Result<Verdict, Failure> + Send,
    late: impl FnOnce() -> Result<Verdict, Failure>,
) -> Result<Verdict, Failure> {
    let claim = &Claim::default();
    let Some(seconds) = seconds else { return work(claim) };
    let limit = Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
    std::thread::scope(|scope| {
        let (send, receive) = channel();
        let body = move || {
            // The other end is there as long as this one.
            let _ = send.send(work(claim));
        };
        std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, body).map_err(named("--timeout"))?;
        match receive.recv_timeout(limit) {
            Ok(outcome) => outcome,
            Err(RecvTimeoutError::Timeout) if claim.is_taken() => {
                let status = match late() {
                    Ok(verdict) => verdict.status(),
                    Err(failure) => failure.tell(),
                };
                // The work is not waited for.
                std::process::exit(status.into())
            }
            // Its outcome is being written.
            _ => receive.recv().unwrap_or_else(|_| Err(Failure("the audit ended without an outcome".to_owned()))),
        }
    })
}
