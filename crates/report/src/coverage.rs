//! The rules of a coverage, C1 … C7, in the report of `audit` and the answer of `query coverage`.

use crate::coverage_words::explanation;
use crate::diagnosis_text::size;
use crate::imported::Imported;
use crate::judgement::{Judgement, judged};
use crate::names::{named, numbered_name};
use crate::options::CoverageOptions;
use crate::trace::{of_finding, position};
use crate::units::Units;
use crate::verdict::Verdict;
use crate::words::style::{BAD, GOOD, QUIET};
use crate::words::{grouped, measure, plain};
use serde::Serialize;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use twinedge_coverage::{CoverageRule, Defect, Finding};
use twinedge_diagnosis::{Diagnosis, FeatureName, Flaw, Kind, Measures, MissingVertex, Position, Trace};
use twinedge_geometry::Point;
use twinedge_map::{Builder, PlanarMap};

/// The findings as JSON.
#[derive(Debug, Serialize)]
pub struct Coverage {
    overlaps: usize,
    gaps: usize,
    near_misses: usize,
    slivers: usize,
    duplicates: usize,
    /// The number of features, not defects; `None` if edges are great circles.
    ogc_invalid: Option<usize>,
    /// The number of pairs of features, not vertices.
    mismatches: usize,
    /// The unit of lengths; areas are in square units.
    unit: &'static str,
    /// The reason why only C6 was checked.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_checked: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    gap_width: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sliver_area: Option<f64>,
    /// The number of gaps wider than `lake_width` or `gap_width`, if one of these is given. They are not among the findings.
    wider_gaps: usize,
    /// The width from which gaps are no findings.
    #[serde(skip)]
    greatest_gap: Option<f64>,
    /// The number of gaps accepted by their place. They are not among the findings.
    accepted_gaps: usize,
    #[serde(skip)]
    unmet: Vec<Point>,
    /// The first findings of each rule, the largest first.
    findings: Vec<Diagnosis>,
    #[serde(skip)]
    has_polygons: bool,
    /// The missing vertices, sorted by place, each with the two features of its mismatch.
    #[serde(skip)]
    missing: Vec<(Position, [usize; 2])>,
    /// The map of the input with its borders cut, if the findings refer to that map.
    #[serde(skip)]
    of_input: Option<PlanarMap>,
    /// The words after a limit, if its unit is not the unit of lengths.
    #[serde(skip)]
    limits_in: &'static str,
}

/// The reason why C6 is not checked if edges are great circles.
const STRAIGHT_ONLY: &str = "it is about edges that are straight on the map; rings that cross themselves break G4";

/// A row of the table of findings: rule, kind, features, area, width, length, and the coordinates of the place.
pub type Row<'a> = (&'a str, &'a str, String, Option<f64>, Option<f64>, Option<f64>, Option<f64>, Option<f64>);

const DEFECTS: usize = 20;

