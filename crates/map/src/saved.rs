//! Saving and loading maps with serde.

use super::feature_sets::FeatureSets;
use super::feature_tries::SetId;
use super::planar_map::PlanarMap;
use super::summary::BuildSummary;
use crate::FeatureId;
use rustc_hash::FxHashMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de, ser};
use thiserror::Error;
use twinedge::dcel::Dcel;
use twinedge::validate::Report;
use twinedge_geometry::Point;
use twinedge_geometry::noding::NodingSummary;

/// The version number of the written form.
const FORM: u8 = 1;

/// The saved form of a map: its live records in order of their indices.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SavedMap<D> {
    form: u8,
    dcel: D,
    points: Vec<Point>,
    names: Vec<Option<String>>,
    /// Each set of features in use, in ascending order.
    sets: Vec<Vec<u32>>,
    faces: Vec<usize>,
    /// The set that runs along each edge.
    edges: Vec<usize>,
    summary: BuildSummary,
    noding: Option<NodingSummary>,
    /// The removed features, in ascending order.
    #[serde(default)]
    removed: Vec<u32>,
}

#[derive(Debug, Error)]
enum LoadError {
    #[error("form {0} of a map is not known")]
    Form(u8),
    #[error("there are {found} entries for {count} {what}")]
    Count { what: &'static str, found: usize, count: usize },
    #[error("set {0} of features is not sorted, or has a feature that the map does not have")]
    BadSet(usize),
    #[error("feature {0} cannot have been removed: it has a name, or is none of the map")]
    Removed(u32),
    #[error("there is no set {0} of features")]
    NoSuchSet(usize),
    #[error("the map is not valid:\n{0}")]
    Invalid(Box<Report>),
}

/// Saves the keys, so that data saved alongside by key still refers to the same records; edges without features and isolated
/// vertices; names and features; the summaries. O(n).
///
/// Values of [attributes](PlanarMap#attributes) are saved separately: see the second example.
///
/// Only plane maps can be saved ([`PlanarMap::is_plane`]). The index of [`locate`](PlanarMap::locate) is not saved: reading it
/// from JSON would take as long as building it.
///
/// ```
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
/// let garden = map.add_feature(Some("garden".into()));
/// map.set_features_of(ring.faces_split[0].1, [garden])?;
///
/// let text = serde_json::to_string(&map)?;
/// let again: PlanarMap = serde_json::from_str(&text)?;
/// assert_eq!(again.position(ring.vertices[1])?, [4.0, 0.0].into());
/// assert!(again.features_of(ring.faces_split[0].1)?.eq([garden]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Ids and owners are saved as maps of keys, and ids continue from their last number:
///
/// ```
/// use twinedge::dcel::{FaceKey, Faces, Policy, SecondaryMap};
/// use twinedge_map::PlanarMap;
///
/// let owners = || Policy::<Faces, String>::of_faces().split_copy().merge_equal();
/// let mut map = PlanarMap::new();
/// let (id, owner) = (map.add_attribute(Policy::of_faces().ids(1)), map.add_attribute(owners()));
/// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
/// map.set_value(owner, ring.faces_split[0].1, "Ada")?;
/// let saved = serde_json::to_string(&(&map, map.next_id(id), map.values(id), map.values(owner)))?;
///
/// type Values<T> = SecondaryMap<FaceKey, T>;
/// let (mut map, next, ids, names): (PlanarMap, u64, Values<u64>, Values<String>) = serde_json::from_str(&saved)?;
/// let id = map.add_attribute_with(Policy::of_faces().ids(next), ids);
/// let owner = map.add_attribute_with(owners(), names);
/// let parcel = map.find(id, &1).unwrap();
/// assert_eq!((map.value(owner, parcel).map(String::as_str), map.next_id(id)), (Some("Ada"), Some(2)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl Serialize for PlanarMap {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if !self.is_plane() {
            return Err(ser::Error::custom("a map that is not plane cannot be saved"));
        }
        let mut sets = Vec::new();
        let mut numbers: FxHashMap<SetId, usize> = FxHashMap::default();
        let mut number = |set: SetId| {
            *numbers.entry(set).or_insert_with(|| {
                sets.push(self.features.set(set).map(FeatureId::number).collect());
                sets.len() - 1
            })
        };
        let faces = self.dcel.faces().map(|f| number(self.features.of_face(f.index()))).collect();
        let edges = self.dcel.edges().map(|h| number(self.features.along(h.index()))).collect();
        let saved = SavedMap {
            form: FORM,
            dcel: &self.dcel,
            points: self.dcel.vertices().map(|v| self.points[v.index()]).collect(),
            names: self.names.clone(),
            sets,
            faces,
            edges,
            summary: self.summary.clone(),
            noding: self.noding,
            removed: self.features.removed.iter().map(|feature| feature.number()).collect(),
        };
        saved.serialize(serializer)
    }
}

/// Validates the map, R1 … G5: an invalid or non-plane map is an error that contains the report. O(n log n).
impl<'de> Deserialize<'de> for PlanarMap {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        SavedMap::<Dcel>::deserialize(deserializer)?.load().map_err(de::Error::custom)
    }
}

impl SavedMap<Dcel> {
    fn load(self) -> Result<PlanarMap, LoadError> {
        let Self { form, dcel, points: saved_points, names, sets, faces, edges, summary, noding, removed } = self;
        if form != FORM {
            return Err(LoadError::Form(form));
        }
        let counts = [
            ("vertices", saved_points.len(), dcel.vertex_count()),
            ("faces", faces.len(), dcel.face_count()),
            ("edges", edges.len(), dcel.edge_count()),
        ];
        if let Some((what, found, count)) = counts.into_iter().find(|(_, found, count)| found != count) {
            return Err(LoadError::Count { what, found, count });
        }
        let mut points = vec![Point::default(); dcel.vertices().last().map_or(0, |v| v.index() + 1)];
        for (vertex, Point { x, y }) in dcel.vertices().zip(saved_points) {
            // Adding zero turns −0 into 0.
            points[vertex.index()] = Point::new(x + 0.0, y + 0.0);
        }
        let mut features = FeatureSets::default();
        let mut numbers = Vec::with_capacity(sets.len());
        for (i, set) in sets.iter().enumerate() {
            let sorted = set.is_sorted_by(|a, b| a < b);
            let known = set.last().is_none_or(|last| (*last as usize) < names.len());
            if !(sorted && known) {
                return Err(LoadError::BadSet(i));
            }
            numbers.push(features.number(set.iter().copied().map(FeatureId::new)));
        }
        let has_no_name = |removed: &u32| names.get(*removed as usize).is_some_and(Option::is_none);
        if let Some(wrong) = removed.iter().find(|removed| !has_no_name(removed)) {
            return Err(LoadError::Removed(*wrong));
        }
        if let Some(i) = sets.iter().position(|set| set.iter().any(|feature| removed.contains(feature))) {
            return Err(LoadError::BadSet(i));
        }
        features.removed = removed.into_iter().map(FeatureId::new).collect();
        let set = |number: usize| numbers.get(number).copied().ok_or(LoadError::NoSuchSet(number));
        for (face, number) in dcel.faces().zip(faces) {
            features.put_face(face.index(), set(number)?);
        }
        for (edge, number) in dcel.edges().zip(edges) {
            features.put_along(edge.index(), set(number)?);
        }
        let map = PlanarMap { dcel, points, names, features, summary, noding, ..PlanarMap::default() };
        let report = map.validate();
        if report.is_valid() { Ok(map) } else { Err(LoadError::Invalid(Box::new(report))) }
    }
}
