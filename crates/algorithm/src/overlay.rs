//! Overlaying two maps: one map in which each face knows its face in both.
//!
//! ```text
//!   ┌───────┐                       ┌───────┐
//!   │   a   │     ┌───────┐         │ a,–┌──┼────┐        each face of the result lies
//!   │       │  +  │   b   │   =>    │    │ab│    │        in one face of the left map
//!   └───────┘     │       │         └────┼──┘ –,b│        and in one face of the right map
//!                 └───────┘              └───────┘
//! ```
//!
//! The edges of both are [noded](twinedge_geometry::noding) together. A face of either map becomes the area that its rounded
//! boundary encloses by parity. Snap rounding never moves a vertex across an edge, so together these areas still cover the plane
//! once: faces thinner than a cell may vanish, but no face of the result lies in two faces of one map.
//!
//! Source for the idea, with a sweep instead of rounding: de Berg et al., "Computational Geometry", 3rd edition, section 2.3.

use std::collections::HashMap;
use thiserror::Error;
use twinedge::dcel::{Boundary, Face, FaceKey, HalfEdgeKey, OperatorError, StaleKey, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{BuildError, Builder, Feature, FeatureId, Noding, NotPlane, PlanarMap, Shape};

/// One of the two maps of an overlay.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operand {
    /// The first.
    Left,
    /// The second.
    Right,
}

impl std::fmt::Display for Operand {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Left => "left",
            Self::Right => "right",
        })
    }
}

/// The error of [`overlay`].
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OverlayError {
    /// The edges of one map meet other than at shared endpoints, so its faces are undefined.
    #[error("the {0} one: {1}")]
    NotPlane(Operand, NotPlane),
    /// The edges cannot be noded on this grid, or there is no room.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// The policy of an attribute refuses to split or drop a face.
    #[error(transparent)]
    Attribute(#[from] OperatorError),
}

/// A choice among the faces covered by two features.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// Covered by either.
    Union,
    /// Covered by both.
    Intersection,
    /// Covered by the left map's feature but not by the right map's.
    Difference,
    /// Covered by exactly one of them.
    SymmetricDifference,
}

impl Operation {
    const fn keeps(self, left: bool, right: bool) -> bool {
        match self {
            Self::Union => left || right,
            Self::Intersection => left && right,
            Self::Difference => left && !right,
            Self::SymmetricDifference => left != right,
        }
    }
}

/// The overlay of two maps.
///
/// Its features are the features of the left map followed by the features of the right map, in their orders.
#[derive(Clone, Debug)]
pub struct Overlay {
    map: PlanarMap,
    /// For each face, its face in the left map and in the right.
    faces: Vec<[FaceKey; 2]>,
    /// By [`FeatureId::index`] in the left and in the right map.
    features: [Vec<FeatureId>; 2],
}

impl Overlay {
    /// Returns the map. [`overlay`] has an example.
    #[must_use]
    pub const fn map(&self) -> &PlanarMap {
        &self.map
    }

    /// Converts the overlay into its map.
    #[must_use]
    pub fn into_map(self) -> PlanarMap {
        self.map
    }

    /// Returns the face of one of the maps that contains a face of the overlay. O(1).
    ///
    /// ```
    /// use twinedge_algorithm::overlay::{Operand, overlay};
    /// use twinedge_geometry::noding::Snap;
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut left = PlanarMap::new();
    /// let (_, inside) = left.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?.faces_split[0];
    /// let mut right = PlanarMap::new();
    /// right.insert_segment([1.0, -1.0], [1.0, 5.0])?;
    /// // The segment of the right map cuts the triangle of the left one in two.
    /// let both = overlay(&left, &right, Snap::Size(0.5))?;
    /// let faces = both.map().dcel().faces().filter(|f| both.face_in(Operand::Left, f.key()) == Ok(inside));
    /// assert_eq!(faces.count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`StaleKey::Face`].
    pub fn face_in(&self, operand: Operand, face: FaceKey) -> Result<FaceKey, StaleKey> {
        let index = self.map.dcel().face(face)?.index();
        let faces = self.faces.get(index).ok_or(StaleKey::Face(face))?;
        Ok(faces[operand as usize])
    }

