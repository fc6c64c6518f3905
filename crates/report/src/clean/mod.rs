//! The report on a cleaned layer, in words and as JSON: the names of its features, the reason for each change, and the
//! remaining findings.

mod json;
mod names;
mod patch;
mod repair;
mod text;
mod tiles;
mod told;

use crate::coverage::no_gap_at;
use crate::words::{decimals, decimals_of, measure, place};
use std::collections::{BTreeMap, BTreeSet};
use told::{Called, ToldTiles, mentioned};
use twinedge_coverage::CoverageRule;
use twinedge_coverage::clean::ChangeKind;
use twinedge_diagnosis::FeatureName;
use twinedge_layers::clean::{CleanReport, FeatureChange, LayerChange, Remaining};
use twinedge_layers::{Format, Layer};

pub use names::Names;
pub use patch::{Changes, GeometryChange, Patch, PatchError, TextChange};
pub use repair::Repair;
pub use tiles::{CleanedTiles, clean_in_tiles};

/// The report on a cleaned layer.
#[derive(Debug)]
pub struct Cleaning<'a> {
    name: &'a str,
    features: usize,
    called: Vec<(usize, Called)>,
    decimals: usize,
    report: &'a CleanReport,
    /// The written file.
    pub written: Option<&'a Written>,
    /// The width from which gaps are accepted.
    greatest_gap: Option<f64>,
    /// True for `--gap-width auto`.
    chooses_width: bool,
    tiles: Option<ToldTiles>,
    /// The file that undoes the cleaning.
    pub patch: Option<&'a str>,
    /// The changes that each feature takes part in.
    changes: BTreeMap<usize, Vec<&'a LayerChange>>,
    /// The features whose vertices each feature received.
    neighbours: BTreeMap<usize, BTreeSet<usize>>,
    /// The elapsed time in milliseconds.
    pub elapsed_ms: f64,
}

/// A written file.
#[derive(Clone, Debug)]
pub struct Written {
    /// Its name.
    pub name: String,
    /// Its format.
    pub format: Format,
}

impl<'a> Cleaning<'a> {
    /// Creates the report on a layer that `repair` cleaned.
    #[must_use]
    pub fn new(name: &'a str, repair: &Repair<'a>, layer: &Layer, report: &'a CleanReport) -> Self {
        let called = |number: usize| Some((number, Called::new(repair.names, layer.features.get(number)?)));
        let mut largest: f64 = 0.0;
        for geometry in layer.features.iter().filter_map(|feature| feature.geometry.as_ref()) {
            geometry.shape.visit(&mut |position| largest = largest.max(position.x.abs()).max(position.y.abs()));
        }
        let called = mentioned(report).into_iter().filter_map(called).collect();
        Self { features: layer.features.len(), called, decimals: decimals(largest), ..Self::of(name, repair, report) }
    }

    /// Creates the report on a layer that was cleaned by tiles.
    #[must_use]
    pub fn of_tiles(name: &'a str, repair: &Repair<'a>, tiles: &'a CleanedTiles) -> Self {
        let cleaning = Self {
            features: tiles.features,
            called: tiles.called.clone(),
            decimals: decimals(tiles.largest),
            ..Self::of(name, repair, &tiles.report)
        };
        let told = tiles.told(cleaning.decimals, |number| cleaning.named(*number));
        Self { tiles: Some(told), ..cleaning }
    }

    fn of(name: &'a str, repair: &Repair<'a>, report: &'a CleanReport) -> Self {
        let mut changes: BTreeMap<usize, Vec<&LayerChange>> = BTreeMap::new();
        for change in &report.changes {
            let won = change.to.filter(|to| !change.from.contains(to));
            for feature in change.from.iter().copied().chain(won) {
                changes.entry(feature).or_default().push(change);
            }
        }
        let mut neighbours: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        for vertex in &report.added {
            neighbours.entry(vertex.to).or_default().insert(vertex.of);
        }
        Self {
            name,
            features: 0,
            called: Vec::new(),
            decimals: 0,
            report,
            written: None,
            greatest_gap: repair.options.assign.lake_width.or(report.gap_width),
            chooses_width: repair.options.chooses_width,
            tiles: None,
            patch: None,
            changes,
            neighbours,
            elapsed_ms: 0.0,
        }
    }
}

impl Cleaning<'_> {
    fn label(&self, number: usize) -> String {
        self.called(number).label(number)
    }

    fn called(&self, number: usize) -> Called {
        let place = self.called.binary_search_by_key(&number, |(number, _)| *number);
        place.map_or_else(|_| Called::default(), |place| self.called[place].1.clone())
    }

    fn named(&self, number: usize) -> FeatureName {
        let called = self.called(number);
        let label = called.label(number);
        FeatureName { number, id: called.id, name: called.name, label }
    }

    fn labels(&self, numbers: &[usize]) -> String {
        numbers.iter().map(|number| self.label(*number)).collect::<Vec<_>>().join(", ")
    }

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
        if let Some(of) = self.neighbours.get(&number) {
            reasons.push(format!("vertices of {} added", self.labels(&of.iter().copied().collect::<Vec<_>>())));
        }
        if self.report.made == Some(number) {
            reasons.push("made for gaps".to_owned());
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

    /// Warns of features that lost their geometry, and of accepted places without a gap.
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
        let unmet = self.report.unmet.iter().map(|at| no_gap_at(*at));
        gone.map(warning).chain(unmet).collect()
    }

    /// Describes a remaining finding and the option that would remove it.
    fn remaining(&self, one: &Remaining, decimals: usize) -> String {
        let hint = match one.rule {
            CoverageRule::Gap => format!("; --gap-width {} would fill it", rounded_up(one.width)),
            CoverageRule::NearMiss => "; --gap-width would fill it, from its greatest width on".to_owned(),
            _ => String::new(),
        };
        format!("{}{hint}", self.described(one, decimals))
    }

    fn described(&self, one: &Remaining, decimals: usize) -> String {
        let Remaining { rule, features, area, width, at, .. } = one;
        let what = match features.len() {
            0 => rule.name().to_owned(),
            _ => format!("{} of {}", rule.name(), self.labels(features)),
        };
        let at = place([at.x, at.y], decimals.max(decimals_of(Some(*width))));
        match rule {
            CoverageRule::Validity | CoverageRule::Mismatch => format!("{what}, at {at}"),
            _ => format!("{what}, area {}, width {}, at {at}", measure(*area), measure(*width)),
        }
    }
}

fn rounded_up(x: f64) -> f64 {
    let unit = 10_f64.powf(x.abs().max(f64::MIN_POSITIVE).log10().floor() - 2.0);
    let text = format!("{:.2e}", (x / unit).ceil() * unit);
    text.parse().ok().filter(|y| *y >= x).unwrap_or(x)
}