impl Coverage {
    /// Checks all rules. Overlaps and gaps refer to the input, with crossing borders cut on the finest grid. If a grid was requested, comparing finds
    /// the features that it removed or made. `builder` is the map's builder, if it was kept.
    #[must_use]
    pub fn new(
        imported: &Imported,
        builder: Option<Builder>,
        asked: &CoverageOptions,
        units: &Units,
        list: usize,
        stage: &mut dyn FnMut(&'static str),
    ) -> Self {
        let judgement = judged(imported, builder, &asked.limits.limits(), units, stage).map_err(|why| why.to_string());
        Self::of(imported, asked, units, list, judgement)
    }

    /// The findings of a map judged by tiles, or the reason why there are none. A plane map has no mismatches.
    pub(crate) fn of_tiles(
        imported: &Imported,
        asked: &CoverageOptions,
        units: &Units,
        list: usize,
        found: Result<twinedge_coverage::Coverage, String>,
    ) -> Self {
        let judgement = |found: twinedge_coverage::Coverage| Judgement {
            wider_gaps: found.wider_gaps.len(),
            accepted_gaps: found.accepted_gaps.len(),
            unmet: Vec::new(),
            gap_width: found.gap_width,
            sliver_area: found.sliver_area,
            findings: found.findings.into_iter().map(|finding| (finding, None)).collect(),
            of_input: None,
        };
        Self::of(imported, asked, units, list, found.map(judgement))
    }

    fn empty(imported: &Imported, asked: &CoverageOptions, units: &Units) -> Self {
        Self {
            overlaps: 0,
            gaps: 0,
            near_misses: 0,
            slivers: 0,
            duplicates: 0,
            ogc_invalid: Some(imported.noted.defects.len()),
            mismatches: 0,
            unit: units.name(),
            not_checked: None,
            gap_width: None,
            sliver_area: None,
            wider_gaps: 0,
            greatest_gap: asked.limits.accepted.lake_width.or(asked.limits.gap_width),
            accepted_gaps: 0,
            unmet: Vec::new(),
            findings: Vec::new(),
            missing: Vec::new(),
            has_polygons: imported.read.polygons > 0,
            of_input: None,
            limits_in: if matches!(units, Units::Geodesic(_)) { " degrees" } else { "" },
        }
    }

    /// Creates a coverage without findings for a map whose edges are great circles. Limits are in metres.
    #[cfg(feature = "geodesic")]
    pub(crate) fn of_great_circles(imported: &Imported, asked: &CoverageOptions) -> Self {
        Self { ogc_invalid: None, limits_in: " metres", ..Self::empty(imported, asked, &Units::Plane(Units::METRES)) }
    }

    #[cfg(feature = "geodesic")]
    pub(crate) fn cannot_check(&mut self, why: String) {
        self.not_checked = Some(why);
    }

    /// Records the chosen limits and the number of gaps that are not listed.
    pub(crate) const fn limit_by(
        &mut self,
        [gap_width, sliver_area]: [f64; 2],
        [wider_gaps, accepted_gaps]: [usize; 2],
    ) {
        (self.gap_width, self.sliver_area) = (Some(gap_width), Some(sliver_area));
        (self.wider_gaps, self.accepted_gaps) = (wider_gaps, accepted_gaps);
    }

    /// Counts a finding, and lists it if fewer than `list` of its rule are listed.
    pub(crate) fn take(&mut self, rule: CoverageRule, list: usize, finding: impl FnOnce() -> Diagnosis) {
        let count = self.count_of(rule);
        *count += 1;
        if *count <= list {
            self.findings.push(finding());
        }
    }

    pub(crate) fn note_missing(&mut self, missing: impl Iterator<Item = (Position, [usize; 2])>) {
        self.missing.extend(missing);
    }

    /// Sorts the missing vertices; call it after the last `note_missing`.
    pub(crate) fn sort_missing(&mut self) {
        self.missing.sort_by(|(a, _), (b, _)| compare(a, b));
    }

    fn of(
        imported: &Imported,
        asked: &CoverageOptions,
        units: &Units,
        list: usize,
        judgement: Result<Judgement, String>,
    ) -> Self {
        let mut found = Self::empty(imported, asked, units);
        match judgement {
            Ok(Judgement { findings, gap_width, sliver_area, wider_gaps, accepted_gaps, unmet, of_input }) => {
                found.limit_by([gap_width, sliver_area], [wider_gaps, accepted_gaps]);
                for (finding, snapping) in &findings {
                    let map = of_input.as_ref().filter(|_| *snapping != Some("made")).unwrap_or(&imported.map);
                    found.take(finding.rule, list, || diagnosis(imported, asked, map, finding, *snapping));
                    let [first, last] = [finding.features.first(), finding.features.last()];
                    let pair = [first, last].map(|one| one.map_or(0, |one| one.index()));
                    found.note_missing(finding.missing.iter().map(|vertex| (position(vertex.at), pair)));
                }
                found.sort_missing();
                found.of_input = of_input;
                found.unmet = unmet;
            }
            Err(why) => found.not_checked = Some(why),
        }
        for (feature, defects) in imported.noted.defects.iter().take(list) {
            found.findings.push(invalid(imported, asked, units, *feature, defects));
        }
        found.findings.sort_by_key(|one| one.rule);
        found
    }

    /// Returns true if one of these places is a missing vertex between two of these features. O(places · log n).
    pub(crate) fn lacks_any(&self, places: &[Point], features: &BTreeSet<usize>) -> bool {
        places.iter().map(|place| position(*place)).any(|place| {
            let first = self.missing.partition_point(|(at, _)| compare(at, &place).is_lt());
            let mut here = self.missing[first..].iter().take_while(|(at, _)| compare(at, &place).is_eq());
            here.any(|(_, pair)| pair.iter().all(|feature| features.contains(feature)))
        })
    }

    /// Removes causes and remedies.
    #[must_use]
    pub fn unexplained(self) -> Self {
        Self { findings: self.findings.into_iter().map(Diagnosis::unexplained).collect(), ..self }
    }

    fn count_of(&mut self, rule: CoverageRule) -> &mut usize {
        match rule {
            CoverageRule::Overlap => &mut self.overlaps,
            CoverageRule::Gap => &mut self.gaps,
            CoverageRule::NearMiss => &mut self.near_misses,
            CoverageRule::Sliver => &mut self.slivers,
            CoverageRule::Duplicate => &mut self.duplicates,
            CoverageRule::Mismatch => &mut self.mismatches,
            // C6 is never counted here.
            _ => self.ogc_invalid.get_or_insert_default(),
        }
    }

    pub(crate) fn counts(&self) -> [(CoverageRule, usize); 7] {
        [
            (CoverageRule::Overlap, self.overlaps),
            (CoverageRule::Gap, self.gaps),
            (CoverageRule::NearMiss, self.near_misses),
            (CoverageRule::Sliver, self.slivers),
            (CoverageRule::Duplicate, self.duplicates),
            (CoverageRule::Validity, self.ogc_invalid.unwrap_or_default()),
            (CoverageRule::Mismatch, self.mismatches),
        ]
    }

    pub(crate) fn total(&self) -> usize {
        self.counts().iter().map(|(_, count)| count).sum()
    }

    pub(crate) fn accepted(&self, rule: CoverageRule) -> usize {
        self.findings.iter().filter(|one| one.rule == Some(rule.id()) && one.accepted.is_some()).count()
    }

    pub(crate) fn open(&self) -> usize {
        self.total() - self.findings.iter().filter(|one| one.accepted.is_some()).count()
    }

    /// The unaccepted causes by rule, in words, and "not checked" if only C6 was checked; `None` if there is neither.
    pub(crate) fn outcome_in_words(&self) -> Option<String> {
        let of_rule = |(rule, count)| {
            let listed = self.findings.iter().filter(|one| one.rule == Some(CoverageRule::id(rule)));
            let others = listed.filter(|one| one.accepted.is_some() || one.follows_from.is_some()).count();
            (count > others).then(|| words(rule, count - others))
        };
        let mut parts: Vec<String> = self.counts().into_iter().filter_map(of_rule).collect();
        parts.extend(self.not_checked.as_ref().map(|_| "not checked".to_owned()));
        Some(parts.join(", ")).filter(|all| !all.is_empty())
    }

    pub(crate) fn verdict(&self) -> Verdict {
        match (self.open(), &self.not_checked) {
            (1.., _) => Verdict::Invalid,
            (0, None) => Verdict::Valid,
            (0, Some(_)) => Verdict::Unknown,
        }
    }

    pub(crate) fn warnings(&self) -> impl Iterator<Item = String> {
        self.unmet.iter().map(|at| no_gap_at(*at))
    }

    pub(crate) const fn has_polygons(&self) -> bool {
        self.has_polygons
    }

    /// The reason why all rules but C6 could not be checked, if so.
    #[must_use]
    pub fn not_checked(&self) -> Option<&str> {
        self.not_checked.as_deref()
    }

    pub(crate) fn why_not(&self, rule: CoverageRule) -> Option<&str> {
        match rule {
            CoverageRule::Validity => Some(STRAIGHT_ONLY).filter(|_| self.ogc_invalid.is_none()),
            _ => self.not_checked(),
        }
    }

    /// Returns the listed findings.
    #[must_use]
    pub fn findings(&self) -> &[Diagnosis] {
        &self.findings
    }

    pub(crate) const fn unit(&self) -> &'static str {
        self.unit
    }

