//! Progress bars on standard error, and Ctrl-C.

use crate::status::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use tempfile::TempDir;
use twinedge_trials::Progress;

/// True if the work must end early.
static STOP: AtomicBool = AtomicBool::new(false);

/// True if the work checks `STOP`.
static CAN_STOP: AtomicBool = AtomicBool::new(false);

/// The folder with unfinished files, if there is one.
static SCRATCH: Mutex<Option<PathBuf>> = Mutex::new(None);

/// The exit status of an interrupted program.
const INTERRUPTED: i32 = 130;

/// Makes Ctrl-C end the work early, so that the results so far can be printed. A second Ctrl-C ends the program.
pub(crate) fn stop_on_interrupt() -> Result<(), Failure> {
    CAN_STOP.store(true, Ordering::Relaxed);
    handle_interrupts()
}

/// Creates a folder for unfinished files. From then until [`finished`], Ctrl-C removes the folder and ends the program.
pub(crate) fn unfinished(make: impl FnOnce() -> Result<TempDir, Failure>) -> Result<TempDir, Failure> {
    handle_interrupts()?;
    // The lock keeps Ctrl-C out until the folder is recorded.
    let mut scratch = locked(&SCRATCH);
    let folder = make()?;
    *scratch = Some(folder.path().to_owned());
    Ok(folder)
}

/// Declares that there are no unfinished files any more.
pub(crate) fn finished() {
    *locked(&SCRATCH) = None;
}

fn handle_interrupts() -> Result<(), Failure> {
    static IS_SET: AtomicBool = AtomicBool::new(false);
    if IS_SET.swap(true, Ordering::Relaxed) {
        return Ok(());
    }
    ctrlc::set_handler(|| {
        if CAN_STOP.load(Ordering::Relaxed) && !STOP.swap(true, Ordering::Relaxed) {
            return;
        }
        if let Some(folder) = &*locked(&SCRATCH) {
            // The program ends either way.
            let _ = std::fs::remove_dir_all(folder);
        }
        std::process::exit(INTERRUPTED);
    })?;
    Ok(())
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the work early, like Ctrl-C.
pub(crate) fn stop() {
    STOP.store(true, Ordering::Relaxed);
}

/// A bar for each stage, if standard error is a terminal.
pub(crate) static BARS: Bars = Bars(Mutex::new(None));

pub(crate) struct Bars(Mutex<Option<ProgressBar>>);

/// Does work that may take long. The work reports its stages; if standard error is a terminal, a stage that takes longer than a second is shown.
pub(crate) fn busy<T>(work: impl FnOnce(&mut dyn FnMut(&'static str)) -> T) -> T {
    std::thread::scope(|scope| {
        let (begins, stages) = std::sync::mpsc::channel();
        scope.spawn(move || {
            let mut stage = stages.recv().ok();
            while let Some(doing) = stage {
                stage = match stages.recv_timeout(Duration::from_secs(1)) {
                    Err(RecvTimeoutError::Timeout) => {
                        let bar = ProgressBar::new_spinner().with_message(doing);
                        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}, {elapsed}") {
                            bar.set_style(style);
                        }
                        bar.enable_steady_tick(Duration::from_millis(250));
                        // Waits for the next stage, or the end.
                        let next = stages.recv();
                        bar.finish_and_clear();
                        next.ok()
                    }
                    next => next.ok(),
                };
            }
        });
        work(&mut |stage| {
            // The receiver lives as long as this sender.
            let _ = begins.send(stage);
        })
    })
}

impl Bars {
    fn bar(&self) -> MutexGuard<'_, Option<ProgressBar>> {
        locked(&self.0)
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
