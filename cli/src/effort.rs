//! The options shared by the long commands: threads, the part of the work, and the limit on the amount of work.

use crate::output::{Format, grouped, print_json};
use crate::progress;
use crate::status::Failure;
use twinedge_trials::{Estimate, Run, Shard};

/// The options that the long commands share.
#[derive(Debug, clap::Args)]
pub(crate) struct Effort {
    /// Run even if the estimate exceeds 30 minutes. Without it such a run is refused, with exit status 2; if the output format is
    /// JSON, standard output has `{"ok": false, "refused": "why"}`.
    #[arg(long)]
    pub(crate) force: bool,

    /// Number of threads. Default: one for each core.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    threads: Option<u16>,

    /// Do part K of N of the same work, counted from 0. `twinedge sum` adds up the JSON output of all parts. Work that is drawn at
    /// random needs --seed, the same for all parts.
    #[arg(long, value_name = "K/N", default_value_t = Shard::WHOLE)]
    pub(crate) shard: Shard,
}

#[derive(serde::Serialize)]
struct Refusal<'a> {
    ok: bool,
    refused: &'a str,
}

impl Effort {
    /// The maximal time without `--force`.
    const MOST_SECONDS: u128 = 30 * 60;

    /// Returns the options of the engines, with progress bars and a stop on Ctrl-C.
    pub(crate) fn start(&self) -> Result<Run<'static>, Failure> {
        progress::stop_on_interrupt()?;
        Ok(Run::default().threads(self.threads()).shard(self.shard).progress(&progress::BARS))
    }

    fn threads(&self) -> usize {
        self.threads.map_or_else(cores, usize::from)
    }

    /// Refuses work that takes too long, unless it is forced. More threads than cores are no faster. With JSON the refusal is also printed, so that
    /// scripts can tell it from misuse.
    pub(crate) fn refuse_too_much(&self, estimate: Estimate, format: Format) -> Result<(), Failure> {
        if self.force || self.seconds(estimate) <= Self::MOST_SECONDS {
            return Ok(());
        }
        let refused = format!(
            "the job is {} at {} of them a second on each core; --force runs it all the same",
            self.said(estimate),
            grouped(estimate.per_second),
        );
        if format == Format::Json {
            print_json(&Refusal { ok: false, refused: &refused })?;
        }
        Err(Failure(refused))
    }

    pub(crate) fn say(&self, estimate: Estimate) {
        eprintln!("estimated: {}", self.said(estimate));
    }

    /// The amount and the time of this part, in words.
    fn said(&self, estimate: Estimate) -> String {
        let amount = estimate.amount / u128::from(self.shard.count());
        let amount = u64::try_from(amount).map_or_else(|_| format!("{:.1e}", amount as f64), grouped);
        format!("{amount} {}, {}", estimate.unit, about(self.seconds(estimate)))
    }

    fn seconds(&self, estimate: Estimate) -> u128 {
        estimate.seconds(self.threads().clamp(1, cores()), self.shard)
    }

    /// Refuses parts of work with a random seed, because each part would have a different seed.
    pub(crate) fn needs_seed(&self, seed: Option<u64>) -> Result<(), Failure> {
        match seed {
            None if !self.shard.is_whole() => {
                Err(Failure("--shard needs --seed: all parts must have the same seed".to_owned()))
            }
            _ => Ok(()),
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

/// A seed that differs from run to run: the time of day.
pub(crate) fn seed_of_the_moment() -> u64 {
    std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0, |since| since.as_nanos() as u64)
}

#[cfg(test)]
mod tests {
    use super::about;

    #[test]
    fn times_are_told_in_a_fitting_unit() {
        assert_eq!(about(119), "about 119 seconds");
        assert_eq!(about(120), "about 2 minutes");
        assert_eq!(about(1_801), "about 31 minutes");
        assert_eq!(about(7_201), "about 2 hours");
        assert_eq!(about(172_801), "about 2 days");
        assert_eq!(about(31_536_000 * 3), "about 3 years");
        assert_eq!(about(u128::MAX), "about countless years");
    }
}
