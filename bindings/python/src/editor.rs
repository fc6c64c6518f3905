//! A map to edit: changes with undo and redo, each validated.

use crate::attributes::{Column, Raised, add};
use crate::maps::{Map, Polygons, of_faces};
use pyo3::exceptions::{PyKeyError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use slotmap::KeyData;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::{mem, thread};
use twinedge::dcel::{Face, HalfEdge, History, OperatorError, StaleKey, Vertex};
use twinedge::validate::Expectation;
use twinedge_algorithm::area::face_area;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::edit::{At, EditError, Edited};
use twinedge_map::near::{EmbeddingBaseline, validate_embedding_near};
use twinedge_map::{FeatureId, Located, PlanarMap};

/// A map with a history, and attributes by name.
#[pyclass(name = "Editor", module = "twinedge._twinedge")]
pub(crate) struct Editor {
    /// None while a change runs.
    history: Option<History<PlanarMap>>,
    /// The map while a change runs.
    open: Option<PlanarMap>,
    baseline: EmbeddingBaseline,
    attributes: BTreeMap<String, Box<dyn Column>>,
    raised: Raised,
}

/// A point, or a vertex by its key.
#[derive(FromPyObject)]
enum Place {
    Vertex(u64),
    Point([f64; 2]),
}

impl From<Place> for At {
    fn from(place: Place) -> Self {
        match place {
            Place::Vertex(key) => Self::Vertex(KeyData::from_ffi(key).into()),
            Place::Point(point) => Self::Point(point.into()),
        }
    }
}

/// The lists of [`Edited`] that Python has, in the order of its `Edited`.
type Lists =
    (Vec<u64>, Vec<u64>, Vec<u64>, Vec<u64>, Vec<(u64, u64)>, Vec<u64>, Vec<u64>, Vec<(u64, u64)>, Vec<(u64, u64)>);

fn key(key: impl slotmap::Key) -> u64 {
    key.data().as_ffi()
}

fn lists(edited: Edited) -> Lists {
    fn keys<K: slotmap::Key>(all: Vec<K>) -> Vec<u64> {
        all.into_iter().map(key).collect()
    }
    fn pairs<K: slotmap::Key>(all: Vec<(K, K)>) -> Vec<(u64, u64)> {
        all.into_iter().map(|(a, b)| (key(a), key(b))).collect()
    }
    (
        keys(edited.vertices),
        keys(edited.way),
        keys(edited.vertices_made),
        keys(edited.vertices_dropped),
        pairs(edited.edges_split),
        keys(edited.edges_made),
        keys(edited.edges_dropped),
        pairs(edited.faces_split),
        pairs(edited.faces_merged),
    )
}

fn stale(error: StaleKey) -> PyErr {
    PyKeyError::new_err(in_keys_of_python(&error.to_string()))
}

/// Rewrites a message of the library: `VertexKey(3v1)` becomes `vertex 4294967299`, as keys are integers in
/// Python.
fn in_keys_of_python(message: &str) -> String {
    let mut told = message.to_owned();
    for (debug, word) in [
        ("VertexKey(", "vertex"),
        ("HalfEdgeKey(", "half-edge"),
        ("BoundaryKey(", "boundary component"),
        ("FaceKey(", "face"),
    ] {
        while let Some(at) = told.find(debug) {
            let rest = &told[at + debug.len()..];
            let Some((number, end)) = rest.split_once(')').and_then(|(key, _)| Some((integer(key)?, key.len() + 1)))
            else {
                break;
            };
            told.replace_range(at..at + debug.len() + end, &format!("{word} {number}"));
        }
    }
    told
}

/// Returns the integer of a key, from its debug form: index, `v`, version.
fn integer(key: &str) -> Option<u64> {
    let (index, version) = key.split_once('v')?;
    Some(version.parse::<u64>().ok()? << 32 | index.parse::<u64>().ok()?)
}

impl Editor {
    fn begin(map: PlanarMap) -> PyResult<Self> {
        let baseline = EmbeddingBaseline::new(&map, &Expectation::plane());
        Ok(Self {
            baseline: baseline.map_err(|error| PyRuntimeError::new_err(error.to_string()))?,
            history: Some(History::new(map)),
            open: None,
            attributes: BTreeMap::new(),
            raised: Raised::default(),
        })
    }

    fn map(&self) -> PyResult<&PlanarMap> {
        self.open.as_ref().or(self.history.as_ref().map(History::get)).ok_or_else(busy)
    }

    fn history(&mut self) -> PyResult<&mut History<PlanarMap>> {
        self.history.as_mut().ok_or_else(busy)
    }

    /// Returns the exception for a refused edit: the policy's exception, if it raised one.
    fn failed(&self, error: EditError) -> PyErr {
        let raised = self.raised.lock().ok().and_then(|mut raised| raised.take());
        raised.unwrap_or_else(|| match error {
            EditError::Operator(OperatorError::Stale(error)) => stale(error),
            error => PyValueError::new_err(in_keys_of_python(&error.to_string())),
        })
    }

    /// Does an edit, as a part of the running change or as a change of its own.
    fn edit<T>(
        &mut self,
        name: &'static str,
        edit: impl FnOnce(&mut PlanarMap) -> Result<T, EditError>,
    ) -> PyResult<T> {
        let is_part = self.open.is_some();
        let done = match &mut self.open {
            Some(map) => edit(map),
            None => self.history()?.change(name, edit),
        };
        let done = done.map_err(|error| self.failed(error))?;
        if !is_part {
            self.validate_near()?;
        }
        Ok(done)
    }

    /// Validates the records that the last change wrote.
    fn validate_near(&mut self) -> PyResult<()> {
        let history = self.history.as_ref().ok_or_else(busy)?;
        let found = validate_embedding_near(&mut self.baseline, history.get(), &history.written());
        found.map(drop).map_err(|report| PyRuntimeError::new_err(report.to_string()))
    }

    fn column(&self, name: &str) -> PyResult<&dyn Column> {
        let column = self.attributes.get(name);
        column.map(|column| &**column).ok_or_else(|| PyKeyError::new_err(format!("there is no attribute {name:?}")))
    }
}

fn busy() -> PyErr {
    PyRuntimeError::new_err("a change is being made")
}

/// Returns the editor once no other thread holds it.
fn claimed<'py>(editor: &Bound<'py, Editor>) -> PyRefMut<'py, Editor> {
    loop {
        match editor.try_borrow_mut() {
            Ok(editor) => return editor,
            Err(_) => editor.py().detach(thread::yield_now),
        }
    }
}

