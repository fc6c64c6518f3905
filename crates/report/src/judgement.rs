//! Judges a map by the rules C1 … C5 and C7, before and after snapping to a grid.

use crate::imported::Imported;
use crate::units::Units;
use twinedge_coverage::{CoverageError, CoverageRule, Finding, Limits, check, mismatches};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{BuildError, Builder, Noding, PlanarMap};

/// The reason why only C6 was checked.
#[derive(Debug, thiserror::Error)]
pub(crate) enum NotChecked {
    #[error(transparent)]
    Build(#[from] BuildError),
    #[error(transparent)]
    Coverage(#[from] CoverageError),
    #[error("{0}")]
    TooFar(String),
}

pub(crate) struct Judgement {
    pub(crate) findings: Vec<(Finding, Option<&'static str>)>,
    pub(crate) gap_width: f64,
    pub(crate) sliver_area: f64,
    pub(crate) wider_gaps: usize,
    pub(crate) accepted_gaps: usize,
    pub(crate) unmet: Vec<Point>,
    pub(crate) of_input: Option<PlanarMap>,
}

pub(crate) fn judged(
    imported: &Imported,
    builder: Option<Builder>,
    limits: &Limits,
    units: &Units,
    stage: &mut dyn FnMut(&'static str),
) -> Result<Judgement, NotChecked> {
    let map = &imported.map;
    let is_cut = builder.is_some() || map.noding().is_some();
    if let Some(why) = imported.noted.too_far_to_cut().filter(|_| is_cut) {
        return Err(NotChecked::TooFar(why));
    }
    let Some(builder) = builder else {
        stage("checking the coverage");
        let mut found = check(map, limits)?;
        found.findings.extend(mismatches(map, &imported.unmatched)?);
        let converted = |mut finding: Finding| {
            units.convert(map, &mut finding);
            // Noding has added the missing vertices.
            let snapping = (finding.rule == CoverageRule::Mismatch).then_some("removed");
            (finding, snapping)
        };
        let (wider_gaps, accepted_gaps) = (found.wider_gaps.len(), found.accepted_gaps.len());
        let (gap_width, sliver_area) = (found.gap_width, found.sliver_area);
        let unmet = found.unmet_places(map, limits);
        let findings = found.findings.into_iter().map(converted).collect();
        return Ok(Judgement { findings, gap_width, sliver_area, wider_gaps, accepted_gaps, unmet, of_input: None });
    };
    let of_input = builder.build_with(Noding::Snap(Snap::Auto))?;
    let mut found = check(&of_input, limits)?;
    found.findings.extend(mismatches(&of_input, &imported.unmatched)?);
    // Both maps are judged with the same limits.
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
    let unmet = found.unmet_places(&of_input, &limits);
    let on_input = found.findings.into_iter().map(|finding| {
        let snapping = removed(&finding).then_some("removed");
        (converted(&of_input, &finding), snapping)
    });
    let mut findings: Vec<_> = on_input.chain(made).collect();
    findings.sort_by_key(|(finding, _)| finding.rule);
    let (gap_width, sliver_area) = (found.gap_width, found.sliver_area);
    Ok(Judgement { findings, gap_width, sliver_area, wider_gaps, accepted_gaps, unmet, of_input: Some(of_input) })
}
