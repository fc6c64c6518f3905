//! The rules of a coverage, C1 … C6, in the report of `audit` and as the answer of `query coverage`.

use crate::coverage_words::explanation;
use crate::diagnosis_text::{size, write, write_explanations};
use crate::input::Imported;
use crate::names::named;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{counted, grouped, measure, plain};
use crate::progress::busy;
use crate::status::Failure;
use crate::trace::{of_finding, position};
use crate::units::Units;
use serde::Serialize;
use std::fmt::Write as _;
use twinedge::algorithm::coverage::{Coverage as Found, CoverageRule, Defect, Finding, Limits, check};
use twinedge::geometry::Point;
use twinedge::geometry::noding::Snap;
use twinedge::map::{Noding, PlanarMap};
use twinedge_formats::diagnosis::{Diagnosis, Flaw, Kind, Measures, Trace};

/// The number of findings of each rule that the text shows unless asked.
pub(crate) const SHOWN: usize = 3;

/// The options by which a coverage is judged.
#[derive(Debug, Default, clap::Args)]
#[command(next_help_heading = "Coverage (maps)")]
pub(crate) struct CoverageOptions {
    /// Count what breaks C1 … C6 as violations: overlaps, gaps, near misses, slivers, duplicates, polygons that are not valid by
    /// the OGC. Otherwise they are counted and shown, and the map is valid with them; in GeoJSON their `violation` is then false.
    #[arg(long)]
    coverage: bool,

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
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct AcceptedGaps {
    /// Greatest mean width of a gap that is reported, where it is not --gap-width: wider ones are accepted, as lakes.
    #[arg(long, value_name = "W", value_parser = positive)]
    pub(crate) lake_width: Option<f64>,

    /// Accept the gap around this point, whatever its width. Can be given several times.
    #[arg(long, value_name = "X,Y", value_parser = place, allow_hyphen_values = true)]
    pub(crate) accept_gap: Vec<Point>,
}

/// A point on the command line.
fn place(text: &str) -> Result<Point, String> {
    let number = |text: &str| text.trim().parse().ok().filter(|x| f64::is_finite(*x));
    let point = text.split_once(',').and_then(|(x, y)| Some(Point::new(number(x)?, number(y)?)));
    point.ok_or_else(|| "not a point: two numbers with a comma between".to_owned())
}

/// A positive number on the command line.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| *x > 0.0 && f64::is_finite(*x)).ok_or_else(|| "not a positive number".to_owned())
}

impl CoverageOptions {
    pub(crate) const fn is_any(&self) -> bool {
        let AcceptedGaps { lake_width, accept_gap } = &self.accepted;
        let is_limited = self.gap_width.is_some() || lake_width.is_some() || self.sliver.is_some();
        self.coverage || is_limited || !accept_gap.is_empty()
    }

    /// The limits that were given.
    pub(crate) fn limits(&self) -> Limits {
        Limits {
            gap_width: self.gap_width,
            lake_width: self.accepted.lake_width,
            accepted_gaps: self.accepted.accept_gap.clone(),
            sliver_area: self.sliver,
            ..Limits::default()
        }
    }

    /// Returns true if findings make a map invalid.
    pub(crate) const fn is_rule(&self) -> bool {
        self.coverage
    }
}

/// The findings as JSON.
#[derive(Debug, Serialize)]
pub(crate) struct Coverage {
    overlaps: usize,
    gaps: usize,
    near_misses: usize,
    slivers: usize,
    duplicates: usize,
    /// Features, not defects.
    ogc_invalid: usize,
    /// Of lengths; areas are in its square.
    unit: &'static str,
    /// Why C1 … C5 were not checked.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_checked: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    gap_width: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sliver_area: Option<f64>,
    /// Gaps that are wider than `lake_width`, or `gap_width`, where one of these was asked for. They are not among the findings.
    wider_gaps: usize,
    /// The width from which on gaps are wider.
    #[serde(skip)]
    greatest_gap: Option<f64>,
    /// Gaps that were accepted by their place. They are not among the findings either.
    accepted_gaps: usize,
    /// The first of each rule, the largest first.
    findings: Vec<Diagnosis>,
    #[serde(skip)]
    has_polygons: bool,
    /// The map of the input with its borders cut, where the findings are of that one.
    #[serde(skip)]
    of_input: Option<PlanarMap>,
}