#[pymethods]
impl Editor {
    #[new]
    fn new() -> PyResult<Self> {
        Self::begin(PlanarMap::new())
    }

    /// Makes an editor of a copy of a map.
    #[staticmethod]
    fn of(map: &Map) -> PyResult<Self> {
        Self::begin(map.plane()?.clone())
    }

    /// Adds an attribute.
    fn attribute(
        &mut self,
        name: String,
        of: &str,
        split: Bound<'_, PyAny>,
        merge: Bound<'_, PyAny>,
        ids: Option<u64>,
    ) -> PyResult<()> {
        if self.attributes.contains_key(&name) {
            return Err(PyValueError::new_err(format!("there is an attribute {name:?}")));
        }
        let raised = self.raised.clone();
        let history = self.history.take().ok_or_else(busy)?;
        // The map's history begins anew, as its changes know nothing of the attribute.
        if history.undo_name().is_some() || history.redo_name().is_some() {
            self.history = Some(history);
            return Err(PyValueError::new_err("attributes are added before the first change"));
        }
        let mut map = history.into_inner();
        let added = add(&mut map, of, &split, &merge, ids, raised);
        self.history = Some(History::new(map));
        self.attributes.insert(name, added?);
        Ok(())
    }

    /// Runs a function as one change.
    fn change(slf: &Bound<'_, Self>, name: String, change: Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        let mut history = slf.try_borrow_mut()?.history.take().ok_or_else(busy)?;
        let outcome = history.change(Cow::Owned(name), |map| {
            claimed(slf).open = Some(mem::take(map));
            let outcome = change.call0();
            if let Some(open) = claimed(slf).open.take() {
                *map = open;
            }
            outcome
        });
        let mut editor = claimed(slf);
        editor.history = Some(history);
        let outcome = outcome?;
        editor.validate_near()?;
        Ok(outcome.unbind())
    }

    fn undo(&mut self) -> PyResult<bool> {
        let done = self.history()?.undo();
        self.validate_near()?;
        Ok(done)
    }

    fn redo(&mut self) -> PyResult<bool> {
        let done = self.history()?.redo();
        self.validate_near()?;
        Ok(done)
    }

    fn undo_name(&self) -> Option<&str> {
        self.history.as_ref()?.undo_name()
    }

    fn redo_name(&self) -> Option<&str> {
        self.history.as_ref()?.redo_name()
    }

    fn insert_point(&mut self, at: Place) -> PyResult<Lists> {
        self.edit("insert a point", |map| map.insert_point(at)).map(lists)
    }

    fn insert_segment(&mut self, start: Place, end: Place) -> PyResult<Lists> {
        self.edit("insert a segment", |map| map.insert_segment(start, end)).map(lists)
    }

