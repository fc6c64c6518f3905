//! Work that Ctrl-C and time end.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// The stack of the work, which reads what may be nested deeply, as that of the main thread.
const STACK: usize = 8 << 20;

/// The time from one look at signals to the next.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// Does the work on a thread of its own, without the interpreter lock. None, if it takes more seconds than it may. What is then still done is dropped when it ends.
pub(crate) fn within<T: Send + 'static>(
    py: Python<'_>,
    seconds: Option<f64>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<Option<T>> {
    let (send, mut receive) = channel();
    let body = move || {
        // Nobody receives it when time is up.
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