/// Rule, kind, features, area, width, length, and the coordinates of the place.
type Row<'a> = (&'a str, &'a str, String, Option<f64>, Option<f64>, Option<f64>, Option<f64>, Option<f64>);

/// The number of defects of each kind that are listed of a feature.
const DEFECTS: usize = 20;

impl Coverage {
    /// Asks all rules. Overlaps and gaps are those of the input: where borders cross they are cut on the finest grid, and where a
    /// grid was asked for, what it removed or made is found by comparing.
    pub(crate) fn new(imported: &Imported, asked: &CoverageOptions, units: &Units, list: usize) -> Self {
        Self::of(imported, asked, units, list, judged(imported, &asked.limits(), units))
    }

    /// The findings of a map that was seen by its tiles, or why there are none.
    pub(crate) fn of_tiles(
        imported: &Imported,
        asked: &CoverageOptions,
        units: &Units,
        list: usize,
        found: Result<Found, Failure>,
    ) -> Self {
        let judgement = |found: Found| Judgement {
            wider_gaps: found.wider_gaps.len(),
            accepted_gaps: found.accepted_gaps.len(),
            gap_width: found.gap_width,
            sliver_area: found.sliver_area,
            findings: found.findings.into_iter().map(|finding| (finding, None)).collect(),
            of_input: None,
        };
        Self::of(imported, asked, units, list, found.map(judgement))
    }

    fn of(
        imported: &Imported,
        asked: &CoverageOptions,
        units: &Units,
        list: usize,
        judgement: Result<Judgement, Failure>,
    ) -> Self {
        let mut found = Self {
            overlaps: 0,
            gaps: 0,
            near_misses: 0,
            slivers: 0,
            duplicates: 0,
            ogc_invalid: imported.noted.defects.len(),
            unit: units.name(),
            not_checked: None,
            gap_width: None,
            sliver_area: None,
            wider_gaps: 0,
            greatest_gap: asked.accepted.lake_width.or(asked.gap_width),
            accepted_gaps: 0,
            findings: Vec::new(),
            has_polygons: imported.read.polygons > 0,
            of_input: None,
        };
        match judgement {
            Ok(Judgement { findings, gap_width, sliver_area, wider_gaps, accepted_gaps, of_input }) => {
                (found.wider_gaps, found.accepted_gaps) = (wider_gaps, accepted_gaps);
                (found.gap_width, found.sliver_area) = (Some(gap_width), Some(sliver_area));
                for (finding, snapping) in &findings {
                    let count = found.count_of(finding.rule);
                    *count += 1;
                    if *count <= list {
                        let map = of_input.as_ref().filter(|_| *snapping != Some("made")).unwrap_or(&imported.map);
                        let trace = of_finding(map, finding);
                        let features = finding.features.iter().map(|feature| named(imported, *feature)).collect();
                        let of_rule = of_rule(finding.rule, asked, finding.at);
                        let (area, width, length) = (finding.area, finding.width, finding.length);
                        let measures = Measures { area: Some(area), width: Some(width), length: Some(length) };
                        found.findings.push(Diagnosis {
                            message: size(measures).unwrap_or_default(),
                            features: Some(features),
                            trace,
                            measures,
                            snapping: *snapping,
                            ..of_rule
                        });
                    }
                }
                found.of_input = of_input;
            }
            Err(Failure(why)) => found.not_checked = Some(why),
        }
        for (feature, defects) in imported.noted.defects.iter().take(list) {
            found.findings.push(invalid(imported, asked, *feature, defects));
        }
        found
    }

