//! Progress bars on standard error, and Ctrl-C.

use crate::output::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::RecvTimeoutError;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;
use tempfile::TempDir;

/// The folder with unfinished files, if there is one.
static SCRATCH: Mutex<Option<PathBuf>> = Mutex::new(None);

/// The exit status of an interrupted program.
const INTERRUPTED: i32 = 130;

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
