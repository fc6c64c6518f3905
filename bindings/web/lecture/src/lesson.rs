//! The structure of a lesson: operators change it, and links are set by hand in a copy of its tables.

use crate::cell;
use crate::error::LessonError;
use crate::state::{self, State};
use serde::Deserialize;
use twinedge::dcel::{BoundaryKey, Corner, Dcel, FaceKey, HalfEdgeKey, History, OperatorError, Side, Split};
use twinedge::dcel::{Turn, VertexKey};
use twinedge::validate::{Record, Table};

/// An operator with its arguments: indices of records.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "op", rename_all = "snake_case")]
pub(crate) enum Operator {
    AddIsolatedVertex { face: usize },
    RemoveIsolatedVertex { vertex: usize },
    Connect { from: Place, to: Place, new_face: Side, inner: Vec<usize> },
    RemoveEdge { half_edge: usize },
    SplitEdge { half_edge: usize },
    JoinEdges { half_edge: usize },
    SplitVertex { from: Place, to: Place },
    ContractEdge { half_edge: usize },
    FlipEdge { half_edge: usize, turn: Turn },
    MoveInner { boundary: usize, face: usize },
}

/// A corner: at a half-edge, or at an isolated vertex.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Place {
    HalfEdge(usize),
    Vertex(usize),
}

/// Tables with a cell set by hand, and the name of the cell.
#[derive(Clone, Debug)]
struct Edited {
    name: String,
    table: Table,
}

/// A structure with undo and redo. Links set by hand come after all operators.
pub(crate) struct Lesson {
    history: History,
    edited: Vec<Edited>,
    undone: Vec<Edited>,
}

impl Default for Lesson {
    fn default() -> Self {
        Self { history: History::new(Dcel::new()), edited: Vec::new(), undone: Vec::new() }
    }
}

/// The keys of records by their indices.
struct Keys<'a>(&'a Dcel);

impl Keys<'_> {
    fn vertex(&self, index: usize) -> Result<VertexKey, LessonError> {
        self.0.vertex_at(index).map(|vertex| vertex.key()).ok_or(LessonError::NoRecord(Record::Vertex(index)))
    }

    fn half_edge(&self, index: usize) -> Result<HalfEdgeKey, LessonError> {
        self.0
            .half_edge_at(index)
            .map(|half_edge| half_edge.key())
            .ok_or(LessonError::NoRecord(Record::HalfEdge(index)))
    }

    fn boundary(&self, index: usize) -> Result<BoundaryKey, LessonError> {
        self.0.boundary_at(index).map(|boundary| boundary.key()).ok_or(LessonError::NoRecord(Record::Boundary(index)))
    }

    fn face(&self, index: usize) -> Result<FaceKey, LessonError> {
        self.0.face_at(index).map(|face| face.key()).ok_or(LessonError::NoRecord(Record::Face(index)))
    }

    fn corner(&self, place: Place) -> Result<Corner, LessonError> {
        match place {
            Place::HalfEdge(index) => self.half_edge(index).map(Corner::At),
            Place::Vertex(index) => self.vertex(index).map(Corner::Isolated),
        }
    }
}

/// An operator with its keys.
type Change = Box<dyn FnOnce(&mut Dcel) -> Result<(), OperatorError>>;

