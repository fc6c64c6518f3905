//! The attributes that identify records across two maps.

use super::error::DiffError;
use super::record::Record;
use crate::PlanarMap;
use slotmap::{Key, KeyData, SecondaryMap};
use std::collections::BTreeMap;
use std::fmt;
use twinedge::dcel::extend::Kind;
use twinedge::dcel::{
    Attribute, Attributed, Edges, Face, FaceKey, Faces, HalfEdge, HalfEdgeKey, Value, VertexKey, Vertices,
};

type Get<V> = dyn Fn(&PlanarMap, KeyData) -> Option<V> + Send + Sync;
type Put<V> = dyn Fn(&mut PlanarMap, KeyData, Option<V>) -> bool + Send + Sync;

/// An attribute whose values are converted to and from another type.
pub(super) struct Column<V> {
    pub(super) name: String,
    pub(super) kind: Kind,
    is_of: Box<dyn Fn(&PlanarMap) -> bool + Send + Sync>,
    pub(super) get: Box<Get<V>>,
    /// Returns false if the value cannot be converted back, or the map has no such attribute.
    pub(super) put: Box<Put<V>>,
}

impl<V: 'static> Column<V> {
    fn new<K: Attributed, T: Value>(
        name: &str,
        of: Attribute<K, T>,
        show: impl Fn(&T) -> V + Send + Sync + 'static,
        read: impl Fn(V) -> Option<T> + Send + Sync + 'static,
    ) -> Self {
        Self {
            name: name.into(),
            kind: K::KIND,
            is_of: Box::new(move |map| map.values(of).is_some()),
            get: Box::new(move |map, key| map.value(of, key.into()).map(&show)),
            put: Box::new(move |map, key, value| match value.map(&read) {
                Some(None) => false,
                value => map.put_value(of, key.into(), value.flatten()).is_ok(),
            }),
        }
    }
}

/// The kinds of records whose values are compared.
pub trait Compared: Attributed {}

impl Compared for Vertices {}
impl Compared for Edges {}
impl Compared for Faces {}

/// The attributes that identify records across two maps, and the attributes whose values are compared.
///
/// Vertices and bounded faces have ids, for example from [`Policy::ids`](twinedge::dcel::Policy::ids). Edges need none.
pub struct Ids {
    pub(super) vertices: Column<u128>,
    pub(super) faces: Column<u128>,
    pub(super) values: Vec<Column<String>>,
}

impl Ids {
    /// Identifies vertices and faces by these ids: numbers of up to 128 bits, such as UUIDs.
    #[must_use]
    pub fn new<V, F>(vertices: Attribute<Vertices, V>, faces: Attribute<Faces, F>) -> Self
    where
        V: Value + Copy + Into<u128> + TryFrom<u128>,
        F: Value + Copy + Into<u128> + TryFrom<u128>,
    {
        Self {
            vertices: Column::new("", vertices, |id| (*id).into(), |id| id.try_into().ok()),
            faces: Column::new("", faces, |id| (*id).into(), |id| id.try_into().ok()),
            values: Vec::new(),
        }
    }

    /// Also compares the values of an attribute. A diff stores them as text, by `show` and `read`: equal texts are equal values.
    #[must_use]
    pub fn values<K: Compared, T: Value>(
        mut self,
        name: &str,
        of: Attribute<K, T>,
        show: impl Fn(&T) -> String + Send + Sync + 'static,
        read: impl Fn(&str) -> Option<T> + Send + Sync + 'static,
    ) -> Self {
        self.values.push(Column::new(name, of, show, move |text: String| read(&text)));
        self
    }
}

impl fmt::Debug for Ids {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.values.iter().map(|column| &column.name);
        f.debug_struct("Ids").field("values", &names.collect::<Vec<_>>()).finish_non_exhaustive()
    }
}

#[derive(Clone)]
pub(super) struct Index {
    pub(super) vertices: BTreeMap<u128, VertexKey>,
    /// The ids of both ends, smaller first: the half-edge that leaves the smaller end.
    pub(super) edges: BTreeMap<(u128, u128), HalfEdgeKey>,
    pub(super) faces: BTreeMap<u128, FaceKey>,
    pub(super) ids: SecondaryMap<VertexKey, u128>,
}