    /// A `cell` of 0 chooses the grid.
    fn insert_segment_snapped(&mut self, start: Place, end: Place, cell: f64) -> PyResult<Lists> {
        let snap = if cell == 0.0 { Snap::Auto } else { Snap::Size(cell) };
        self.edit("insert a segment", |map| map.insert_segment_snapped(start, end, snap)).map(lists)
    }

    fn insert_ring(&mut self, points: Vec<Place>) -> PyResult<Lists> {
        self.edit("insert a ring", |map| map.insert_ring(points)).map(lists)
    }

    fn remove_edge(&mut self, half_edge: u64) -> PyResult<Lists> {
        self.edit("remove an edge", |map| map.remove_edge(KeyData::from_ffi(half_edge).into())).map(lists)
    }

    fn remove_vertex(&mut self, vertex: u64) -> PyResult<Lists> {
        self.edit("remove a vertex", |map| map.remove_vertex(KeyData::from_ffi(vertex).into())).map(lists)
    }

    fn move_vertex(&mut self, vertex: u64, to: [f64; 2]) -> PyResult<()> {
        self.edit("move a vertex", |map| map.move_vertex(KeyData::from_ffi(vertex).into(), to))
    }

    /// Sets or removes the value of a record.
    fn set(&mut self, name: &str, of: u64, value: Option<Bound<'_, PyAny>>) -> PyResult<()> {
        let set = self.column(name)?.setting(of, value)?;
        self.edit("set a value", set)
    }

    fn get(&self, py: Python<'_>, name: &str, of: u64) -> PyResult<Option<Py<PyAny>>> {
        self.column(name)?.get(py, self.map()?, of)
    }

    fn values(&self, py: Python<'_>, name: &str) -> PyResult<Vec<(u64, Py<PyAny>)>> {
        self.column(name)?.all(py, self.map()?)
    }

    fn find(&self, name: &str, value: Bound<'_, PyAny>) -> PyResult<Option<u64>> {
        self.column(name)?.find(self.map()?, &value)
    }

    fn vertices(&self) -> PyResult<Vec<u64>> {
        Ok(self.map()?.dcel().vertices().map(Vertex::key).map(key).collect())
    }

    fn edges(&self) -> PyResult<Vec<u64>> {
        Ok(self.map()?.dcel().edges().map(HalfEdge::key).map(key).collect())
    }

    fn faces(&self) -> PyResult<Vec<u64>> {
        Ok(self.map()?.dcel().faces().map(Face::key).map(key).collect())
    }

    fn unbounded(&self) -> PyResult<u64> {
        Ok(key(self.map()?.dcel().unbounded_face().key()))
    }

    fn position(&self, vertex: u64) -> PyResult<[f64; 2]> {
        let point = self.map()?.position(KeyData::from_ffi(vertex).into()).map_err(stale)?;
        Ok(point.into())
    }

    fn area(&self, face: u64) -> PyResult<f64> {
        face_area(self.map()?, KeyData::from_ffi(face).into()).map_err(stale)
    }

    /// Returns the vertices around a face, a list for each part of its boundary, the outer one first.
    fn rings(&self, face: u64) -> PyResult<Vec<Vec<u64>>> {
        let face = self.map()?.dcel().face(KeyData::from_ffi(face).into()).map_err(stale)?;
        let ring = |around: Vec<HalfEdge<'_>>| around.into_iter().map(|h| key(h.origin().key())).collect();
        let rings = face.boundaries().map(|boundary| match boundary.isolated_vertex() {
            Some(v) => vec![key(v.key())],
            None => ring(boundary.half_edges().collect()),
        });
        Ok(rings.collect())
    }

    /// Returns the features that cover a face.
    fn features_of(&self, face: u64) -> PyResult<Vec<usize>> {
        let features = self.map()?.features_of(KeyData::from_ffi(face).into()).map_err(stale)?;
        Ok(features.into_iter().map(FeatureId::index).collect())
    }

    /// Returns the polygons of a face.
    fn polygons(&self, face: u64) -> PyResult<Polygons> {
        of_faces(self.map()?, vec![KeyData::from_ffi(face).into()])
    }

    /// Returns the kind of record at a point, and its key.
    fn at(&self, point: [f64; 2]) -> PyResult<(&'static str, u64)> {
        let [x, y] = point;
        let found = self.map()?.locate(Point::new(x, y)).map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(match found {
            Located::Face(face) => ("face", key(face)),
            Located::Edge(half_edge) => ("edge", key(half_edge)),
            Located::Vertex(vertex) => ("vertex", key(vertex)),
        })
    }
}
