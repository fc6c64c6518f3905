//! `twinedge clean`: a layer of polygons without overlaps, narrow gaps and slivers.

use crate::convert::{LayerOutput, Written};
use crate::coverage::AcceptedGaps;
use crate::input::LayerFile;
use crate::noding_text;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, counted, decimals, grouped, json, measure, place, plain, print, print_json};
use crate::status::{Failure, Verdict};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::time::Instant;
use twinedge::algorithm::clean::{ChangeKind, Options, Winner};
use twinedge::algorithm::coverage::CoverageRule;
use twinedge::geometry::noding::Snap;
use twinedge_formats::diagnosis::{Diagnosis, FeatureName, Kind, Measures};
use twinedge_formats::layer::clean::{CleanOptions, CleanReport, FeatureChange, LayerChange, Left, Remaining, clean};
use twinedge_formats::layer::{Feature, Layer, Value};

/// Repair a layer of polygons: cut borders where they meet, and resolve overlaps, small gaps and slivers.
///
/// Each place belongs to one feature afterwards. Overlaps go to one of the features that claim them. Gaps that are small, or at most
/// as wide as --gap-width, and slivers go to the neighbour with the longest common border. Spikes and repeated points are dropped,
/// and polygons are valid by the OGC. The width of a gap is its mean width: twice the area by the length of the border. A wider gap is
/// left whole, and the report says so.
///
/// Of several features that cover the same place one keeps it; the others keep their attributes and have no geometry any more, of
/// which a warning is given.
///
/// Ids, attributes, the order of features and foreign members are kept, and so is the geometry of features in which nothing
/// changed. Vertices keep their further dimensions; for new ones these are interpolated. Lines and points are left as they are.
///
/// No point moves, unless borders cross where there is none, or --snap asks for a grid. Cleaning the output again changes nothing.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge clean counties.shp --dry-run                         only say what would be done
  twinedge clean counties.shp -o clean.shp
  twinedge clean parcels.geojson -o parcels.gpkg --snap 0.001 --gap-width 0.05
  twinedge clean zones.gpkg -o zones.gpkg.new --to geopackage --overlap first --sliver 25

Exit status: 0 the output is a coverage, `twinedge audit --coverage` finds nothing; 1 something is left, and the report says \
what; 2 the input could not be read, or the output not written.")]
pub(crate) struct Clean {
    #[command(flatten)]
    input: LayerFile,

    #[command(flatten)]
    output: LayerOutput,

    /// In the report, call features by this column. Default: name, NAME, Name, ADMIN, admin, title or id, the first that there is.
    #[arg(long, value_name = "COLUMN")]
    name_from: Option<String>,

    /// Only report what would be done.
    #[arg(long, conflicts_with = "output")]
    dry_run: bool,

    /// Round all points to a grid first: points within the same cell become one. SIZE is the greatest width of the cells: the width
    /// is the largest power of two up to it.
    #[arg(long, value_name = "auto|SIZE", value_parser = crate::input::snap, allow_negative_numbers = true)]
    snap: Option<Snap>,

    /// The feature that gets what several claim.
    #[arg(long, value_name = "WHICH", value_enum, default_value_t)]
    overlap: Claim,

    /// Greatest mean width of a gap that is filled, in the units of the coordinates, and greatest distance between two borders that
    /// face each other where the space between them is open to the outside or to a wider gap: it is filled as well. Default: only gaps smaller than --sliver are.
    #[arg(long, value_name = "W", value_parser = crate::coverage::positive)]
    gap_width: Option<f64>,

    #[command(flatten)]
    accepted: AcceptedGaps,

    /// Area below which gaps are filled and thin parts of features given away. A part is thin if 4π · area / perimeter² is below 0.2: a
    /// rectangle 14 times as long as wide. Default: a thousandth of the median area of all parts, measured after overlaps are resolved.
    #[arg(long, value_name = "A", value_parser = crate::coverage::positive)]
    sliver: Option<f64>,

    /// Output format of the report.
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Greatest number of changes to list in the text; all are counted.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = crate::input::whole, allow_negative_numbers = true)]
    list: usize,
}

/// The feature that gets what several claim.
#[derive(Clone, Copy, Debug, Default, clap::ValueEnum)]
enum Claim {
    /// One that lies inside another, but for a tenth of its area; if there is none, the one with the largest area.
    #[default]
    Inner,
    /// The one with the largest area, the first of those.
    Larger,
    /// The one with the smallest area, the first of those.
    Smaller,
    /// The first in the file.
    First,
    /// The last in the file.
    Last,
}