impl Index {
    pub(super) fn new(map: &PlanarMap, by: &Ids) -> Result<Self, DiffError> {
        map.plane()?;
        let has_values = by.values.iter().all(|column| (column.is_of)(map));
        if !((by.vertices.is_of)(map) && (by.faces.is_of)(map) && has_values) {
            return Err(DiffError::NoSuchAttribute);
        }
        let mut index = Self {
            vertices: BTreeMap::new(),
            edges: BTreeMap::new(),
            faces: BTreeMap::new(),
            ids: SecondaryMap::new(),
        };
        for v in map.dcel().vertices().map(|v| v.key()) {
            let id = (by.vertices.get)(map, v.data()).ok_or(DiffError::VertexWithoutId(v))?;
            index.ids.insert(v, id);
            if index.vertices.insert(id, v).is_some() {
                return Err(DiffError::SameId(Record::Vertex(id)));
            }
        }
        for f in map.dcel().faces().filter(|f| !f.is_unbounded()).map(Face::key) {
            let id = (by.faces.get)(map, f.data()).ok_or(DiffError::FaceWithoutId(f))?;
            if index.faces.insert(id, f).is_some() {
                return Err(DiffError::SameId(Record::Face(id)));
            }
        }
        for h in map.dcel().edges() {
            index.put_edge(h);
        }
        Ok(index)
    }

    pub(super) fn ends(&self, h: HalfEdge<'_>) -> (u128, u128) {
        let id = |v: VertexKey| self.ids.get(v).copied().unwrap_or_default();
        (id(h.origin().key()), id(h.target().key()))
    }

    pub(super) fn edge(&self, h: HalfEdge<'_>) -> Record {
        let (a, b) = self.ends(h);
        Record::Edge(a.min(b), a.max(b))
    }

    pub(super) fn put_edge(&mut self, h: HalfEdge<'_>) {
        let (a, b) = self.ends(h);
        let (ends, h) = if a < b { ((a, b), h) } else { ((b, a), h.twin()) };
        self.edges.insert(ends, h.key());
    }

    pub(super) fn half_edge<'a>(&self, map: &'a PlanarMap, from: u128, to: u128) -> Option<HalfEdge<'a>> {
        let h = map.dcel().half_edge(*self.edges.get(&(from.min(to), from.max(to)))?).ok()?;
        Some(if from < to { h } else { h.twin() })
    }

    /// Returns the vertices around a face, starting at the smallest pair of neighbours.
    pub(super) fn outline(&self, face: Face<'_>) -> Vec<u128> {
        let cycle: Vec<_> = face.outer().into_iter().flat_map(|b| b.half_edges()).map(|h| self.ends(h)).collect();
        let first = (0..cycle.len()).min_by_key(|i| cycle[*i]).unwrap_or_default();
        cycle[first..].iter().chain(&cycle[..first]).map(|(from, _)| *from).collect()
    }

    pub(super) fn key(&self, map: &PlanarMap, record: Record) -> Option<KeyData> {
        Some(match record {
            Record::Vertex(v) => self.vertices.get(&v)?.data(),
            Record::Edge(a, b) => self.edges.get(&(a, b))?.data(),
            Record::Face(f) => self.faces.get(&f)?.data(),
            Record::Unbounded => map.dcel().unbounded_face().key().data(),
            Record::Feature(number) => map.present(map.feature(number)?).ok()?.data(),
        })
    }

    /// Returns all records except features.
    pub(super) fn records(&self) -> impl Iterator<Item = Record> {
        let vertices = self.vertices.keys().map(|v| Record::Vertex(*v));
        let edges = self.edges.keys().map(|(a, b)| Record::Edge(*a, *b));
        let faces = self.faces.keys().map(|f| Record::Face(*f));
        vertices.chain(edges).chain(faces).chain([Record::Unbounded])
    }

    pub(super) fn features(&self, map: &PlanarMap, record: Record) -> Vec<usize> {
        let Some(key) = self.key(map, record) else { return Vec::new() };
        let set = match record {
            Record::Vertex(_) | Record::Feature(_) => return Vec::new(),
            Record::Edge(..) => map.features_along(key.into()).map(|all| all.map(|f| f.index()).collect()),
            Record::Face(_) | Record::Unbounded => {
                map.features_of(key.into()).map(|all| all.map(|f| f.index()).collect())
            }
        };
        set.unwrap_or_default()
    }
}
