//! `twinedge query … route`.

use super::which::{Source, find};
use crate::output::{Failure, Format, measure, print_answer, print_json};
use clap::ValueEnum;
use serde::Serialize;
use twinedge_algorithm::dual;
use twinedge_algorithm::dual::By;
use twinedge_report::names::label;

/// The features that one crosses on the way from one to another.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query route Portugal China
  twinedge query route Portugal China --by length
  twinedge query world.geojson route Norway Vietnam --format json

Exit status: 0 there is an answer, if only that there is no way; 2 the input could not be read, or has no feature of that name.")]
pub(super) struct Route {
    /// The place where the way starts.
    from: String,

    /// The place where it ends.
    to: String,

    /// The measure of a way.
    #[arg(long, value_enum, default_value_t)]
    by: Measure,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Measure {
    /// Few borders to cross.
    #[default]
    Borders,
    /// Short distances between the centroids of the features.
    Length,
}

/// The answer; null if there is no way.
#[derive(Debug, Serialize)]
struct RouteAnswer<'a> {
    input: &'a str,
    route: Option<Vec<String>>,
    length: Option<f64>,
}

impl Route {
    pub(super) fn answer(&self, asked: &Source) -> Result<(), Failure> {
        let Source { input, map, .. } = asked;
        let (from, to) = (find(asked, &self.from)?, find(asked, &self.to)?);
        let by = match self.by {
            Measure::Borders => By::Borders,
            Measure::Length => By::Length,
        };
        let found = dual::route(map, from, to, by);
        let length = found.as_ref().map(|route| route.length);
        let names = |route: dual::Route| route.features.into_iter().map(|feature| label(map, feature)).collect();
        let route: Option<Vec<String>> = found.map(names);
        match (self.format, route) {
            (Format::Json, route) => print_json(&RouteAnswer { input, route, length }),
            (Format::Text, None) => {
                print_answer(&format!("no way from {} to {} across borders\n", label(map, from), label(map, to)))
            }
            (Format::Text, Some(route)) => {
                let borders = route.len() - 1;
                let borders = crate::output::counted(borders, "border");
                let length = measure(length.unwrap_or_default());
                print_answer(&format!("{}\n\n{borders}, {length} from centroid to centroid\n", route.join("\n")))
            }
        }
    }
}
