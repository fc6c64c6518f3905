//! The long commands: their options, the limit on the amount of work, progress bars and Ctrl-C.

use crate::document::{Document, Printed};
use crate::output::{Failure, Format, Verdict, grouped, print_json};
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use twinedge_trials::{Estimate, Outcome, Progress, Run, Shard};

/// The options that the long commands share.
#[derive(Debug, clap::Args)]
pub(crate) struct Effort {
    /// Run even if the estimate exceeds 30 minutes. Without it such a run is refused, with exit status 2; if the output format is
    /// JSON, standard output has `{"ok": false, "refused": "why"}`.
    #[arg(long)]
    force: bool,

    /// Number of threads. Default: one for each core.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,

    /// Do part K of N of the same work, counted from 0. `twinedge-trials sum` adds up the JSON output of all parts. Work that is
    /// drawn at random needs --seed, the same for all parts.
    #[arg(long, value_name = "K/N", default_value_t = Shard::WHOLE)]
    shard: Shard,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: Format,
}

#[derive(serde::Serialize)]
struct Refusal<'a> {
    ok: bool,
    refused: &'a str,
}

impl Effort {
    /// The maximal time without `--force`.
    const MOST_SECONDS: u128 = 30 * 60;

    /// Does the work of a command, unless it is too much, and prints the outcome.
    pub(crate) fn perform<R: Printed>(
        &self,
        estimate: Estimate,
        engine: impl FnOnce(&Run<'_>) -> Result<Outcome<R>, Failure>,
    ) -> Result<Verdict, Failure> {
        let run = self.begin(estimate)?;
        let start = Instant::now();
        let document = Document::new(engine(&run)?, start.elapsed());
        self.format.print(&document)?;
        Ok(document.verdict())
    }

    /// Refuses too much work. Returns the options of the engines.
    pub(crate) fn begin(&self, estimate: Estimate) -> Result<Run<'static>, Failure> {
        self.refuse_too_much(estimate)?;
        self.run()
    }

    /// Returns the options of the engines, with progress bars. Ctrl-C ends the work early, so that the results so far can be
    /// printed; a second Ctrl-C ends the program.
    pub(crate) fn run(&self) -> Result<Run<'static>, Failure> {
        static IS_SET: AtomicBool = AtomicBool::new(false);
        if !IS_SET.swap(true, Ordering::Relaxed) {
            ctrlc::set_handler(|| {
                if STOP.swap(true, Ordering::Relaxed) {
                    std::process::exit(Verdict::Interrupted.status().into());
                }
            })?;
        }
        Ok(Run::default().threads(self.threads()).shard(self.shard).progress(&BARS))
    }

    fn threads(&self) -> usize {
        self.threads.map_or_else(cores, usize::from)
    }

    /// Refuses work that takes too long, unless it is forced. More threads than cores are no faster. With JSON the refusal is also printed, so that
    /// scripts can tell it from misuse.
    fn refuse_too_much(&self, estimate: Estimate) -> Result<(), Failure> {
        if self.force || self.seconds(estimate) <= Self::MOST_SECONDS {
            return Ok(());
        }
        let refused = format!(
            "the job is {} at {} of them a second on each core; --force runs it all the same",
            self.said(estimate),
            grouped(estimate.per_second),
        );
        if self.format == Format::Json {
            print_json(&Refusal { ok: false, refused: &refused })?;
        }
        Err(Failure(refused))
    }

    /// Returns the amount and the time of this part, in words.
    pub(crate) fn said(&self, estimate: Estimate) -> String {
        let amount = estimate.amount / u128::from(self.shard.count());
        let amount = u64::try_from(amount).map_or_else(|_| format!("{:.1e}", amount as f64), grouped);
        format!("{amount} {}, {}", estimate.unit, about(self.seconds(estimate)))
    }

    fn seconds(&self, estimate: Estimate) -> u128 {
        estimate.seconds(self.threads().clamp(1, cores()), self.shard)
    }

    /// Returns the seed of the work: by default the time of day. Refuses parts of work without a given seed, because each part
    /// would have a different one.
    pub(crate) fn seed(&self, seed: Option<u64>) -> Result<u64, Failure> {
        match seed {
            Some(seed) => Ok(seed),
            None if !self.shard.is_whole() => {
                Err(Failure("--shard needs --seed: all parts must have the same seed".to_owned()))
            }
            None => {
                let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
                Ok(now.map_or(0, |since| since.as_nanos() as u64))
            }
        }
    }
}

fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, Into::into)
}

fn about(seconds: u128) -> String {
    match seconds {
        0..=119 => format!("about {seconds} seconds"),
        120..=7_200 => format!("about {} minutes", seconds.div_ceil(60)),
        7_201..=172_800 => format!("about {} hours", seconds / 3_600),
        172_801..=63_072_000 => format!("about {} days", seconds / 86_400),
        _ => {
            format!("about {} years", u64::try_from(seconds / 31_536_000).map_or_else(|_| "countless".into(), grouped))
        }
    }
}

/// True if the work must end early.
static STOP: AtomicBool = AtomicBool::new(false);

/// Ends the work early, like Ctrl-C.
pub(crate) fn stop() {
    STOP.store(true, Ordering::Relaxed);
}

/// A bar for each stage, if standard error is a terminal.
pub(crate) static BARS: Bars = Bars(Mutex::new(None));

pub(crate) struct Bars(Mutex<Option<ProgressBar>>);

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

#[cfg(test)]
mod tests {
    use super::about;

    #[test]
    fn times_are_told_in_a_fitting_unit() {
        for (seconds, told) in [
            (119, "about 119 seconds"),
            (120, "about 2 minutes"),
            (1_801, "about 31 minutes"),
            (7_201, "about 2 hours"),
            (172_801, "about 2 days"),
            (31_536_000 * 3, "about 3 years"),
            (u128::MAX, "about countless years"),
        ] {
            assert_eq!(about(seconds), told);
        }
    }
}