    /// Returns the feature of the overlay for a feature of one of the maps; `None` if that map has no such feature. O(1).
    #[must_use]
    pub fn feature_of(&self, operand: Operand, feature: FeatureId) -> Option<FeatureId> {
        self.features[operand as usize].get(feature.index()).copied()
    }

    /// Returns the faces of an operation on two features, one of each map. Absent ones cover nothing. O(faces + features).
    ///
    /// [`contour::of_faces`](super::contour::of_faces) converts them to polygons.
    pub fn faces(&self, operation: Operation, left: FeatureId, right: FeatureId) -> impl Iterator<Item = FaceKey> + '_ {
        let features = [self.feature_of(Operand::Left, left), self.feature_of(Operand::Right, right)];
        self.map.dcel().faces().map(Face::key).filter(move |face| {
            let covers = |feature: Option<FeatureId>| {
                self.map.features_of(*face).into_iter().flatten().any(|of_face| Some(of_face) == feature)
            };
            operation.keeps(covers(features[0]), covers(features[1]))
        })
    }
}

/// Lays two maps over each other, on a grid. Their [attributes](PlanarMap::carry_parts) of faces and features are carried over.
///
/// O((n + k) log n) for n edges that meet k times, plus the total size of the contents of all faces, holes included.
///
/// ```
/// use twinedge_algorithm::area::face_area;
/// use twinedge_algorithm::overlay::{Operation, overlay};
/// use twinedge_geometry::noding::Snap;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |low: f64, high: f64| {
///     let ring = [[low, low], [high, low], [high, high], [low, high]];
///     let mut builder = Builder::new();
///     let feature = builder.shape(&Shape::polygon(ring))?;
///     Ok::<_, twinedge_map::BuildError>((builder.build()?, feature))
/// };
/// let ((left, a), (right, b)) = (square(0.0, 3.0)?, square(2.0, 6.0)?);
/// let both = overlay(&left, &right, Snap::Auto)?;
/// let area = |operation| both.faces(operation, a, b).map(|f| face_area(both.map(), f).unwrap()).sum::<f64>();
/// assert_eq!(area(Operation::Union), 24.0);
/// assert_eq!(area(Operation::Intersection), 1.0);
/// assert_eq!(area(Operation::Difference), 8.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`OverlayError`].
pub fn overlay(left: &PlanarMap, right: &PlanarMap, snap: Snap) -> Result<Overlay, OverlayError> {
    let operands = [(Operand::Left, left), (Operand::Right, right)];
    for (operand, map) in operands {
        map.plane().map_err(|why| OverlayError::NotPlane(operand, why))?;
    }
    let mut builder = Builder::new();
    let mut meanings = Vec::new();
    for (operand, map) in operands {
        gather(operand, map, &mut builder, &mut meanings)?;
    }
    let mut noded = builder.build_with(Noding::Snap(snap))?;
    let labels = Labels::read(&noded, &meanings, operands.map(|(_, map)| map.dcel().unbounded_face().key()));

    noded.forget_features();
    let features = operands.map(|(_, map)| {
        let names = map.features().map(|feature| map.name(feature).map(str::to_owned));
        names.map(|name| noded.add_feature(name)).collect::<Vec<_>>()
    });
    let mut both = Overlay { map: noded, faces: labels.faces, features };
    both.put_features(operands.map(|(_, map)| map), &labels.edges, &meanings);
    for (operand, map) in operands {
        let within = |face: Face<'_>| both.faces.get(face.index()).map(|of| of[operand as usize]);
        let features = &both.features[operand as usize];
        both.map.carry_parts(map, within, |feature| features.get(feature.index()).copied())?;
    }
    Ok(both)
}

#[derive(Clone, Debug)]
enum Meaning {
    Face(Operand, FaceKey),
    /// Edges along which certain features of one of the maps run.
    Along(Operand, Vec<FeatureId>),
    /// Edges and vertices that only need to exist.
    Nothing,
}

