//! The `twinedge` program: builds and audits planar maps.

mod audit;
mod input;
mod output;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Builds and audits planar maps, and the structure they are kept in.
#[derive(Debug, Parser)]
#[command(name = "twinedge", version, propagate_version = true, arg_required_else_help = true)]
#[command(
    after_help = "Exit status: 0 all is well; 1 something is wrong with what was examined; 2 the input could not be \
read, or the command was misused."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Audit(audit::Audit),
}

/// What a command came to, as exit codes say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    Sound,
    Wrong,
}

/// Why a command could not be carried out: one line for standard error.
#[derive(Debug)]
struct Failure(String);

impl<E: std::error::Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}

fn main() -> ExitCode {
    let verdict = match Arguments::parse().command {
        Command::Audit(audit) => audit.run(),
    };
    match verdict {
        Ok(Verdict::Sound) => ExitCode::SUCCESS,
        Ok(Verdict::Wrong) => ExitCode::from(1),
        Err(Failure(message)) => {
            eprintln!("twinedge: {message}");
            ExitCode::from(2)
        }
    }
}
