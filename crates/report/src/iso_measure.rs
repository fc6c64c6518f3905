//! The numbers of the ISO 19157 measures that count findings.

use twinedge_coverage::{CoverageRule, DefectKind};
use twinedge_diagnosis::Diagnosis;

const OVERLAP: u32 = 11;
const FAULTY_CONNECTION: u32 = 21;
const UNDERSHOOT: u32 = 23;
const SLIVER: u32 = 25;
const SELF_INTERSECT: u32 = 26;

/// Returns the measure that counts a finding, if any. For C7, it counts each missing vertex.
pub(crate) fn measure_of(one: &Diagnosis) -> Option<u32> {
    let rule = CoverageRule::ALL.into_iter().find(|rule| one.rule == Some(rule.id()))?;
    let crosses = [DefectKind::SelfIntersection, DefectKind::RingSelfIntersection].map(|kind| kind.to_string());
    match rule {
        CoverageRule::Overlap => Some(OVERLAP),
        CoverageRule::Mismatch => Some(FAULTY_CONNECTION),
        CoverageRule::NearMiss => Some(UNDERSHOOT),
        CoverageRule::Sliver => Some(SLIVER),
        CoverageRule::Validity => {
            one.defects.iter().any(|flaw| crosses.contains(&flaw.reason)).then_some(SELF_INTERSECT)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{DefectKind, Diagnosis, SELF_INTERSECT, measure_of};
    use twinedge_diagnosis::Flaw;

    #[test]
    fn each_rule_has_the_number_of_annex_d() {
        let of = |rule| measure_of(&Diagnosis { rule: Some(rule), ..Diagnosis::default() });
        let numbers = ["C1", "C2", "C3", "C4", "C5", "C7", "X1"].map(of);
        assert_eq!(numbers, [Some(11), None, Some(23), Some(25), None, Some(21), None]);
    }

    #[test]
    fn of_invalid_polygons_those_count_that_cross_themselves() {
        let of = |kind: DefectKind| {
            let flaw = Flaw { reason: kind.to_string(), at: [0.0; 2], shape: 0, ring: 0 };
            measure_of(&Diagnosis { rule: Some("C6"), defects: vec![flaw], ..Diagnosis::default() })
        };
        assert_eq!(of(DefectKind::SelfIntersection), Some(SELF_INTERSECT));
        assert_eq!(of(DefectKind::RingSelfIntersection), Some(SELF_INTERSECT));
        assert_eq!(of(DefectKind::TooFewPoints), None);
        assert_eq!(of(DefectKind::NestedHoles), None);
    }
}