    /// Drops causes and remedies.
    pub(crate) fn unexplained(self) -> Self {
        Self { findings: self.findings.into_iter().map(Diagnosis::unexplained).collect(), ..self }
    }

    fn count_of(&mut self, rule: CoverageRule) -> &mut usize {
        match rule {
            CoverageRule::Overlap => &mut self.overlaps,
            CoverageRule::Gap => &mut self.gaps,
            CoverageRule::NearMiss => &mut self.near_misses,
            CoverageRule::Sliver => &mut self.slivers,
            CoverageRule::Duplicate => &mut self.duplicates,
            _ => &mut self.ogc_invalid,
        }
    }

    /// The number of findings of each rule, in order.
    pub(crate) fn counts(&self) -> [(CoverageRule, usize, &'static str); 6] {
        [
            (CoverageRule::Overlap, self.overlaps, "overlap"),
            (CoverageRule::Gap, self.gaps, "gap"),
            (CoverageRule::NearMiss, self.near_misses, "near miss"),
            (CoverageRule::Sliver, self.slivers, "sliver"),
            (CoverageRule::Duplicate, self.duplicates, "set of duplicates"),
            (CoverageRule::Validity, self.ogc_invalid, "invalid feature"),
        ]
    }

    /// The number of findings.
    pub(crate) fn total(&self) -> usize {
        self.counts().iter().map(|(_, count, _)| count).sum()
    }

    /// The number of findings beside violations, in words.
    pub(crate) fn beside(&self) -> String {
        match self.total() {
            0 => String::new(),
            n => format!("; C1 to C6 have {}, which --coverage counts as violations", counted(n, "finding")),
        }
    }

    /// Returns true if there is anything that could be a coverage.
    pub(crate) const fn has_polygons(&self) -> bool {
        self.has_polygons
    }

    /// Why C1 … C5 could not be checked, if so.
    pub(crate) fn not_checked(&self) -> Option<&str> {
        self.not_checked.as_deref()
    }

    /// The listed findings.
    pub(crate) fn findings(&self) -> &[Diagnosis] {
        &self.findings
    }

    /// The unit of lengths.
    pub(crate) const fn unit(&self) -> &'static str {
        self.unit
    }

    /// The map of the input with its borders cut, where the findings are of that one.
    pub(crate) const fn of_input(&self) -> Option<&PlanarMap> {
        self.of_input.as_ref()
    }

    /// The listed findings, to be sorted and cut.
    pub(crate) const fn findings_mut(&mut self) -> &mut Vec<Diagnosis> {
        &mut self.findings
    }

    /// A line for each rule.
    pub(crate) fn write_rules(&self, out: &mut String, is_rule: bool) -> std::fmt::Result {
        for (rule, count, _) in self.counts() {
            write!(out, "  {:2}  {:12} ", rule.id(), rule.name())?;
            let limit = self.limit(rule).map_or_else(String::new, |limit| format!("  {QUIET}{limit}{QUIET:#}"));
            match (count, &self.not_checked) {
                (_, Some(why)) if rule != CoverageRule::Validity => {
                    writeln!(out, "{QUIET}not checked: {}{QUIET:#}", plain(why))?;
                }
                (0, _) => writeln!(out, "{GOOD}ok{GOOD:#}{limit}")?,
                _ => {
                    let broken = if is_rule { format!("{BAD}BROKEN{BAD:#}  ") } else { String::new() };
                    writeln!(out, "{broken}{}{limit}", self.found(rule))?;
                }
            }
        }
        Ok(())
    }

    /// The number of findings of a rule, with what they are called.
    fn found(&self, rule: CoverageRule) -> String {
        let of_rule = self.counts().into_iter().find(|(other, ..)| *other == rule);
        let (_, count, what) = of_rule.unwrap_or((rule, 0, "finding"));
        match (count, what) {
            (1, _) => format!("1 {what}"),
            (n, "near miss") => format!("{} near misses", grouped(n)),
            (n, "set of duplicates") => format!("{} sets of duplicates", grouped(n)),
            (n, what) => counted(n, what),
        }
    }

