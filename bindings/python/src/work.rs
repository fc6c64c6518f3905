//! Work that Ctrl-C or a time limit ends.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// The stack of the working thread, which reads deeply nested input: as large as the main thread's.
const STACK: usize = 8 << 20;

/// The time between two checks for signals.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// Does the work on a thread of its own, without the interpreter lock. Returns `None` if it takes more than the given
/// seconds; the thread then drops the result when it ends.
pub(crate) fn within<T: Send + 'static>(
    py: Python<'_>,
    seconds: Option<f64>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<Option<T>> {
    let (send, mut receive) = channel();
    let body = move || {
        // Nobody receives the result when time is up.
        let _ = send.send(work());
    };
    let end = seconds.and_then(|s| Instant::now().checked_add(Duration::try_from_secs_f64(s).ok()?));
    std::thread::Builder::new().stack_size(STACK).spawn(body)?;
    loop {
        let left =
            end.map_or(BETWEEN_SIGNALS, |end| end.saturating_duration_since(Instant::now()).min(BETWEEN_SIGNALS));
        let outcome;
        (outcome, receive) = py.detach(move || (receive.recv_timeout(left), receive));
        match outcome {
            Ok(outcome) => return Ok(Some(outcome)),
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("the work ended without an outcome"));
            }
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals()?;
                if end.is_some_and(|end| Instant::now() >= end) {
                    return Ok(None);
                }
            }
        }
    }
}
