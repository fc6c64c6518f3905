//! Findings of a coverage on the sphere, in the common form of reports.

use super::lines::lines;
use crate::coverage::{Coverage, lacks, of_rule};
use crate::diagnosis_text::size;
use crate::imported::Imported;
use crate::names::all_named;
use crate::options::CoverageOptions;
use crate::trace::position;
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::{Diagnosis, Measures, MissingVertex, Position, Trace};
use twinedge_sphere::Finding;

pub(crate) struct Judged(pub(crate) twinedge_sphere::Coverage);

impl Coverage {
    /// Returns the findings of a map whose edges are great circles, or the reason why there are none. C6 is about straight edges and is not checked.
    pub(crate) fn on_sphere(
        imported: &Imported,
        asked: &CoverageOptions,
        list: usize,
        judged: Result<Judged, String>,
    ) -> Self {
        let mut found = Self::of_great_circles(imported, asked);
        match judged {
            Err(why) => found.cannot_check(why),
            Ok(Judged(coverage)) => {
                let limits = [coverage.gap_width, coverage.sliver_area];
                found.limit_by(limits, [coverage.wider_gaps, coverage.accepted_gaps]);
                for one in &coverage.findings {
                    found.take(one.rule, list, || diagnosis(imported, asked, one));
                    let pair = [0, 1].map(|i| one.features.get(i).map_or(0, |feature| *feature as usize));
                    found.note_missing(one.missing.iter().map(|vertex| (position(vertex.at), pair)));
                }
                found.sort_missing();
            }
        }
        found
    }
}

fn diagnosis(imported: &Imported, asked: &CoverageOptions, one: &Finding) -> Diagnosis {
    let features = all_named(imported, one.features.iter().copied());
    let is_mismatch = one.rule == CoverageRule::Mismatch;
    // These findings are stretches of borders or arcs.
    let is_line = matches!(one.rule, CoverageRule::Mismatch | CoverageRule::NearMiss);
    let measures = Measures {
        area: Some(one.area).filter(|_| !is_mismatch),
        width: Some(one.width).filter(|_| !is_mismatch),
        length: Some(one.length),
    };
    let missing: Vec<MissingVertex> = one
        .missing
        .iter()
        .map(|vertex| MissingVertex { at: position(vertex.at), feature: vertex.feature as usize })
        .collect();
    Diagnosis {
        message: size(measures).unwrap_or_else(|| lacks(&features, &missing)),
        features: Some(features),
        trace: trace(&lines(&one.border), is_line),
        measures,
        missing,
        ..of_rule(one.rule, asked, Some(one.at))
    }
}

/// Returns a polygon if the border is one ring that turns counter-clockwise on the map and does not run around the globe; otherwise lines.
fn trace(lines: &[Vec<Position>], is_line: bool) -> Trace {
    match lines {
        [ring] if !is_line && is_ring(ring) => Trace { polygons: vec![vec![ring.clone()]], ..Trace::default() },
        _ => Trace { lines: lines.to_vec(), ..Trace::default() },
    }
}

fn is_ring(line: &[Position]) -> bool {
    let Some([x0, y0]) = line.first().filter(|first| line.last() == Some(*first)) else { return false };
    let twice = |pair: &[Position]| (pair[0][0] - x0) * (pair[1][1] - y0) - (pair[0][1] - y0) * (pair[1][0] - x0);
    line.len() > 3 && line.windows(2).map(twice).sum::<f64>() > 0.0
}

#[cfg(test)]
mod tests {
    use super::is_ring;

    #[test]
    fn only_a_ring_to_the_left_is_a_polygon() {
        let ring = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
        let mut back = ring;
        back.reverse();
        assert!(is_ring(&ring) && !is_ring(&back) && !is_ring(&ring[..3]) && !is_ring(&[]));
    }
}
