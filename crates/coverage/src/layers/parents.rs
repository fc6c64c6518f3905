//! X4 parent: each parent is made up exactly by its parts.

use super::finding::{Deviation, LayerFinding, sort};
use crate::CoverageError;
use crate::region::connected;
use std::collections::BTreeMap;
use twinedge::dcel::{Face, FaceKey};
use twinedge_algorithm::claims::{faces_by_feature, features_of};
use twinedge_map::{FeatureId, PlanarMap};

/// The declared parent of a feature.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Parent {
    /// The feature is not part of another one.
    #[default]
    None,
    /// The declared parent does not exist.
    Unknown,
    /// The feature is part of this one.
    Feature(FeatureId),
}

/// Finds violations of X4. `parents` contains the parent of each feature, by [`FeatureId::index`]; features beyond its end have
/// none. Features with parts must be covered by them, so the lowest level of a hierarchy is exempt. Features in `complete` must
/// be covered even if they have no parts.
///
/// O(n log n) for n half-edges and faces, each counted once for each feature that covers it.
///
/// ```
/// use twinedge_coverage::layers::{Deviation, Parent, check_parents};
/// use twinedge_map::{Builder, Noding, Shape};
///
/// // A state of two counties, of which one ends too early.
/// let county = |x: f64, width: f64| Shape::polygon([[x, 0.0], [x + width, 0.0], [x + width, 2.0], [x, 2.0]]);
/// let mut builder = Builder::new();
/// builder.shape(&county(0.0, 2.0))?;
/// builder.shape(&county(2.0, 1.5))?;
/// let state = builder.shape(&county(0.0, 4.0))?;
/// let map = builder.build_with(Noding::Exact)?;
/// let found = check_parents(&map, &[Parent::Feature(state); 2], &[])?;
/// assert_eq!((found.len(), found[0].deviation, found[0].area), (1, Deviation::ParentNotCovered, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CoverageError::NotPlane`].
pub fn check_parents(
    map: &PlanarMap,
    parents: &[Parent],
    complete: &[FeatureId],
) -> Result<Vec<LayerFinding>, CoverageError> {
    map.plane()?;
    let faces = faces_by_feature(map);
    let mut found = Vec::new();
    let mut parts: BTreeMap<FeatureId, Vec<FeatureId>> = complete.iter().map(|one| (*one, Vec::new())).collect();
    for (part, parent) in map.features().zip(parents) {
        let (deviation, others) = match parent {
            Parent::None => continue,
            Parent::Unknown => (Deviation::UnknownParent, Vec::new()),
            Parent::Feature(parent) => {
                parts.entry(*parent).or_default().push(part);
                (Deviation::OutsideParent, vec![*parent])
            }
        };
        // A part without area lies nowhere, but its parent can still be unknown.
        let all = live(map, faces.get(part.index()));
        let is_outside = |face: &Face<'_>| !features_of(map, *face).any(|one| others.contains(&one));
        let outside: Vec<Face<'_>> = all.into_iter().filter(is_outside).collect();
        if !outside.is_empty() || deviation == Deviation::UnknownParent {
            found.push(LayerFinding::of_faces(map, deviation, [vec![part], others], &outside));
        }
    }
    for (parent, parts) in parts {
        let covered = |face: Face<'_>| features_of(map, face).any(|one| parts.binary_search(&one).is_ok());
        let open: Vec<Face<'_>> =
            live(map, faces.get(parent.index())).into_iter().filter(|face| !covered(*face)).collect();
        // Covered neighbours belong to other regions.
        let class = |face: Face<'_>| (features_of(map, face).any(|one| one == parent) && !covered(face)).then_some(());
        for region in connected(open, class) {
            let others = [Vec::new(), vec![parent]];
            found.push(LayerFinding::of_faces(map, Deviation::ParentNotCovered, others, &region));
        }
    }
    sort(&mut found);
    Ok(found)
}

pub(super) fn live<'a>(map: &'a PlanarMap, keys: Option<&Vec<FaceKey>>) -> Vec<Face<'a>> {
    keys.into_iter().flatten().filter_map(|key| map.dcel().face(*key).ok()).collect()
}
