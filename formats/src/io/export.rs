//! Features of a map, for the writers.

use twinedge::dcel::Face;
use twinedge_algorithm::contour;
use twinedge_algorithm::contour::ContourError;
use twinedge_algorithm::neighbours::chains;
use twinedge_map::{Feature, FeatureId, PlanarMap, Shape};

/// Returns the features of a map, in order, for a writer: the [contour](contour::of_feature) of each as polygons, and all its
/// edges off that contour as lines. The id is the [number](FeatureId::index). O(n log n).
///
/// A map built from these has the same features on the same faces, and the same edges and vertices, except isolated vertices and
/// edges without features, which [edits](twinedge_map::edit#features) may have made.
///
/// ```
/// use twinedge_formats::io;
/// use twinedge_map::{Builder, Shape};
///
/// let mut builder = Builder::new();
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// builder.shape(&Shape::polygon(square))?;
/// builder.segment([0.0, 0.0], [1.0, 1.0])?;
/// let map = builder.build()?;
/// let features = io::features(&map)?;
/// assert!(matches!(features[0].shapes[..], [Shape::Polygon(_)]));
/// assert!(matches!(features[1].shapes[..], [Shape::Line(_)]));
///
/// let mut again = Builder::new();
/// for feature in &features {
///     again.feature(feature)?;
/// }
/// assert_eq!(again.build()?.dcel().face_count(), map.dcel().face_count());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ContourError`], if the map is not plane or a feature covers the unbounded face.
pub fn features(map: &PlanarMap) -> Result<Vec<Feature>, ContourError> {
    let mut features: Vec<Feature> = contour::of_features(map)?.into_iter().map(Feature::from).collect();
    let mut lines = vec![Vec::new(); features.len()];
    for h in map.dcel().edges() {
        for feature in map.features_along(h.key())? {
            if covers(map, h.face(), feature) == covers(map, h.twin().face(), feature) {
                lines[feature.index()].push(h);
            }
        }
    }
    for ((feature, lines), id) in features.iter_mut().zip(lines).zip(map.features()) {
        feature.shapes.extend(chains(map, &lines).into_iter().map(Shape::Line));
        feature.name = map.name(id).map(str::to_owned);
        feature.id = Some(id.index().to_string());
    }
    Ok(features)
}

fn covers(map: &PlanarMap, face: Face<'_>, feature: FeatureId) -> bool {
    map.features_of(face.key()).into_iter().flatten().any(|f| f == feature)
}

/// Returns the bounded faces of a map, in order of their indices, for a writer: one polygon each. The id is the index; the name
/// joins the names of the covering features with slashes. O(n), expected.
///
/// ```
/// use twinedge_formats::io;
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
/// map.insert_ring([[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]])?;
/// // The ring around the hole, and the hole.
/// assert_eq!(io::faces(&map)?.len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ContourError`], if the map is not plane.
pub fn faces(map: &PlanarMap) -> Result<Vec<Feature>, ContourError> {
    let bounded = map.dcel().faces().filter(|f| !f.is_unbounded());
    bounded
        .map(|face| {
            let names: Vec<&str> = map.features_of(face.key())?.filter_map(|f| map.name(f)).collect();
            Ok(Feature {
                name: (!names.is_empty()).then(|| names.join(" / ")),
                id: Some(face.index().to_string()),
                shapes: vec![contour::of_face(map, face.key())?.into()],
            })
        })
        .collect()
}