    /// The outcome of a rule, in words.
    pub(crate) fn outcome(&self, rule: CoverageRule) -> String {
        match &self.not_checked {
            Some(why) if rule != CoverageRule::Validity => format!("not checked: {why}"),
            _ => {
                let mark = if rule == CoverageRule::Gap { "; " } else { " " };
                [self.found(rule)].into_iter().chain(self.limit(rule)).collect::<Vec<_>>().join(mark)
            }
        }
    }

    /// The limit of a rule, for its line.
    fn limit(&self, rule: CoverageRule) -> Option<String> {
        // Limits are in the units of the coordinates.
        let degrees = if self.unit == Units::METRES { " degrees" } else { "" };
        match (rule, self.gap_width, self.sliver_area) {
            (CoverageRule::Gap, ..) => self.gaps_not_listed(degrees),
            (CoverageRule::NearMiss, Some(width), _) => Some(format!("up to a width of {}{degrees}", measure(width))),
            (CoverageRule::Sliver, _, Some(area)) => {
                let square = if degrees.is_empty() { "" } else { " square" };
                Some(format!("below an area of {}{square}{degrees}", measure(area)))
            }
            _ => None,
        }
    }

    /// The number of gaps that are no findings, if there are any.
    fn gaps_not_listed(&self, degrees: &str) -> Option<String> {
        let all = [
            (self.wider_gaps, self.greatest_gap.map(|width| format!("wider than {}{degrees} ", measure(width)))),
            (self.accepted_gaps, Some("accepted by place ".to_owned())),
        ];
        let sentence = |(count, which): (usize, Option<String>)| {
            let [are, gaps] = if count == 1 { ["is", "gap"] } else { ["are", "gaps"] };
            which.filter(|_| count > 0).map(|which| format!("{} {gaps} {which}{are} not listed", grouped(count)))
        };
        Some(all.into_iter().filter_map(sentence).collect::<Vec<_>>().join(", ")).filter(|all| !all.is_empty())
    }

    /// The worst of each rule.
    pub(crate) fn write_worst(&self, out: &mut String, list: usize, decimals: usize) -> std::fmt::Result {
        for (rule, count, _) in self.counts() {
            let of_rule = self.findings.iter().filter(|one| one.rule == Some(rule.id()));
            let shown: Vec<&Diagnosis> = of_rule.take(list).collect();
            shown.iter().try_for_each(|one| write(out, one, decimals))?;
            write_explanations(out, shown.iter().copied())?;
            let more = count - shown.len();
            if more > 0 && !shown.is_empty() {
                writeln!(out, "   {QUIET}… and {} more of {}; see --list{QUIET:#}", grouped(more), rule.id())?;
            }
        }
        Ok(())
    }
}

