//! A time limit for long work.

use crate::output::{Failure, Verdict, named};
use std::sync::Mutex;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// The stack of the working thread, which may read deeply nested input: as large as the main thread's.
const STACK: usize = 8 << 20;

/// The right to write the outcome, taken by one of two threads.
#[derive(Default)]
pub(super) struct Claim(Mutex<bool>);

impl Claim {
    /// Takes the right to write. If the time was up before, this does not return, and the program ends.
    pub(super) fn take(&self) {
        while !self.is_taken() {
            std::thread::park();
        }
    }

    fn is_taken(&self) -> bool {
        let mut taken = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        !std::mem::replace(&mut *taken, true)
    }
}

/// Does the work. After `seconds`, unless the work has claimed the right to write its outcome, calls `late` and ends the program.
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
            // The receiver lives as long as this sender.
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
                // Do not wait for the work.
                std::process::exit(status.into())
            }
            // Its outcome is being written.
            _ => receive.recv().unwrap_or_else(|_| Err(Failure("the audit ended without an outcome".to_owned()))),
        }
    })
}