impl From<Claim> for Winner {
    fn from(claim: Claim) -> Self {
        match claim {
            Claim::Inner => Self::Inner,
            Claim::Larger => Self::Larger,
            Claim::Smaller => Self::Smaller,
            Claim::First => Self::First,
            Claim::Last => Self::Last,
        }
    }
}

impl Clean {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        if !self.dry_run && !self.output.is_given() {
            return Err(Failure("neither a file to write (-o FILE) nor --dry-run was given".to_owned()));
        }
        let (name, mut layer) = self.input.read()?;
        let names = Names { from: self.name_from.as_deref() };
        names.refuse_unknown(&name, &layer)?;
        self.output.refuse(&layer)?;
        let assign = Options {
            winner: self.overlap.into(),
            gap_width: self.gap_width,
            lake_width: self.accepted.lake_width,
            accepted_gaps: self.accepted.accept_gap.clone(),
            sliver_area: self.sliver,
            ..Options::default()
        };
        let report = clean(&mut layer, &CleanOptions { snap: self.snap, assign })
            .map_err(|error| Failure(format!("{name}: {error}")))?;
        let written = self.output.write(&layer, self.input.path())?;
        let elapsed = start.elapsed().as_secs_f64() * 1000.0;
        let mut changes: BTreeMap<usize, Vec<&LayerChange>> = BTreeMap::new();
        for change in &report.changes {
            let won = change.to.filter(|to| !change.from.contains(to));
            for feature in change.from.iter().copied().chain(won) {
                changes.entry(feature).or_default().push(change);
            }
        }
        let cleaned = Cleaning {
            name: &name,
            names,
            layer: &layer,
            report: &report,
            written: written.as_ref(),
            greatest_gap: self.accepted.lake_width.or(self.gap_width),
            changes,
            elapsed,
        };
        match self.format {
            // Standard output has the layer.
            Format::Text if self.output.is_stdout() => anstream::eprint!("{}", cleaned.text(self.list)?),
            Format::Json if self.output.is_stdout() => eprint!("{}", String::from_utf8_lossy(&json(&cleaned.json())?)),
            Format::Text => print(&cleaned.text(self.list)?)?,
            Format::Json => print_json(&cleaned.json())?,
        }
        Ok(if report.left.is_none() { Verdict::Sound } else { Verdict::Wrong })
    }
}

/// The number of columns that an error lists.
const COLUMNS: usize = 20;

/// A layer, cleaned.
struct Cleaning<'a> {
    name: &'a str,
    names: Names<'a>,
    layer: &'a Layer,
    report: &'a CleanReport,
    written: Option<&'a Written>,
    /// The width from which on gaps are accepted.
    greatest_gap: Option<f64>,
    /// The changes that each feature has a part in.
    changes: BTreeMap<usize, Vec<&'a LayerChange>>,
    elapsed: f64,
}

/// The source of the names of features.
#[derive(Clone, Copy)]
struct Names<'a> {
    /// The column that was asked for.
    from: Option<&'a str>,
}

impl Names<'_> {
    fn of(self, feature: &Feature) -> Option<String> {
        match self.from {
            Some(column) => feature.get(column).and_then(Value::text),
            None => feature.name(),
        }
    }

    /// Refuses a column that no feature has.
    fn refuse_unknown(self, name: &str, layer: &Layer) -> Result<(), Failure> {
        let Some(column) = self.from else { return Ok(()) };
        if layer.features.iter().any(|feature| self.of(feature).is_some()) {
            return Ok(());
        }
        let columns: BTreeSet<String> =
            layer.features.iter().flat_map(|feature| &feature.attributes).map(|(name, _)| plain(name)).collect();
        let known = match columns.into_iter().take(COLUMNS).collect::<Vec<_>>() {
            columns if columns.is_empty() => "there are no columns".to_owned(),
            columns => format!("there are {}", columns.join(", ")),
        };
        Err(Failure(format!("{name}: no feature has a value in the column {column}; {known}")))
    }
}

