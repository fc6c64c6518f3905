//! The options for judging a coverage, and for measures along the earth.

use crate::output::{Failure, named};
use twinedge_coverage::Limits;
use twinedge_geometry::Point;
use twinedge_report::{CoverageOptions, Imported, Units};

/// The options by which a coverage is judged.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Coverage (maps)")]
pub(crate) struct CoverageArguments {
    /// Count what breaks C1 … C7 as violations: overlaps, gaps, near misses, slivers, duplicates, polygons that are not valid by
    /// the OGC, mismatches. Otherwise they are counted and shown, and the map is valid with them; in GeoJSON their `violation` is then false.
    #[arg(long)]
    coverage: bool,

    #[command(flatten)]
    limits: LimitArguments,
}

/// The limits by which a coverage is judged.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Coverage (maps)")]
pub(crate) struct LimitArguments {
    /// Greatest width of a near miss, and of a gap that is reported, in the units of the coordinates, with --geodesic too. The width is the mean one: twice
    /// the area by the length of the border. Wider gaps are counted. Default: gaps of any width, and near misses up to a hundredth of
    /// the median length of the edges.
    #[arg(long, value_name = "W", value_parser = positive)]
    gap_width: Option<f64>,

    #[command(flatten)]
    accepted: AcceptedGaps,

    /// Area below which a thin part of a feature is a sliver. A part is thin if 4π · area / perimeter² is below 0.2: a rectangle 14 times
    /// as long as wide. Default: a thousandth of the median area of all parts of features; `clean` measures them after overlaps are
    /// resolved, so its limit is a little different.
    #[arg(long, value_name = "A", value_parser = positive)]
    sliver: Option<f64>,
}

/// The gaps that are meant.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct AcceptedGaps {
    /// Greatest mean width of a gap that is reported, where it is not --gap-width: wider ones are accepted, as lakes.
    #[arg(long, value_name = "W", value_parser = positive)]
    pub(crate) lake_width: Option<f64>,

    /// Accept the gap around this point, whatever its width. Can be given several times.
    #[arg(long, value_name = "X,Y", value_parser = place, allow_hyphen_values = true)]
    pub(crate) accept_gap: Vec<Point>,
}

/// Parses a point on the command line.
fn place(text: &str) -> Result<Point, String> {
    let number = |text: &str| text.trim().parse().ok().filter(|x| f64::is_finite(*x));
    // Accept the form printed in reports as well.
    let text = text.trim().trim_start_matches('(').trim_end_matches(')');
    let point = text.split_once(',').and_then(|(x, y)| Some(Point::new(number(x)?, number(y)?)));
    point.ok_or_else(|| "not a point: two numbers with a comma between".to_owned())
}

/// Parses a positive number on the command line.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| *x > 0.0 && f64::is_finite(*x)).ok_or_else(|| "not a positive number".to_owned())
}

impl CoverageArguments {
    pub(crate) const fn is_any(&self) -> bool {
        self.coverage || self.limits.is_any()
    }

    /// The limits, and whether findings make a map invalid.
    pub(crate) fn options(&self) -> CoverageOptions {
        CoverageOptions { is_rule: self.coverage, limits: self.limits.limits() }
    }
}

impl LimitArguments {
    const fn is_any(&self) -> bool {
        let AcceptedGaps { lake_width, accept_gap } = &self.accepted;
        self.gap_width.is_some() || lake_width.is_some() || self.sliver.is_some() || !accept_gap.is_empty()
    }

    pub(crate) fn limits(&self) -> Limits {
        Limits {
            gap_width: self.gap_width,
            lake_width: self.accepted.lake_width,
            accepted_gaps: self.accepted.accept_gap.clone(),
            sliver_area: self.sliver,
            ..Limits::default()
        }
    }
}

/// The measure of lengths and areas.
#[derive(Debug, clap::Args)]
pub(crate) struct Measured {
    /// Lengths in metres along geodesics and areas in square metres, on the ellipsoid WGS 84; of areas, the borders are straight in the coordinates. Only
    /// for longitudes and latitudes in degrees.
    #[arg(long)]
    geodesic: bool,
}

impl Measured {
    /// Returns true if lengths and areas are measured along the earth.
    pub(crate) const fn is_geodesic(&self) -> bool {
        self.geodesic
    }

    pub(crate) fn units(&self, imported: &Imported) -> Result<Units, Failure> {
        Units::of(imported, self.geodesic).map_err(named(&imported.name))
    }
}
