//! Ids of findings that stay the same from run to run, for any order of the features.
//!
//! An id is a digest of the rule, the kind, the features by id or else name, and a place: the finding's first corner, in 30 binary digits. A finding
//! without a place is identified by the names of its records. A number tells findings apart that agree in all of this.

use sha2::{Digest as _, Sha256};
use std::collections::HashMap;
use std::fmt::Write as _;
use twinedge::validate::Violation;
use twinedge_diagnosis::{Diagnosis, FeatureName, Figures, Kind, Position};

const BYTES: usize = 8;

/// The number of binary digits for the larger coordinate of a place.
const DIGITS: i32 = 30;

#[derive(Default)]
pub(crate) struct Identities(HashMap<String, usize>);

impl Identities {
    /// Assigns an id to a finding. O(its points).
    pub(crate) fn identify(&mut self, one: &mut Diagnosis) {
        let rule = one.rule.unwrap_or(one.kind.name());
        let keys = |of: &'_ Option<Vec<FeatureName>>| {
            let mut keys: Vec<String> =
                of.iter().flatten().filter_map(|f| f.id.clone().or_else(|| f.name.clone())).collect();
            keys.sort_unstable();
            keys
        };
        let (features, others) = (keys(&one.features), keys(&one.others));
        let mut text = format!("{rule}\n{}\n", one.kind.name());
        // The vertex that names the component depends on the order.
        let figures = match one.kind {
            Kind::Of(Violation::Genus { vertices, edges, cycles, genus, .. }) => {
                Some([vertices, edges, cycles, genus].map(|number| number as u64))
            }
            Kind::Counted { fields: Figures { vertices, edges, cycles, genus }, .. } => {
                Some([vertices, edges, cycles, genus])
            }
            _ => None,
        };
        if let Some([vertices, edges, cycles, genus]) = figures {
            let _ = write!(text, "{vertices} {edges} {cycles} {genus}");
        } else {
            // Each name is preceded by its length, so that different lists are different texts.
            for feature in features {
                let _ = write!(text, "{}:{feature}", feature.len());
            }
            text.push('\n');
            for other in others {
                let _ = write!(text, "{}:{other},", other.len());
            }
            match first_corner(one) {
                Some(at) => text.push_str(&on_grid(at)),
                None => text.push_str(&one.records.names().join(",")),
            }
        }
        let digest = Sha256::digest(text.as_bytes());
        let mut id = format!("{rule}-");
        for byte in &digest[..BYTES] {
            let _ = write!(id, "{byte:02x}");
        }
        let count = self.0.entry(id.clone()).or_default();
        *count += 1;
        if *count > 1 {
            let _ = write!(id, "-{count}");
        }
        one.id = Some(id);
    }
}

/// Returns the least point of a finding, in order of x and then y.
fn first_corner(one: &Diagnosis) -> Option<Position> {
    let trace = &one.trace;
    let rings = trace.polygons.iter().flatten().chain(&trace.lines).flatten();
    let all = rings.chain(&trace.points).chain(one.places.iter().flatten()).chain(&one.look);
    let of_trace = all.filter(|at| at.iter().all(|x| x.is_finite())).copied();
    of_trace.reduce(|a, b| if a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).is_le() { a } else { b })
}

/// A place in words: both coordinates in units of the larger coordinate's last digit.
fn on_grid([x, y]: Position) -> String {
    let largest = x.abs().max(y.abs());
    if largest == 0.0 {
        return "0 0".to_owned();
    }
    let exponent = largest.log2().floor() as i32 - DIGITS;
    let cell = f64::from(exponent).exp2();
    format!("{} {} {exponent}", (x / cell).round() + 0.0, (y / cell).round() + 0.0)
}

#[cfg(test)]
mod tests {
    use super::{Identities, on_grid};
    use twinedge_diagnosis::{Diagnosis, FeatureName};

    fn feature(number: usize, id: &str) -> FeatureName {
        FeatureName { number, id: Some(id.to_owned()), name: None, label: String::new() }
    }

    fn identified(features: Vec<FeatureName>, look: [f64; 2]) -> Diagnosis {
        Diagnosis { rule: Some("C1"), features: Some(features), look: Some(look), ..Diagnosis::default() }
    }

    #[test]
    fn an_id_is_that_of_rule_features_and_place() {
        let mut all = Identities::default();
        let mut id = |mut one: Diagnosis| {
            all.identify(&mut one);
            one.id.expect("it has one")
        };
        let first = id(identified(vec![feature(0, "a"), feature(1, "b")], [1.0, 2.0]));
        assert!(first.starts_with("C1-") && first.len() == 3 + 16, "{first}");
        // The numbers and the order of the features do not matter.
        let again = id(identified(vec![feature(7, "b"), feature(3, "a")], [1.0, 2.0]));
        assert_eq!(again, format!("{first}-2"));
        let others = [
            identified(vec![feature(0, "a"), feature(1, "c")], [1.0, 2.0]),
            identified(vec![feature(0, "ab")], [1.0, 2.0]),
            identified(vec![feature(0, "a"), feature(1, "b")], [1.0, 2.000_001]),
        ];
        for other in others {
            assert!(!id(other).starts_with(&first));
        }
    }

    #[test]
    fn a_place_has_thirty_digits() {
        assert_eq!(on_grid([3.0, -0.0]), "1610612736 0 -29");
        assert_eq!(on_grid([-3.0 - 1e-10, 0.5]), "-1610612736 268435456 -29");
        assert_ne!(on_grid([3.0 + 1e-8, 0.5]), on_grid([3.0, 0.5]));
        assert_eq!(on_grid([0.0, -0.0]), "0 0");
        // The smallest and the largest coordinates that the predicates take.
        assert!(on_grid([1e-140, 1e-145]).ends_with(" -496"));
        assert!(on_grid([1e140, 0.0]).ends_with(" 435"));
    }
}
