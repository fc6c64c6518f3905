//! The `twinedge-trials` program: runs the engines of the library on the structures and validators of `twinedge`.

mod corrupt;
mod document;
mod effort;
mod fuzz_template;
mod judge;
mod output;
mod prove;
mod replay;
mod replay_map;
mod sample;
mod soak;
mod structures;
mod tables;

use clap::{ColorChoice, CommandFactory as _, Parser, Subcommand};
use clap_complete::Shell;
use output::{Failure, Verdict};
use std::process::ExitCode;

/// Tests half-edge structures and their validators, exhaustively and at random.
#[derive(Debug, Parser)]
#[command(name = "twinedge-trials", version, propagate_version = true, arg_required_else_help = true)]
#[command(after_help = "Examples:
  twinedge-trials prove
  twinedge-trials corrupt --edges 3
  twinedge-trials soak --on pointers
  twinedge-trials fuzz-template

Exit status: 0 all is well; 1 something is wrong with what was tested; 2 a file could not be read, or the command was \
misused; 130 interrupted (Ctrl-C).")]
struct Arguments {
    #[command(subcommand)]
    command: Command,

    /// Colour the text.
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t)]
    color: ColorChoice,

    /// Print no report: the exit status says it all. JSON and files are as ever.
    #[arg(short, long, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    Prove(prove::Prove),
    Corrupt(corrupt::Corrupt),
    Tables(tables::Tables),
    Sample(sample::Sample),
    Soak(soak::Soak),
    Replay(replay::Replay),
    FuzzTemplate(fuzz_template::FuzzTemplate),
    Sum(document::Sum),
    /// Print the completions for a shell.
    #[command(after_help = "Examples:
  source <(twinedge-trials completions bash)

Exit status: 0 they are printed; 2 misuse.")]
    Completions {
        /// The shell.
        shell: Shell,
    },
}

fn main() -> ExitCode {
    let Arguments { command, color, quiet } = Arguments::parse();
    output::configure(color, quiet);
    match run(command) {
        Ok(verdict) => verdict.status(),
        Err(failure) => failure.tell(),
    }
    .into()
}

fn run(command: Command) -> Result<Verdict, Failure> {
    match command {
        Command::Prove(prove) => prove.run(),
        Command::Corrupt(corrupt) => corrupt.run(),
        Command::Tables(tables) => tables.run(),
        Command::Sample(sample) => sample.run(),
        Command::Soak(soak) => soak.run(),
        Command::Replay(replay) => replay.run(),
        Command::FuzzTemplate(template) => template.run(),
        Command::Sum(sum) => sum.run(),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "twinedge-trials", &mut script);
            output::print_bytes(&script)?;
            Ok(Verdict::Sound)
        }
    }
}
