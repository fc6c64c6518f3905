//! Long work: how much of it is too much, how far it has come, how it is shared among threads, and how it is interrupted.

use crate::Failure;
use crate::output::{Format, grouped, print_json};
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

/// What the long commands have in common.
#[derive(Debug, clap::Args)]
pub(crate) struct Effort {
    /// Do the work however long it takes. What would take more than half an hour is refused otherwise, with status 2, and with
    /// `{"ok": false, "refused": "why"}` on standard output where the format is JSON.
    #[arg(long)]
    pub(crate) force: bool,

    /// How many threads work; as many as the machine runs at once, unless said otherwise.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,
}

impl Effort {
    pub(crate) fn threads(&self) -> usize {
        self.threads.map_or_else(at_once, usize::from)
    }

    /// Refuses work that would not finish, unless it is forced. `amount` is how much there is, in so many `units`, and one
    /// thread does `per_second` of them. More threads than the machine runs at once do not do more. With JSON the refusal is
    /// printed as well, so that scripts can tell it from misuse.
    pub(crate) fn refuse_too_much(
        &self,
        amount: u128,
        units: &str,
        per_second: u64,
        format: Format,
    ) -> Result<(), Failure> {
        let seconds = amount / u128::from(per_second.max(1)) / self.threads().clamp(1, at_once()) as u128;
        if self.force || seconds <= Self::MOST_SECONDS {
            return Ok(());
        }
        let amount = u64::try_from(amount).map_or_else(|_| format!("{:.1e}", amount as f64), grouped);
        let refused =
            format!("the job is {amount} {units}, {} on this machine; ask for it with --force", about(seconds));
        if format == Format::Json {
            print_json(&Refusal { ok: false, refused: &refused })?;
        }
        Err(Failure(refused))
    }

    /// What is done without being forced.
    const MOST_SECONDS: u128 = 30 * 60;
}

/// How many threads the machine runs at once.
fn at_once() -> usize {
    std::thread::available_parallelism().map_or(1, Into::into)
}

#[derive(serde::Serialize)]
struct Refusal<'a> {
    ok: bool,
    refused: &'a str,
}

/// A time in words.
fn about(seconds: u128) -> String {
    match seconds {
        0..=7_200 => format!("about {} minutes", seconds.div_ceil(60)),
        7_201..=172_800 => format!("about {} hours", seconds / 3_600),
        172_801..=63_072_000 => format!("about {} days", seconds / 86_400),
        _ => format!("about {} years", u64::try_from(seconds / 31_536_000).map_or_else(|_| "endless".into(), grouped)),
    }
}

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

/// Whether the work is to end.
pub(crate) fn stopped() -> bool {
    STOP.load(Ordering::Relaxed)
}

/// A bar on standard error, if that is a terminal.
pub(crate) fn bar(length: usize, what: impl Into<std::borrow::Cow<'static, str>>) -> ProgressBar {
    let bar = ProgressBar::new(length as u64).with_message(what);
    if let Ok(style) = ProgressStyle::with_template("{msg} {bar:40} {human_pos}/{human_len}, {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(250));
    bar
}

/// The same where it is not known how much there will be.
pub(crate) fn spinner(what: &'static str) -> ProgressBar {
    let spinner = ProgressBar::new_spinner().with_message(what);
    if let Ok(style) = ProgressStyle::with_template("{spinner} {human_pos} {msg}") {
        spinner.set_style(style);
    }
    spinner.enable_steady_tick(Duration::from_millis(250));
    spinner
}

/// Does `each` to so many items, by their numbers, on several threads, each with state of its own, until told to stop. Gives
/// the states.
pub(crate) fn share<L: Send>(
    threads: usize,
    count: usize,
    bar: &ProgressBar,
    state: impl Fn() -> L + Sync,
    each: impl Fn(&mut L, usize) + Sync,
) -> Vec<L> {
    let taken = AtomicUsize::new(0);
    let work = || {
        let mut local = state();
        while !stopped() {
            let number = taken.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                break;
            }
            each(&mut local, number);
            bar.inc(1);
        }
        local
    };
    let states = std::thread::scope(|scope| {
        let workers: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let mut states = vec![work()];
        for worker in workers {
            match worker.join() {
                Ok(state) => states.push(state),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        states
    });
    bar.finish_and_clear();
    states
}