/// The name for a feature.
fn label(names: Names<'_>, layer: &Layer, number: usize) -> String {
    let feature = layer.features.get(number);
    let name = feature.and_then(|feature| names.of(feature));
    let id = feature.and_then(|feature| feature.id.as_ref()).map(ToString::to_string);
    plain(&match (name, id) {
        (Some(name), Some(id)) if name != id => format!("{name} ({id})"),
        (Some(name), _) => name,
        (None, Some(id)) => id,
        (None, None) => format!("feature {number}"),
    })
}

impl Cleaning<'_> {
    fn label(&self, number: usize) -> String {
        label(self.names, self.layer, number)
    }

    fn labels(&self, numbers: &[usize]) -> String {
        numbers.iter().map(|number| self.label(*number)).collect::<Vec<_>>().join(", ")
    }

    fn text(&self, list: usize) -> Result<String, std::fmt::Error> {
        let Self { name, report, layer, .. } = self;
        let mut out = String::new();
        writeln!(out, "{}", plain(name))?;
        let all = counted(layer.features.len(), "feature");
        writeln!(out, "{QUIET}{all}, {} with polygons{QUIET:#}", grouped(report.polygons))?;
        if let Some(noding) = report.noding.as_ref().filter(|noding| noding.cell > 0.0) {
            writeln!(out, "{QUIET}{}{QUIET:#}", noding_text::line(noding))?;
        }
        let decimals = decimals_of(self.layer);
        let limit = format!("  {QUIET}below an area of {}{QUIET:#}", measure(report.sliver_area));
        out.push('\n');
        for (kind, what, beside) in [
            (ChangeKind::Overlap, "overlaps resolved", String::new()),
            (ChangeKind::Gap, "gaps filled", String::new()),
            (ChangeKind::Sliver, "slivers given to neighbours or dropped", limit),
        ] {
            let found = report.changes.iter().filter(|change| change.kind == kind);
            let area: f64 = found.clone().map(|change| change.area).sum();
            let area = if area > 0.0 { format!("  area {}", measure(area)) } else { String::new() };
            writeln!(out, "  {what:38} {:>9}{area}{beside}", grouped(found.count()))?;
        }
        let gone = report.features.iter().filter(|feature| feature.area_after == 0.0).count();
        for (what, count) in
            [("features with another geometry", report.features.len()), ("of these, without area now", gone)]
        {
            writeln!(out, "  {what:38} {:>9}", grouped(count))?;
        }
        out.push('\n');
        for change in report.changes.iter().take(list) {
            self.write_change(&mut out, change, decimals)?;
        }
        let more = report.changes.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        for feature in report.features.iter().take(list) {
            let FeatureChange { feature: number, area_before, area_after, points_before, points_after, .. } = feature;
            writeln!(
                out,
                "{}: area {} → {}, points {} → {}; {}",
                self.label(*number),
                measure(*area_before),
                measure(*area_after),
                grouped(*points_before),
                grouped(*points_after),
                self.reasons(feature).join("; "),
            )?;
        }
        let more = report.features.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more features; see --list", grouped(more))?;
        }
        for warning in self.warnings() {
            writeln!(out, "{BAD}warning{BAD:#}: {warning}")?;
        }
        for one in report.remaining.iter().take(list) {
            writeln!(out, "left: {}", self.remaining(one, decimals))?;
        }
        let more = report.remaining.len().saturating_sub(list);
        if more > 0 {
            writeln!(out, "… and {} more are left; see --list", grouped(more))?;
        }
        for one in report.wider_gaps.iter().take(list) {
            writeln!(out, "left as it is: {}", self.remaining(one, decimals))?;
        }
        for one in report.accepted_gaps.iter().take(list) {
            writeln!(out, "accepted: {}", self.described(one, decimals))?;
        }
        if let Some(Written { name, format }) = self.written {
            writeln!(out, "written to {} ({format})", plain(name))?;
        }
        match &report.left {
            None => writeln!(out, "{GOOD}clean{GOOD:#}: C1 to C6 hold{} ({:.0} ms)", self.wider(), self.elapsed),
            Some(left) => writeln!(out, "{BAD}not clean{BAD:#}: {} ({:.0} ms)", left_text(left), self.elapsed),
        }?;
        Ok(out)
    }

    /// Why a feature has another geometry.
    fn reasons(&self, feature: &FeatureChange) -> Vec<String> {
        let number = feature.feature;
        let mut reasons = Vec::new();
        for change in self.changes.get(&number).into_iter().flatten() {
            let has_lost = change.from.contains(&number);
            let has_won = change.to == Some(number);
            let others: Vec<usize> = change.from.iter().copied().filter(|other| *other != number).collect();
            let to = change.to.map_or_else(|| "nobody".to_owned(), |to| self.label(to));
            reasons.extend(match (change.kind, has_lost, has_won) {
                (ChangeKind::Overlap, true, true) => Some(format!("overlap with {} kept", self.labels(&others))),
                (ChangeKind::Overlap, true, false) => {
                    Some(format!("overlap with {} given to {to}", self.labels(&others)))
                }
                (ChangeKind::Gap, _, true) => Some("gap filled".to_owned()),
                (ChangeKind::Sliver, true, _) => Some(format!("sliver given to {to}")),
                (ChangeKind::Sliver, false, true) => Some(format!("sliver of {} taken", self.labels(&others))),
                _ => None,
            });
        }
        if !feature.defects.is_empty() {
            let kinds: Vec<String> = feature.defects.iter().map(ToString::to_string).collect();
            reasons.push(format!("it was not valid ({})", kinds.join(", ")));
        }
        reasons.dedup();
        if reasons.is_empty() {
            reasons.push("points where borders meet, spikes or repeated points".to_owned());
        }
        reasons
    }

    /// The features that have no geometry any more, each in a sentence.
    fn warnings(&self) -> Vec<String> {
        let gone = self.report.features.iter().filter(|feature| feature.points_after == 0);
        let warning = |feature: &FeatureChange| {
            let number = feature.feature;
            let changes = self.changes.get(&number).into_iter().flatten();
            let to = changes.filter(|change| change.from.contains(&number)).filter_map(|one| one.to);
            let to: BTreeSet<usize> = to.filter(|to| *to != number).collect();
            let to = match to.len() {
                0 => "its rings enclose nothing".to_owned(),
                _ => format!("its place went to {}", self.labels(&to.into_iter().collect::<Vec<_>>())),
            };
            format!("{} has no geometry any more: {to}; its attributes are kept", self.label(number))
        };
        gone.map(warning).collect()
    }

    /// Something that was left, and what would take it.
    fn remaining(&self, one: &Remaining, decimals: usize) -> String {
        let hint = match one.rule {
            CoverageRule::Gap => format!("; --gap-width {} would fill it", rounded_up(one.width)),
            CoverageRule::NearMiss => "; --gap-width would fill it, from its greatest width on".to_owned(),
            _ => String::new(),
        };
        format!("{}{hint}", self.described(one, decimals))
    }

    /// Something that was left.
    fn described(&self, one: &Remaining, decimals: usize) -> String {
        let Remaining { rule, features, area, width, at, .. } = one;
        let what = match features.len() {
            0 => rule.name().to_owned(),
            _ => format!("{} of {}", rule.name(), self.labels(features)),
        };
        let at = place([at.x, at.y], decimals);
        match rule {
            CoverageRule::Validity => format!("{what}, at {at}"),
            _ => format!("{what}, area {}, width {}, at {at}", measure(*area), measure(*width)),
        }
    }

    /// The number of gaps that were left because they are wider than asked for.
    fn wider(&self) -> String {
        match (self.report.wider_gaps.len(), self.greatest_gap) {
            (0, _) | (_, None) => String::new(),
            (1, Some(width)) => format!("; 1 gap wider than {width} is left"),
            (n, Some(width)) => format!("; {} gaps wider than {width} are left", grouped(n)),
        }
    }

    fn write_change(&self, out: &mut String, change: &LayerChange, decimals: usize) -> std::fmt::Result {
        let to = change.to.map_or_else(|| "nobody".to_owned(), |to| self.label(to));
        let from = match &change.from[..] {
            [] => String::new(),
            from => format!(" of {}", self.labels(from)),
        };
        let (area, width) = (measure(change.area), measure(change.width));
        let at = place([change.at.x, change.at.y], decimals);
        writeln!(out, "{}{from} to {to}: area {area}, width {width}, at {at}", change.kind)
    }

    fn json(&self) -> serde_json::Value {
        let Self { name, names, report, layer, written, elapsed, .. } = self;
        let named = |number: &usize| {
            let feature = layer.features.get(*number);
            FeatureName {
                number: *number,
                id: feature.and_then(|feature| feature.id.as_ref()).map(ToString::to_string),
                name: feature.and_then(|feature| names.of(feature)),
                label: self.label(*number),
            }
        };
        let remaining = |one: &Remaining| {
            let measures = Measures { area: Some(one.area), width: Some(one.width), length: None };
            Diagnosis {
                rule: Some(one.rule.id()),
                kind: Kind::Named { kind: one.rule.name() },
                message: self.remaining(one, decimals_of(layer)),
                features: Some(one.features.iter().map(named).collect()),
                measures,
                look: Some(one.at.into()),
                ..Diagnosis::default()
            }
        };
        let all = |remaining_ones: &[Remaining]| remaining_ones.iter().map(remaining).collect::<Vec<_>>();
        let change = |change: &LayerChange| {
            json!({
                "kind": change.kind.name(),
                "from": change.from.iter().map(named).collect::<Vec<_>>(),
                "to": change.to.as_ref().map(named),
                "area": change.area,
                "width": change.width,
                "at": [change.at.x, change.at.y],
            })
        };
        let changed = |feature: &FeatureChange| {
            let FeatureName { number, id, name, .. } = named(&feature.feature);
            without_null(json!({
                "number": number,
                "id": id,
                "name": name,
                "area_before": feature.area_before,
                "area_after": feature.area_after,
                "points_before": feature.points_before,
                "points_after": feature.points_after,
                "reasons": self.reasons(feature),
            }))
        };
        let left = report.left.map(|left| {
            json!({
                "plane": left.is_plane,
                "overlaps": left.overlaps,
                "gaps": left.gaps,
                "near_misses": left.near_misses,
                "slivers": left.slivers,
                "ogc_invalid": left.invalid,
                "findings": all(&report.remaining),
            })
        });
        without_null(json!({
            "input": name,
            "output": written.map(|written| &*written.name),
            "clean": report.left.is_none(),
            "features": layer.features.len(),
            "with_polygons": report.polygons,
            "cell": report.noding.map(|noding| noding.cell).filter(|cell| *cell > 0.0),
            "sliver_area": report.sliver_area,
            "changes": report.changes.iter().map(change).collect::<Vec<_>>(),
            "changed": report.features.iter().map(changed).collect::<Vec<_>>(),
            "left": left,
            // Gaps that are wider than `--lake-width`, or `--gap-width`.
            "wider_gaps": all(&report.wider_gaps),
            "accepted_gaps": all(&report.accepted_gaps),
            "warnings": self.warnings(),
            "elapsed_ms": elapsed,
        }))
    }
}

