//! The `twinedge` program: audits, cleans, converts, certifies, queries and draws planar maps.
//!
//! This crate handles arguments, text, JSON, progress bars and Ctrl-C.

mod audit;
mod certificate;
mod clean;
mod convert;
mod decompose;
mod diff;
mod draw;
mod input;
mod on_disk;
mod output;
mod output_file;
mod overlay;
mod postgis;
mod progress;
mod query;
mod tile;
mod voronoi;

use clap::{ColorChoice, CommandFactory as _, Parser, Subcommand};
use clap_complete::Shell;
use output::{Failure, Verdict};
use std::process::ExitCode;

#[cfg(feature = "full")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Audits, cleans, converts, certifies, queries and draws planar maps and meshes.
#[derive(Debug, Parser)]
#[command(name = "twinedge", version, propagate_version = true, arg_required_else_help = true)]
#[command(after_help = "Examples:
  twinedge audit parcels.geojson
  twinedge audit bunny.obj
  twinedge clean counties.shp -o clean.shp
  twinedge convert counties.shp -o counties.geojson
  twinedge overlay soils.gpkg parcels.gpkg -o pieces.gpkg
  twinedge query neighbours Switzerland
  twinedge draw -o world.svg

Exit status: 0 all is well; 1 something is wrong with what was examined; 2 the input could not be read, or the command was \
misused; 130 interrupted (Ctrl-C).")]
struct Arguments {
    #[command(subcommand)]
    command: Command,

    /// Colour the text.
    #[arg(long, global = true, value_name = "WHEN", value_enum, default_value_t)]
    color: ColorChoice,

    /// Print no report: the exit status says it all. Answers, JSON and files are as ever.
    #[arg(short, long, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    Audit(Box<audit::Audit>),
    Clean(clean::Clean),
    Diff(diff::Diff),
    Certify(certificate::Certify),
    Check(certificate::Check),
    Tile(tile::Tile),
    Sum(tile::Sum),
    Convert(convert::Convert),
    Overlay(overlay::Overlay),
    Postgis(postgis::Postgis),
    Query(query::Query),
    Draw(draw::Draw),
    Decompose(decompose::Decompose),
    Voronoi(voronoi::MakeVoronoi),
    /// Print the completions for a shell.
    #[command(after_help = "Examples:
  source <(twinedge completions bash)

Exit status: 0 they are printed; 2 misuse.")]
    Completions {
        /// The shell.
        shell: Shell,
    },
}

fn main() -> ExitCode {
    let Arguments { command, color, quiet } = Arguments::parse();
    output::set_color(color);
    output::set_quiet(quiet);
    match run(command) {
        Ok(verdict) => verdict.status(),
        Err(failure) => failure.tell(),
    }
    .into()
}

fn run(command: Command) -> Result<Verdict, Failure> {
    match command {
        Command::Audit(audit) => audit.run(),
        Command::Clean(clean) => clean.run(),
        Command::Diff(diff) => diff.run(),
        Command::Certify(certify) => certify.run(),
        Command::Check(check) => check.run(),
        Command::Tile(tile) => tile.run(),
        Command::Sum(sum) => sum.run(),
        Command::Convert(convert) => convert.run(),
        Command::Overlay(overlay) => overlay.run(),
        Command::Postgis(postgis) => postgis.run(),
        Command::Query(query) => query.run(),
        Command::Draw(draw) => draw.run(),
        Command::Decompose(decompose) => decompose.run(),
        Command::Voronoi(voronoi) => voronoi.run(),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "twinedge", &mut script);
            output::print_bytes(&script)?;
            Ok(Verdict::Sound)
        }
    }
}
