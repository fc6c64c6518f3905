//! The faces that a feature covers.

use twinedge::dcel::{Face, FaceKey};
use twinedge_map::{FeatureId, PlanarMap};

/// Returns the features that cover a face, without features that leak. O(log n) on a plane map.
pub fn features_of<'a>(map: &'a PlanarMap, face: Face<'a>) -> impl Iterator<Item = FeatureId> + 'a {
    let plane = map.is_plane();
    map.features_of(face.key()).into_iter().flatten().filter(move |feature| plane || !leaks(map, *feature))
}

/// Returns true if a feature seems to cover the unbounded face, so that its extent is unknown. This never happens on a plane map.
/// O(log n + leaking features).
///
/// ```
/// use twinedge_algorithm::claims::leaks;
/// use twinedge_map::{Builder, Shape};
///
/// let mut builder = Builder::new();
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let field = builder.shape(&Shape::polygon(square))?;
/// assert!(!leaks(&builder.build()?, field));
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn leaks(map: &PlanarMap, feature: FeatureId) -> bool {
    map.features_of(map.dcel().unbounded_face().key()).into_iter().flatten().any(|f| f == feature)
}

/// Returns the faces that a feature covers, in order of their indices. O(faces · log).
///
/// Empty for a feature that this map does not have.
///
/// ```
/// use twinedge_algorithm::claims::{faces_by_feature, faces_of};
/// use twinedge_map::{Builder, Shape};
///
/// let mut builder = Builder::new();
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let field = builder.shape(&Shape::polygon(square))?;
/// let path = builder.segment([0.0, 0.0], [1.0, 1.0])?;
/// let map = builder.build()?;
/// // The path cuts the field in two.
/// assert_eq!((faces_of(&map, field).len(), faces_of(&map, path).len()), (2, 0));
/// assert_eq!(faces_by_feature(&map), [faces_of(&map, field), vec![]]);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn faces_of(map: &PlanarMap, feature: FeatureId) -> Vec<FaceKey> {
    let covers = |f: &Face<'_>| map.features_of(f.key()).into_iter().flatten().any(|g| g == feature);
    map.dcel().faces().filter(covers).map(Face::key).collect()
}

/// Returns the faces that each feature covers, by [`FeatureId::index`]; empty for a feature that [leaks]. O(faces · log +
/// answer). [`faces_of`] has an example.
#[must_use]
pub fn faces_by_feature(map: &PlanarMap) -> Vec<Vec<FaceKey>> {
    let mut faces = vec![Vec::new(); map.features().count()];
    for face in map.dcel().faces() {
        for feature in features_of(map, face) {
            faces[feature.index()].push(face.key());
        }
    }
    faces
}

/// Returns the faces that more than one feature covers, in order of their indices. O(faces · log).
///
/// ```
/// use twinedge_algorithm::claims::overlaps;
/// use twinedge_map::{Builder, Shape};
///
/// // The upper half of the square is claimed again, by the triangle.
/// let mut builder = Builder::new();
/// let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// let triangle = [[0.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// builder.shape(&Shape::polygon(square))?;
/// builder.shape(&Shape::polygon(triangle))?;
/// assert_eq!(overlaps(&builder.build()?).len(), 1);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn overlaps(map: &PlanarMap) -> Vec<FaceKey> {
    map.dcel().faces().filter(|f| features_of(map, *f).nth(1).is_some()).map(Face::key).collect()
}