    /// Returns the map of the input with its borders cut, if the findings refer to that map.
    pub(crate) const fn of_input(&self) -> Option<&PlanarMap> {
        self.of_input.as_ref()
    }

    /// Returns the listed findings, for sorting and truncating.
    pub const fn findings_mut(&mut self) -> &mut Vec<Diagnosis> {
        &mut self.findings
    }

    /// Writes a line for each rule.
    ///
    /// # Errors
    /// Never: writing to a string does not fail.
    pub fn write_rules(&self, out: &mut String, is_rule: bool) -> std::fmt::Result {
        for (rule, count) in self.counts() {
            write!(out, "  {:2}  {:12} ", rule.id(), rule.name())?;
            let limit = self.limit(rule).map_or_else(String::new, |limit| format!("  {QUIET}{limit}{QUIET:#}"));
            match (count, self.why_not(rule)) {
                (_, Some(why)) => {
                    writeln!(out, "{QUIET}not checked: {}{QUIET:#}", plain(why))?;
                }
                (0, _) => writeln!(out, "{GOOD}ok{GOOD:#}{limit}")?,
                (n, _) if n == self.accepted(rule) => writeln!(out, "{GOOD}ok{GOOD:#}  {}{limit}", self.found(rule))?,
                _ => {
                    let broken = if is_rule { format!("{BAD}BROKEN{BAD:#}  ") } else { String::new() };
                    writeln!(out, "{broken}{}{limit}", self.found(rule))?;
                }
            }
        }
        Ok(())
    }

