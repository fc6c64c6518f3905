//! `twinedge query … coverage`.

use super::list::{Rows, csv, greatest_first};
use crate::output::{Failure, named};
use crate::progress::busy;
use clap::ValueEnum;
use serde::Serialize;
use twinedge_diagnosis::{Diagnosis, Measures};
use twinedge_report::diagnosis_text::write;
use twinedge_report::{Coverage, CoverageOptions, Imported, Measured, Units, row};

/// Overlaps, gaps, near misses, slivers, duplicates, features that are not valid by the OGC, and mismatches: what breaks C1 … C7, as a table.
///
/// The map does not have to be plane: borders that cross are cut on the finest grid.
#[derive(Debug, clap::Args)]
#[command(
    name = "coverage",
    after_help = "Examples:
  twinedge query parcels.geojson coverage
  twinedge query parcels.geojson coverage --rule C1 --sort area --limit 10
  twinedge query counties.geojson coverage --geodesic --gap-width 0.0001 --format csv

Exit status: 0 there is an answer, if only that there is nothing; 2 the input could not be read, or the coverage not judged."
)]
pub(super) struct CoverageOf {
    #[command(flatten)]
    asked: CoverageOptions,

    #[command(flatten)]
    measured: Measured,

    /// List findings of this rule only: C1 to C7. Can be given several times.
    #[arg(long, value_name = "RULE", value_parser = ["C1", "C2", "C3", "C4", "C5", "C6", "C7"])]
    rule: Vec<String>,

    /// The column to sort by. Within each rule, the largest area comes first anyway.
    #[arg(long, value_enum, default_value_t)]
    sort: SortBy,

    #[command(flatten)]
    rows: Rows,
}

/// The order of findings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum SortBy {
    /// The rule.
    #[default]
    Rule,
    /// The area, the largest first.
    Area,
    /// The width, the greatest first.
    Width,
    /// The length of the borders, the longest first.
    Length,
}

#[derive(Debug, Serialize)]
struct CoverageAnswer<'a> {
    input: &'a str,
    unit: &'static str,
    coverage: &'a Coverage,
}

const HEADINGS: [&str; 8] = ["rule", "kind", "features", "area", "width", "length", "x", "y"];

impl CoverageOf {
    pub(super) fn answer(&self, imported: &Imported) -> Result<(), Failure> {
        let units = Units::of(imported, self.measured.geodesic).map_err(named(&imported.name))?;
        let builder = imported.builder.clone();
        let mut coverage =
            busy(|stage| Coverage::new(imported, builder, &self.asked, &units, usize::MAX, stage)).unexplained();
        if let Some(why) = coverage.not_checked() {
            return Err(Failure(format!("{}: {why}", imported.name)));
        }
        let findings = coverage.findings_mut();
        findings.retain(|one| self.rule.is_empty() || self.rule.iter().any(|rule| Some(&**rule) == one.rule));
        let greatest = |measure: fn(Measures) -> Option<f64>| {
            move |one: &Diagnosis| measure(one.measures).unwrap_or(f64::NEG_INFINITY)
        };
        match self.sort {
            SortBy::Rule => {}
            SortBy::Area => greatest_first(findings, greatest(|size| size.area)),
            SortBy::Width => greatest_first(findings, greatest(|size| size.width)),
            SortBy::Length => greatest_first(findings, greatest(|size| size.length)),
        }
        self.rows.cut(findings);
        let text = || {
            let mut out = String::new();
            coverage.write_rules(&mut out, self.asked.coverage)?;
            out.push('\n');
            for one in coverage.findings() {
                write(&mut out, one, imported.noted.decimals())?;
            }
            Ok(out)
        };
        let answer = CoverageAnswer { input: &imported.name, unit: units.name(), coverage: &coverage };
        self.rows.print(&units, text, || csv(coverage.findings().iter().map(row), &HEADINGS), &answer)
    }
}