/// An object without the members that are null.
fn without_null(mut object: serde_json::Value) -> serde_json::Value {
    object.as_object_mut().into_iter().for_each(|members| members.retain(|_, value| !value.is_null()));
    object
}

/// With how many decimal places a place is shown.
fn decimals_of(layer: &Layer) -> usize {
    let mut greatest: f64 = 0.0;
    for geometry in layer.features.iter().filter_map(|feature| feature.geometry.as_ref()) {
        geometry.shape.visit(&mut |position| greatest = greatest.max(position.x.abs()).max(position.y.abs()));
    }
    decimals(greatest)
}

/// A number that is at least as large, with three digits.
fn rounded_up(x: f64) -> f64 {
    let unit = 10_f64.powf(x.abs().max(f64::MIN_POSITIVE).log10().floor() - 2.0);
    let text = format!("{:.2e}", (x / unit).ceil() * unit);
    text.parse().ok().filter(|y| *y >= x).unwrap_or(x)
}

/// The remains, and what removes them.
fn left_text(left: &Left) -> String {
    if !left.is_plane {
        return "borders still cross; --snap SIZE rounds them to a coarser grid".to_owned();
    }
    let all = [
        (left.overlaps, "overlap", ""),
        (left.gaps, "gap", " (--gap-width W fills those up to a width)"),
        (left.near_misses, "near miss", " (--gap-width W closes those up to a width)"),
        (left.slivers, "sliver", " that is all there is of its feature"),
        (left.invalid, "invalid feature", ""),
    ];
    let parts = all.iter().filter(|(count, ..)| *count > 0).map(|(count, what, hint)| match (*count, *what) {
        (n, "near miss") if n > 1 => format!("{} near misses{hint}", grouped(n)),
        (n, what) => format!("{}{hint}", counted(n, what)),
    });
    format!("left are {}", parts.collect::<Vec<_>>().join(", "))
}