    fn found(&self, rule: CoverageRule) -> String {
        let count = self.counts().into_iter().find(|(other, _)| *other == rule).map_or(0, |(_, count)| count);
        let follow = |one: &&Diagnosis| one.rule == Some(rule.id()) && one.follows_from.is_some();
        let beside = [(self.accepted(rule), "accepted"), (self.findings.iter().filter(follow).count(), "that follow")];
        let beside = beside.into_iter().filter(|(count, _)| *count > 0);
        beside.fold(words(rule, count), |found, (count, what)| format!("{found}, {} {what}", grouped(count)))
    }

    pub(crate) fn outcome(&self, rule: CoverageRule) -> String {
        if let Some(why) = self.why_not(rule) {
            return format!("not checked: {why}");
        }
        let mark = if rule == CoverageRule::Gap { "; " } else { " " };
        [self.found(rule)].into_iter().chain(self.limit(rule)).collect::<Vec<_>>().join(mark)
    }

    fn limit(&self, rule: CoverageRule) -> Option<String> {
        let degrees = self.limits_in;
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

    /// The number of gaps that are not findings, in words.
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
}

pub(crate) fn words(rule: CoverageRule, count: usize) -> String {
    let [one, several] = match rule {
        CoverageRule::Overlap => ["overlap", "overlaps"],
        CoverageRule::Gap => ["gap", "gaps"],
        CoverageRule::NearMiss => ["near miss", "near misses"],
        CoverageRule::Sliver => ["sliver", "slivers"],
        CoverageRule::Duplicate => ["set of duplicates", "sets of duplicates"],
        CoverageRule::Validity => ["invalid feature", "invalid features"],
        CoverageRule::Mismatch => ["mismatch", "mismatches"],
        _ => ["finding", "findings"],
    };
    format!("{} {}", grouped(count), if count == 1 { one } else { several })
}

fn diagnosis(
    imported: &Imported,
    asked: &CoverageOptions,
    map: &PlanarMap,
    finding: &Finding,
    snapping: Option<&'static str>,
) -> Diagnosis {
    let features: Vec<FeatureName> = finding.features.iter().map(|feature| named(imported, *feature)).collect();
    let is_mismatch = finding.rule == CoverageRule::Mismatch;
    let measures = Measures {
        area: Some(finding.area).filter(|_| !is_mismatch),
        width: Some(finding.width).filter(|_| !is_mismatch),
        length: Some(finding.length),
    };
    let missing = missing(finding);
    Diagnosis {
        message: size(measures).unwrap_or_else(|| lacks(&features, &missing)),
        features: Some(features),
        trace: of_finding(map, finding),
        measures,
        missing,
        snapping,
        ..of_rule(finding.rule, asked, Some(finding.at))
    }
}

/// The order of places: by x, then by y.
fn compare(a: &Position, b: &Position) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
}

