//! A structure with coordinates of its own.

use std::collections::BTreeMap;
use twinedge::dcel::Face;
use twinedge::delegate_view;
use twinedge::validate::{BoundaryPlace, BoundaryRow, Collect, Expectation, Report, Table, View};
use twinedge_geometry::Point;
use twinedge_map::{Builder, Embedding, PlanarMap};

/// The validator of embeddings through a pointer, so that it is compiled once.
pub(crate) fn validate_embedding(embedding: &dyn Embedding, expectation: &Expectation, collect: Collect) -> Report {
    twinedge_map::validate_embedding(embedding, expectation, collect)
}

/// A structure, and the points of its vertices and bends.
#[derive(Clone)]
pub(crate) struct Drawn<S = Table> {
    pub(crate) structure: S,
    pub(crate) points: Vec<Point>,
    /// For the half-edge with the smaller index, in its direction.
    pub(crate) bends: BTreeMap<usize, Vec<Point>>,
}

impl<S: View> View for Drawn<S> {
    delegate_view!(|this| &this.structure);
}

impl<S: View> Embedding for Drawn<S> {
    fn point(&self, vertex: usize) -> Point {
        self.points.get(vertex).copied().unwrap_or_default()
    }

    fn bends(&self, half_edge: usize) -> usize {
        let is_asked = self.bends.is_empty() || self.twin(half_edge).is_none_or(|t| half_edge < t);
        assert!(is_asked, "half-edge {half_edge} is not the one to be asked");
        self.bends.get(&half_edge).map_or(0, Vec::len)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        self.bends[&half_edge][bend]
    }
}

impl<S: View> Drawn<S> {
    /// Without bends.
    pub(crate) fn new(structure: S, points: impl IntoIterator<Item = impl Into<Point>>) -> Self {
        Self { structure, points: points.into_iter().map(Into::into).collect(), bends: BTreeMap::new() }
    }

    pub(crate) fn report(&self, expectation: &Expectation) -> Report {
        validate_embedding(self, expectation, Collect::All)
    }
}

impl Drawn {
    /// The table and the points of a map.
    pub(crate) fn of(map: &PlanarMap) -> Self {
        Self::new(Table::copy_of(map).expect("a small map fits"), points_of(map))
    }
}

/// Two segments that cross.
pub(crate) fn crossing() -> PlanarMap {
    let mut map = Builder::new();
    map.segment([0.0, 0.0], [2.0, 2.0]).expect("in range");
    map.segment([0.0, 2.0], [2.0, 0.0]).expect("in range");
    map.build().expect("a small map fits")
}

/// The point of each vertex slot.
pub(crate) fn points_of(map: &PlanarMap) -> Vec<Point> {
    (0..map.vertex_slots()).map(|v| map.point(v)).collect()
}

/// Moves an inner boundary component to the end of this face's list. All rules from R1 to F2 hold.
pub(crate) fn moved_inner(table: &Table, b: usize, f: usize) -> Option<Table> {
    let mut table = table.clone();
    let row = table.boundaries.get(b).copied().flatten()?;
    let (BoundaryPlace::Inner(i), true) = (row.place?, table.is_face(f)) else { return None };
    let list = &mut table.faces[row.face?].as_mut()?.inner;
    list.remove(i);
    for (i, b) in list.clone().into_iter().enumerate().skip(i) {
        table.boundaries[b?].as_mut()?.place = Some(BoundaryPlace::Inner(i));
    }
    let list = &mut table.faces[f].as_mut()?.inner;
    list.push(Some(b));
    let place = Some(BoundaryPlace::Inner(list.len() - 1));
    *table.boundaries[b].as_mut()? = BoundaryRow { face: Some(f), place, ..row };
    Some(table)
}

/// The area of a face: of the unbounded one, minus that of all others.
pub(crate) fn area(map: &PlanarMap, face: Face<'_>) -> f64 {
    let at = |v: twinedge::dcel::Vertex<'_>| map.position(v.key()).expect("of this map");
    let twice: f64 =
        face.half_edges().map(|h| (at(h.origin()), at(h.target()))).map(|(p, q)| p.x * q.y - q.x * p.y).sum();
    twice / 2.0
}