/// The findings of C1 … C5.
struct Judgement {
    findings: Vec<(Finding, Option<&'static str>)>,
    gap_width: f64,
    sliver_area: f64,
    wider_gaps: usize,
    accepted_gaps: usize,
    of_input: Option<PlanarMap>,
}

fn judged(imported: &Imported, limits: &Limits, units: &Units) -> Result<Judgement, Failure> {
    let map = &imported.map;
    let Some(builder) = imported.builder.clone() else {
        let found = busy("checking the coverage", || check(map, limits))?;
        let converted = |mut finding: Finding| {
            units.convert(map, &mut finding);
            (finding, None)
        };
        let (wider_gaps, accepted_gaps) = (found.wider_gaps.len(), found.accepted_gaps.len());
        let (gap_width, sliver_area) = (found.gap_width, found.sliver_area);
        let findings = found.findings.into_iter().map(converted).collect();
        return Ok(Judgement { findings, gap_width, sliver_area, wider_gaps, accepted_gaps, of_input: None });
    };
    let of_input = builder.build_with(Noding::Snap(Snap::Auto))?;
    let found = check(&of_input, limits)?;
    // The same limits for both.
    let limits = Limits { sliver_area: Some(found.sliver_area), ..limits.clone() };
    let snapped = match map.noding() {
        Some(_) => check(map, &limits)?.findings,
        None => Vec::new(),
    };
    let converted = |map: &PlanarMap, finding: &Finding| {
        let mut finding = finding.clone();
        units.convert(map, &mut finding);
        finding
    };
    let is_among = |finding: &Finding, others: &[Finding]| {
        others.iter().any(|other| (other.rule, &other.features) == (finding.rule, &finding.features))
    };
    let made = snapped.iter().filter(|finding| !is_among(finding, &found.findings));
    let made: Vec<(Finding, Option<&'static str>)> =
        made.map(|finding| (converted(map, finding), Some("made"))).collect();
    let removed = |finding: &Finding| map.noding().is_some() && !is_among(finding, &snapped);
    let (wider_gaps, accepted_gaps) = (found.wider_gaps.len(), found.accepted_gaps.len());
    let on_input = found.findings.into_iter().map(|finding| {
        let snapping = removed(&finding).then_some("removed");
        (converted(&of_input, &finding), snapping)
    });
    let mut findings: Vec<_> = on_input.chain(made).collect();
    findings.sort_by_key(|(finding, _)| finding.rule);
    let (gap_width, sliver_area) = (found.gap_width, found.sliver_area);
    Ok(Judgement { findings, gap_width, sliver_area, wider_gaps, accepted_gaps, of_input: Some(of_input) })
}

/// The parts that all findings of a rule have in common.
fn of_rule(rule: CoverageRule, asked: &CoverageOptions, at: Point) -> Diagnosis {
    let (cause, remedy) = explanation(rule);
    Diagnosis {
        rule: Some(rule.id()),
        kind: Kind::Named { kind: rule.name() },
        cause: Some(cause),
        remedy: Some(remedy),
        look: Some(position(at)),
        is_violation: asked.is_rule(),
        ..Diagnosis::default()
    }
}

/// A feature that is not valid by the rules of the OGC.
fn invalid(imported: &Imported, asked: &CoverageOptions, feature: usize, defects: &[Defect]) -> Diagnosis {
    let flaw = |defect: &Defect| Flaw {
        reason: defect.kind.to_string(),
        at: position(defect.at),
        shape: defect.shape,
        ring: defect.ring,
    };
    // They are sorted by kind.
    let defects_of_kind = || defects.chunk_by(|a, b| a.kind == b.kind);
    let reasons: Vec<String> = defects_of_kind().map(|kind| kind[0].kind.to_string()).collect();
    let points = defects.iter().map(|defect| position(defect.at)).collect();
    let at = defects.first().map_or_else(|| Point::new(0.0, 0.0), |defect| defect.at);
    Diagnosis {
        message: reasons.join(", "),
        features: Some(imported.map.feature(feature).map(|id| named(imported, id)).into_iter().collect()),
        trace: Trace { points, ..Trace::default() },
        defects: defects_of_kind().flat_map(|kind| kind.iter().take(DEFECTS)).map(flaw).collect(),
        ..of_rule(CoverageRule::Validity, asked, at)
    }
}

/// A finding as a row of a table: the features by their ids, or else names, with semicolons between.
pub(crate) fn row(one: &Diagnosis) -> Row<'_> {
    let features = one.features.iter().flatten().map(|feature| feature.key()).collect::<Vec<_>>().join(";");
    let kind = one.defects.first().map_or(one.kind.name(), |flaw| &flaw.reason);
    let (Measures { area, width, length }, [x, y]) = (one.measures, one.look.map_or([None; 2], |at| at.map(Some)));
    (one.rule.unwrap_or_default(), kind, features, area, width, length, x, y)
}
