//! The pieces into which two layers cut each other.

use super::split;
use crate::CoverageError;
use std::collections::BTreeMap;
use twinedge::dcel::FaceKey;
use twinedge_map::{FeatureId, PlanarMap};

/// The common area of a feature of one layer and a feature of the other, or an area that only one layer covers.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Piece {
    /// The feature of the first layer.
    pub first: Option<FeatureId>,
    /// The feature of the other layer. At least one of the two is present.
    pub second: Option<FeatureId>,
    /// The faces, in order of their indices.
    pub faces: Vec<FaceKey>,
}

/// Returns the pieces of two layers on one map. The first `count` features of the map belong to the first layer. Pieces are
/// sorted by the feature of the first layer, then of the other layer; missing features come last.
///
/// A face that two features of one layer cover is in a piece of each. O(faces + p log p) for p pairs of a face and a piece.
///
/// ```
/// use twinedge_coverage::layers::pieces;
/// use twinedge_map::{Builder, Noding, Shape};
///
/// let square = |low: f64, high: f64| Shape::polygon([[low, low], [high, low], [high, high], [low, high]]);
/// let mut builder = Builder::new();
/// let field = builder.shape(&square(0.0, 3.0))?;
/// let lake = builder.shape(&square(1.0, 2.0))?;
/// let map = builder.build_with(Noding::Exact)?;
/// let pieces = pieces(&map, 1)?;
/// let brief: Vec<_> = pieces.iter().map(|piece| (piece.first, piece.second)).collect();
/// assert_eq!(brief, [(Some(field), Some(lake)), (Some(field), None)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CoverageError::NotPlane`].
pub fn pieces(map: &PlanarMap, count: usize) -> Result<Vec<Piece>, CoverageError> {
    map.plane()?;
    // Missing features come last.
    let key = |feature: Option<FeatureId>| (feature.is_none(), feature);
    let mut found: BTreeMap<_, Vec<FaceKey>> = BTreeMap::new();
    for face in map.dcel().faces() {
        let [first, second] = split(map, face, count)
            .map(|of_layer| if of_layer.is_empty() { vec![None] } else { of_layer.into_iter().map(Some).collect() });
        for one in first {
            for other in second.iter().filter(|other| one.or(**other).is_some()) {
                found.entry((key(one), key(*other))).or_default().push(face.key());
            }
        }
    }
    let piece = |(((_, first), (_, second)), faces)| Piece { first, second, faces };
    Ok(found.into_iter().map(piece).collect())
}