fn missing(finding: &Finding) -> Vec<MissingVertex> {
    let of = |vertex: &twinedge_coverage::MissingVertex| MissingVertex {
        at: position(vertex.at),
        feature: vertex.feature.index(),
    };
    finding.missing.iter().map(of).collect()
}

/// The number of vertices that each feature lacks, in words.
pub(crate) fn lacks(features: &[FeatureName], missing: &[MissingVertex]) -> String {
    let of = |feature: &FeatureName| {
        let count = missing.iter().filter(|vertex| vertex.feature == feature.number).count();
        let vertices = if count == 1 { "1 vertex".to_owned() } else { format!("{} vertices", grouped(count)) };
        (count > 0).then(|| format!("{vertices} missing in {}", feature.label))
    };
    features.iter().filter_map(of).collect::<Vec<_>>().join(", ")
}

pub(crate) fn of_rule(rule: CoverageRule, asked: &CoverageOptions, at: Option<Point>) -> Diagnosis {
    let (cause, remedy) = explanation(rule);
    Diagnosis {
        rule: Some(rule.id()),
        kind: Kind::Named { kind: rule.name() },
        cause: Some(cause),
        remedy: Some(remedy),
        look: at.map(position),
        is_violation: asked.coverage,
        ..Diagnosis::default()
    }
}

fn invalid(
    imported: &Imported,
    asked: &CoverageOptions,
    units: &Units,
    feature: usize,
    defects: &[Defect],
) -> Diagnosis {
    let reason = |defect: &Defect| match defect.gap_to {
        Some(to) => format!("{}: a gap of {}", defect.kind, measure(units.length(&[defect.at, to]))),
        None => defect.kind.to_string(),
    };
    let flaw = |defect: &Defect| Flaw {
        reason: reason(defect),
        at: position(defect.at),
        shape: defect.shape,
        ring: defect.ring,
    };
    // The defects are sorted by kind.
    let defects_of_kind = || defects.chunk_by(|a, b| a.kind == b.kind);
    let mut reasons: Vec<String> = defects_of_kind().map(|kind| reason(&kind[0])).collect();
    if reasons.is_empty() {
        let unreadable = imported.noted.unreadable.get(&feature);
        let why = unreadable.map(|why| format!("its geometry cannot be read: {}; it is left out", plain(why)));
        reasons.push(why.unwrap_or_else(|| "a coordinate is NaN or infinite; it is left out".to_owned()));
    }
    let points = defects.iter().map(|defect| position(defect.at)).collect();
    let at = defects.first().map(|defect| defect.at);
    Diagnosis {
        message: reasons.join(", "),
        features: Some(vec![numbered_name(imported, feature)]),
        trace: Trace { points, ..Trace::default() },
        defects: defects_of_kind().flat_map(|kind| kind.iter().take(DEFECTS)).map(flaw).collect(),
        ..of_rule(CoverageRule::Validity, asked, at)
    }
}

pub(crate) fn no_gap_at(place: Point) -> String {
    format!("there is no gap at the accepted place ({}, {})", place.x, place.y)
}

/// Returns a finding as a row of a table. Features are given by id, or else name, separated by semicolons.
#[must_use]
pub fn row(one: &Diagnosis) -> Row<'_> {
    let features = one.features.iter().flatten().map(|feature| feature.key()).collect::<Vec<_>>().join(";");
    let kind = one.defects.first().map_or(one.kind.name(), |flaw| &flaw.reason);
    let (Measures { area, width, length }, [x, y]) = (one.measures, one.look.map_or([None; 2], |at| at.map(Some)));
    (one.rule.unwrap_or_default(), kind, features, area, width, length, x, y)
}