/// Adds the faces and edges of a map to the builder, as features, and records the meaning of each.
fn gather(
    operand: Operand,
    map: &PlanarMap,
    builder: &mut Builder,
    meanings: &mut Vec<Meaning>,
) -> Result<(), BuildError> {
    let at = |v: Vertex<'_>| map.position(v.key()).unwrap_or_default();
    let ring = |b: Boundary<'_>| -> Vec<Point> { b.half_edges().map(|h| at(h.origin())).collect() };
    let mut take = |shapes: Vec<Shape>, meaning: Meaning| {
        builder.feature(&Feature { shapes, ..Feature::default() })?;
        meanings.push(meaning);
        Ok::<_, BuildError>(())
    };
    for face in map.dcel().faces().filter(|face| !face.is_unbounded()) {
        let rings = face.boundaries().map(ring).filter(|ring| !ring.is_empty()).collect();
        take(vec![Shape::Polygon(rings)], Meaning::Face(operand, face.key()))?;
    }
    // Edges by the features along them; edges without features are included, since they may bound no face.
    let mut along: HashMap<Vec<FeatureId>, Vec<Shape>> = HashMap::new();
    let mut sets = Vec::new();
    for h in map.dcel().edges() {
        let set: Vec<FeatureId> = map.features_along(h.key()).into_iter().flatten().collect();
        let line = Shape::Line(vec![at(h.origin()), at(h.target())]);
        along
            .entry(set)
            .or_insert_with_key(|set| {
                sets.push(set.clone());
                Vec::new()
            })
            .push(line);
    }
    for set in sets {
        let lines = along.remove(&set).unwrap_or_default();
        take(lines, Meaning::Along(operand, set))?;
    }
    let alone = map.dcel().vertices().filter(|v| v.isolated().is_some());
    take(alone.map(|v| Shape::Point(at(v))).collect(), Meaning::Nothing)
}

/// The origins of the overlay's faces and edges in the two maps.
struct Labels {
    /// For each face, its face in the left map and in the right.
    faces: Vec<[FaceKey; 2]>,
    /// Edges with the builder's features along them.
    edges: Vec<(HalfEdgeKey, Vec<usize>)>,
}

impl Labels {
    fn read(noded: &PlanarMap, meanings: &[Meaning], unbounded: [FaceKey; 2]) -> Self {
        let dcel = noded.dcel();
        let end = dcel.faces().map(Face::index).max().map_or(0, |last| last + 1);
        let mut faces = vec![unbounded; end];
        for face in dcel.faces() {
            for feature in noded.features_of(face.key()).into_iter().flatten() {
                if let Some(Meaning::Face(operand, key)) = meanings.get(feature.index()) {
                    faces[face.index()][*operand as usize] = *key;
                }
            }
        }
        let along = |h| noded.features_along(h).into_iter().flatten().map(FeatureId::index).collect();
        Self { faces, edges: dcel.edges().map(|h| (h.key(), along(h.key()))).collect() }
    }
}

impl Overlay {
    /// Assigns to each face and edge its features in both maps. All keys and features belong to this map, so none is refused.
    fn put_features(&mut self, maps: [&PlanarMap; 2], edges: &[(HalfEdgeKey, Vec<usize>)], meanings: &[Meaning]) {
        let faces: Vec<_> = self.map.dcel().faces().map(|face| (face.key(), face.index())).collect();
        for (face, index) in faces {
            let mut set = Vec::new();
            for ((map, of), features) in maps.into_iter().zip(self.faces[index]).zip(&self.features) {
                let here = map.features_of(of).into_iter().flatten();
                set.extend(here.filter_map(|feature| features.get(feature.index())));
            }
            let _never_refused = self.map.set_features_of(face, set);
        }
        for (h, along) in edges {
            let mut set = Vec::new();
            for meaning in along {
                if let Some(Meaning::Along(operand, features)) = meanings.get(*meaning) {
                    set.extend(features.iter().filter_map(|f| self.features[*operand as usize].get(f.index())));
                }
            }
            let _never_refused = self.map.set_features_along(*h, set);
        }
    }
}