impl Operator {
    const fn name(&self) -> &'static str {
        match self {
            Self::AddIsolatedVertex { .. } => "add isolated vertex",
            Self::RemoveIsolatedVertex { .. } => "remove isolated vertex",
            Self::Connect { .. } => "connect",
            Self::RemoveEdge { .. } => "remove edge",
            Self::SplitEdge { .. } => "split edge",
            Self::JoinEdges { .. } => "join edges",
            Self::SplitVertex { .. } => "split vertex",
            Self::ContractEdge { .. } => "contract edge",
            Self::FlipEdge { .. } => "flip edge",
            Self::MoveInner { .. } => "move inner",
        }
    }

    fn run(self, history: &mut History) -> Result<(), LessonError> {
        let name = self.name();
        let keys = Keys(history.get());
        let change: Change = match self {
            Self::AddIsolatedVertex { face } => {
                let face = keys.face(face)?;
                Box::new(move |dcel| dcel.add_isolated_vertex(face).map(drop))
            }
            Self::RemoveIsolatedVertex { vertex } => {
                let vertex = keys.vertex(vertex)?;
                Box::new(move |dcel| dcel.remove_isolated_vertex(vertex).map(drop))
            }
            Self::Connect { from, to, new_face, inner } => {
                let (from, to) = (keys.corner(from)?, keys.corner(to)?);
                let inner = inner.into_iter().map(|index| keys.boundary(index)).collect::<Result<Vec<_>, _>>()?;
                Box::new(move |dcel| dcel.connect(from, to, Split { new_face, inner: &inner }).map(drop))
            }
            Self::RemoveEdge { half_edge } => {
                let half_edge = keys.half_edge(half_edge)?;
                Box::new(move |dcel| dcel.remove_edge(half_edge).map(drop))
            }
            Self::SplitEdge { half_edge } => {
                let half_edge = keys.half_edge(half_edge)?;
                Box::new(move |dcel| dcel.split_edge(half_edge).map(drop))
            }
            Self::JoinEdges { half_edge } => {
                let half_edge = keys.half_edge(half_edge)?;
                Box::new(move |dcel| dcel.join_edges(half_edge).map(drop))
            }
            Self::SplitVertex { from, to } => {
                let (from, to) = (keys.corner(from)?, keys.corner(to)?);
                Box::new(move |dcel| dcel.split_vertex(from, to).map(drop))
            }
            Self::ContractEdge { half_edge } => {
                let half_edge = keys.half_edge(half_edge)?;
                Box::new(move |dcel| dcel.contract_edge(half_edge).map(drop))
            }
            Self::FlipEdge { half_edge, turn } => {
                let half_edge = keys.half_edge(half_edge)?;
                Box::new(move |dcel| dcel.flip_edge(half_edge, turn).map(drop))
            }
            Self::MoveInner { boundary, face } => {
                let (boundary, face) = (keys.boundary(boundary)?, keys.face(face)?);
                Box::new(move |dcel| dcel.move_inner(boundary, face).map(drop))
            }
        };
        history.change(name, change).map_err(|error| LessonError::operator(error, history.get()))
    }
}

impl Lesson {
    /// Returns the tables of the structure itself.
    ///
    /// # Panics
    /// If there is no memory for the records.
    fn sound(&self) -> Table {
        Table::copy_of(self.history.get()).expect("a copy of a structure that a page shows")
    }

    /// Applies an operator.
    ///
    /// # Errors
    /// [`LessonError::Touched`] while the tables differ from the structure, or the operator's error.
    pub(crate) fn operate(&mut self, operator: Operator) -> Result<(), LessonError> {
        if self.edited.last().is_some_and(|edited| edited.table != self.sound()) {
            return Err(LessonError::Touched);
        }
        operator.run(&mut self.history)?;
        self.edited.clear();
        self.undone.clear();
        Ok(())
    }

    /// Sets a field by hand.
    ///
    /// # Errors
    /// Errors of [`cell::set`].
    pub(crate) fn set(&mut self, record: Record, field: &str, value: &str) -> Result<(), LessonError> {
        let before = self.edited.last().map_or_else(|| self.sound(), |edited| edited.table.clone());
        let mut table = before.clone();
        cell::set(&mut table, record, field, value)?;
        if table != before {
            let name = format!("{field} of {}", state::name(record));
            self.edited.push(Edited { name, table });
            self.undone.clear();
            // Drops the redo entries, which this change invalidates.
            self.history.forget(usize::MAX);
        }
        Ok(())
    }

    /// Undoes the last change, if any.
    pub(crate) fn undo(&mut self) {
        match self.edited.pop() {
            Some(edited) => self.undone.push(edited),
            None => drop(self.history.undo()),
        }
    }

    /// Redoes the last undone change, if any.
    pub(crate) fn redo(&mut self) {
        // All operators came before the links set by hand.
        if !self.history.redo() {
            self.edited.extend(self.undone.pop());
        }
    }

    /// Drops the undo and redo entries.
    pub(crate) fn forget(&mut self) {
        self.history.forget(0);
    }

    pub(crate) fn state(&self) -> State {
        let sound = self.sound();
        let name = |edited: &Edited| edited.name.clone();
        let undo = self.edited.last().map(name).or_else(|| self.history.undo_name().map(str::to_owned));
        let redo = self.history.redo_name().map(str::to_owned).or_else(|| self.undone.last().map(name));
        let table = self.edited.last().map_or_else(|| sound.clone(), |edited| edited.table.clone());
        State::new(self.history.get(), sound, table, undo, redo)
    }
}
