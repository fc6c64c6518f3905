//! Neighbours: pairs of features with a border or an overlap.

use crate::names::label;
use crate::noted::Noted;
use crate::units::Units;
use serde::Serialize;
use twinedge::dcel::Face;
use twinedge_algorithm::neighbours::pairs;
use twinedge_map::{FeatureId, PlanarMap};

/// Two features and their border.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Border {
    /// The first feature's number.
    pub number: usize,
    /// The first feature's id in the file.
    pub id: Option<String>,
    /// The first feature's name.
    pub name: String,
    /// The second feature's number.
    pub other_number: usize,
    /// The second feature's id in the file.
    pub other_id: Option<String>,
    /// The second feature's name.
    pub other_name: String,
    /// The length of the border of the first feature with the second.
    pub length: f64,
    /// The length on which one feature ends and the other begins.
    pub shared: f64,
    /// The number of lines of the border.
    pub lines: usize,
    /// The area covered by both.
    pub overlap: f64,
}

/// Returns all pairs of features with a border or an overlap, in the order of the features.
#[must_use]
pub fn borders(map: &PlanarMap, noted: &Noted, units: &Units) -> Vec<Border> {
    let id = |feature: FeatureId| noted.ids.get(feature.index()).cloned().flatten();
    let mut rows: Vec<Border> = Vec::new();
    for pair in pairs(map) {
        let [one, other] = pair.features;
        let border = pair.border;
        let plane = border.length;
        let (length, overlap) = match units {
            Units::Plane(_) => (plane, pair.overlap),
            Units::Geodesic(_) => {
                let covers = |face: Face<'_>, of| map.features_of(face.key()).into_iter().flatten().any(|f| f == of);
                let both = map.dcel().faces().filter(|f| pair.overlap > 0.0 && covers(*f, one) && covers(*f, other));
                let length = border.borders.iter().map(|chain| units.length(chain)).sum();
                (length, both.map(|face| units.area(map, face)).sum())
            }
        };
        // If features overlap along part of their border, the length of that part is known only in the units of the
        // coordinates.
        let shared = if plane > 0.0 { length * (border.shared / plane) } else { 0.0 };
        rows.push(Border {
            number: one.index(),
            id: id(one),
            name: label(map, one),
            other_number: other.index(),
            other_id: id(other),
            other_name: label(map, other),
            length,
            shared,
            lines: border.borders.len(),
            overlap,
        });
    }
    rows
}
