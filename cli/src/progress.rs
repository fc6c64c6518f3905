//! Progress bars on standard error, and Ctrl-C.

use crate::status::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use twinedge_trials::Progress;

static STOP: AtomicBool = AtomicBool::new(false);

/// Makes Ctrl-C end the work early, so that what was covered can be printed. The second one ends the program.
pub(crate) fn stop_on_interrupt() -> Result<(), Failure> {
    ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    })?;
    Ok(())
}

/// Ends the work early, as Ctrl-C does.
pub(crate) fn stop() {
    STOP.store(true, Ordering::Relaxed);
}

/// A bar for each stage, if standard error is a terminal.
pub(crate) static BARS: Bars = Bars(Mutex::new(None));

pub(crate) struct Bars(Mutex<Option<ProgressBar>>);

/// Does work that may take long, and says so after a second, if standard error is a terminal.
pub(crate) fn busy<T>(doing: &'static str, work: impl FnOnce() -> T) -> T {
    std::thread::scope(|scope| {
        let (done, waits) = std::sync::mpsc::channel::<()>();
        scope.spawn(move || {
            if waits.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
                let bar = ProgressBar::new_spinner().with_message(doing);
                if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}, {elapsed}") {
                    bar.set_style(style);
                }
                bar.enable_steady_tick(Duration::from_millis(250));
                // Until the other end is dropped.
                let _ = waits.recv();
                bar.finish_and_clear();
            }
        });
        let out = work();
        drop(done);
        out
    })
}

impl Bars {
    fn bar(&self) -> MutexGuard<'_, Option<ProgressBar>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Progress for Bars {
    fn begin(&self, stage: &str, pieces: Option<usize>) {
        let (bar, template) = match pieces {
            Some(pieces) => (ProgressBar::new(pieces as u64), "{msg} {bar:40} {human_pos}/{human_len}, {eta} left"),
            None => (ProgressBar::new_spinner(), "{spinner} {human_pos} {msg}"),
        };
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style);
        }
        bar.set_message(stage.to_owned());
        bar.enable_steady_tick(Duration::from_millis(250));
        *self.bar() = Some(bar);
    }

    fn advance(&self) {
        if let Some(bar) = &*self.bar() {
            bar.inc(1);
        }
    }

    fn end(&self) {
        if let Some(bar) = self.bar().take() {
            bar.finish_and_clear();
        }
    }

    fn is_stopped(&self) -> bool {
        STOP.load(Ordering::Relaxed)
    }
}
