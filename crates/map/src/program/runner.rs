//! The interpreter of edits: chooses arguments as a program says, edits, and checks the outcome on request.

use super::arguments::{AtPick, FeaturesPick, List, MapFacePick, MapHalfEdgePick, MapVertexPick};
use super::edits::{EditOp, EditProgram};
use crate::edit::{At, EditError, Edited};
use crate::near::{EmbeddingBaseline, validate_embedding_near};
use crate::{FeatureId, PlanarMap};
use slotmap::{Key, SecondaryMap};
use thiserror::Error;
use twinedge::dcel::{Face, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge::validate::near::{BaselineError, WriteSet};
use twinedge::validate::{Expectation, Report};

/// The outcome of one edit of a program.
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "most edits of a program are applied")]
pub enum EditOutcome {
    /// The edit was applied. The value is empty for edits that make and drop nothing: moving a vertex, changing features.
    Applied(Edited),
    /// The edit was refused.
    Refused(EditError),
    /// The list to choose from was empty (no half-edge, no stale key, …).
    Skipped,
}

/// A fault found by a check after an edit.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EditFailure {
    /// The map breaks a rule of R1 … T4 or G1 … G5.
    #[error("after edit {number} (`{op}`):\n{report}")]
    Invalid {
        /// The edit, counted from 1.
        number: usize,
        /// The edit.
        op: EditOp,
        /// The broken rules.
        report: Box<Report>,
    },
    /// The edit was refused, but changed the map.
    #[error("edit {number} (`{op}`) was refused ({error}), but changed the map")]
    Changed {
        /// The edit, counted from 1.
        number: usize,
        /// The edit.
        op: EditOp,
        /// The reason for the refusal.
        error: EditError,
    },
}

/// The error of an edit whose number is past the end of a list. [`EditRunner`] takes numbers modulo the length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("there is no {prefix}{number}: {} are there", .count)]
#[non_exhaustive]
pub struct PastLast {
    /// The letter of the list: `v`, `h`, `f`, after `!` for removed keys.
    pub prefix: &'static str,
    /// The number.
    pub number: u32,
    /// The length of the list.
    pub count: usize,
}

/// Returns the `k`-th entry of a list, modulo its length.
fn nth<K: Copy>(list: &[K], k: u32) -> Option<K> {
    (k as usize).checked_rem(list.len()).map(|place| list[place])
}

/// Runs programs of edits on a map. Keeps the map and all its keys, in order of creation.
///
/// ```
/// use twinedge_map::PlanarMap;
/// use twinedge_map::edit::EditError;
/// use twinedge_map::program::{EditOutcome, EditProgram, EditRunner};
///
/// let program: EditProgram = "twinedge edits 1
///     insert_ring 0,0 4,0 4,4 0,4
///     insert_segment v0 v2            # a diagonal,
///     insert_segment 1,3 3,1          # which this one would cross
///     remove_vertex v0
///     remove_vertex !v0               # once more: a stale key
/// ".parse()?;
/// let mut runner = EditRunner::new(PlanarMap::new());
/// let outcomes = runner.run_checked(&program)?;
/// assert!(matches!(outcomes[2], EditOutcome::Refused(EditError::Crosses(_))));
/// assert!(matches!(outcomes[4], EditOutcome::Refused(EditError::Operator(_))));
/// assert_eq!(runner.map().dcel().edge_count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct EditRunner {
    map: PlanarMap,
    pub(super) vertices: Keys<VertexKey>,
    pub(super) half_edges: Keys<HalfEdgeKey>,
    pub(super) faces: Keys<FaceKey>,
    steps: usize,
    /// The baseline for comparison, if the map is audited.
    baseline: Option<EmbeddingBaseline>,
    /// The records written since the map was last found valid, if it is audited.
    written: WriteSet,
}

/// A clone of an audited runner is also audited.
impl Clone for EditRunner {
    fn clone(&self) -> Self {
        let Self { map, vertices, half_edges, faces, steps, baseline, written } = self;
        let mut clone = Self {
            map: map.clone(),
            vertices: vertices.clone(),
            half_edges: half_edges.clone(),
            faces: faces.clone(),
            steps: *steps,
            baseline: baseline.clone(),
            written: written.clone(),
        };
        if clone.baseline.is_some() {
            clone.map.begin_logs();
        }
        clone
    }
}

impl EditRunner {
    /// Creates a runner for a map. O(size of the map).
    #[must_use]
    pub fn new(map: PlanarMap) -> Self {
        let dcel = map.dcel();
        Self {
            vertices: Keys::new(dcel.vertices().map(Vertex::key)),
            half_edges: Keys::new(dcel.half_edges().map(HalfEdge::key)),
            faces: Keys::new(dcel.faces().map(Face::key)),
            map,
            steps: 0,
            baseline: None,
            written: WriteSet::default(),
        }
    }

    /// Creates a runner whose [`step_checked`](Self::step_checked) validates only the records written by the edit, as
    /// [`Audited`](twinedge::dcel::Audited) does: O(k log k) for k records, with the same verdict. For refused edits it checks
    /// that links and coordinates are unchanged, but not features. O(n log n).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    /// use twinedge_map::program::{EditProgram, EditRunner};
    ///
    /// let program = EditProgram::from_bytes(b"any bytes are a program of edits, and each edit leaves a valid map");
    /// let mut runner = EditRunner::audited(PlanarMap::new())?;
    /// runner.run_checked(&program)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The map is invalid.
    pub fn audited(map: PlanarMap) -> Result<Self, BaselineError> {
        let baseline = EmbeddingBaseline::new(&map, &Expectation::plane())?;
        let mut runner = Self::new(map);
        runner.map.begin_logs();
        runner.baseline = Some(baseline);
        Ok(runner)
    }

    /// Returns the map.
    #[must_use]
    pub const fn map(&self) -> &PlanarMap {
        &self.map
    }

    /// Converts the runner into its map.
    #[must_use]
    pub fn into_map(mut self) -> PlanarMap {
        if self.baseline.is_some() {
            self.map.end_logs();
        }
        self.map
    }

    /// Runs a whole program and returns the outcome of each edit.
    pub fn run(&mut self, program: &EditProgram) -> Vec<EditOutcome> {
        program.0.iter().map(|op| self.step(op)).collect()
    }

    /// Runs a whole program as [`step_checked`](Self::step_checked) does, and returns the outcome of each edit.
    ///
    /// # Errors
    /// [`EditFailure`], at the first edit whose check fails.
    pub fn run_checked(&mut self, program: &EditProgram) -> Result<Vec<EditOutcome>, EditFailure> {
        program.0.iter().map(|op| self.step_checked(op)).collect()
    }

    /// Runs one edit. O(log n) for each added or removed key, plus the cost of the edit.
    pub fn step(&mut self, op: &EditOp) -> EditOutcome {
        self.steps += 1;
        match self.edit(op) {
            None => EditOutcome::Skipped,
            Some(Err(error)) => EditOutcome::Refused(error),
            Some(Ok(edited)) => {
                self.follow(&edited);
                EditOutcome::Applied(edited)
            }
        }
    }

    fn follow(&mut self, edited: &Edited) {
        let dcel = self.map.dcel();
        let vertices = edited.vertices_made.iter().chain(&edited.vertices_dropped);
        self.vertices.update(
            vertices.copied().collect(),
            |v| dcel.vertex(v).is_ok(),
            |v| dcel.vertex(v).map_or(0, Vertex::index),
        );
        let split = edited.edges_split.iter().map(|(_, new)| new);
        let edges = edited.edges_made.iter().chain(&edited.edges_dropped).chain(split);
        let half_edges = edges.flat_map(|h| {
            let twin = dcel.half_edge(*h).map_or_else(|_| self.half_edges.beside(*h), |h| Some(h.twin().key()));
            [Some(*h), twin]
        });
        let half_edges: Vec<_> = half_edges.flatten().collect();
        self.half_edges.update(
            half_edges,
            |h| dcel.half_edge(h).is_ok(),
            |h| dcel.half_edge(h).map_or(0, HalfEdge::index),
        );
        let faces = edited.faces_split.iter().chain(&edited.faces_merged).map(|(_, face)| *face);
        self.faces.update(faces.collect(), |f| dcel.face(f).is_ok(), |f| dcel.face(f).map_or(0, Face::index));
    }

    /// Runs one edit, and checks that the map keeps every rule, from R1 to T4 and from G1 to G5, or, if the edit is refused, that
    /// nothing changed. O(n log n) plus the cost of the edit. [`audited`](Self::audited) is faster.
    ///
    /// # Errors
    /// [`EditFailure`].
    pub fn step_checked(&mut self, op: &EditOp) -> Result<EditOutcome, EditFailure> {
        let before = self.baseline.is_none().then(|| self.map.clone());
        let place = self.map.dcel().log_place();
        let outcome = self.step(op);
        let (number, op) = (self.steps, op.clone());
        let is_unchanged = if let Some(before) = &before {
            matches!(outcome, EditOutcome::Refused(_)) && self.map == *before
        } else {
            self.written.extend(place.map(|place| self.map.take_written(place)).unwrap_or_default());
            self.written.is_empty()
        };
        match &outcome {
            EditOutcome::Refused(error) if !is_unchanged => {
                return Err(EditFailure::Changed { number, op, error: *error });
            }
            EditOutcome::Refused(_) | EditOutcome::Skipped => return Ok(outcome),
            EditOutcome::Applied(_) => {}
        }
        match self.validated() {
            Ok(()) => Ok(outcome),
            Err(report) => Err(EditFailure::Invalid { number, op, report }),
        }
    }

    /// Validates the map, or the records written since it was last found valid.
    fn validated(&mut self) -> Result<(), Box<Report>> {
        let Some(baseline) = &mut self.baseline else {
            return self.map.validate().into_result().map(|_| ());
        };
        validate_embedding_near(baseline, &self.map, &self.written)?;
        self.written.clear();
        Ok(())
    }

    /// Checks that no number of an edit is past the end of its list. In a hand-written journal that is a mistake. Empty lists are
    /// accepted, since [`step`](Self::step) skips such edits. O(arguments).
    ///
    /// # Errors
    /// [`PastLast`], for the first such number.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    /// use twinedge_map::program::{EditOp, EditRunner};
    ///
    /// let mut runner = EditRunner::new(PlanarMap::new());
    /// runner.step(&"insert_segment 0,0 1,1".parse()?);
    /// let past: EditOp = "remove_vertex v7".parse()?;
    /// assert_eq!(runner.check_numbers(&past).unwrap_err().to_string(), "there is no v7: 2 are there");
    /// # Ok::<(), twinedge::program::ParseError>(())
    /// ```
    pub fn check_numbers(&self, op: &EditOp) -> Result<(), PastLast> {
        let mut checked = Ok(());
        let _ = op.renumber(&mut |list, number| {
            let (prefix, count) = match list {
                List::Vertices => ("v", self.vertices.len()),
                List::HalfEdges => ("h", self.half_edges.len()),
                List::Faces => ("f", self.faces.len()),
                List::RetiredVertices => ("!v", self.vertices.retired.len()),
                List::RetiredHalfEdges => ("!h", self.half_edges.retired.len()),
                List::RetiredFaces => ("!f", self.faces.retired.len()),
            };
            if checked.is_ok() && count > 0 && number as usize >= count {
                checked = Err(PastLast { prefix, number, count });
            }
            number
        });
        checked
    }

    /// Runs the edit; `None` if there is nothing to choose from.
    fn edit(&mut self, op: &EditOp) -> Option<Result<Edited, EditError>> {
        let done = |()| Edited::default();
        Some(match op {
            EditOp::InsertPoint { at } => {
                let at = self.at(*at)?;
                self.map.insert_point(at)
            }
            EditOp::InsertSegment { from, to } => {
                let (from, to) = (self.at(*from)?, self.at(*to)?);
                self.map.insert_segment(from, to)
            }
            EditOp::InsertSegmentSnapped { from, to, snap } => {
                let (from, to) = (self.at(*from)?, self.at(*to)?);
                self.map.insert_segment_snapped(from, to, snap.snap())
            }
            EditOp::InsertRing { points } => {
                let points: Vec<At> = points.0.iter().map(|at| self.at(*at)).collect::<Option<_>>()?;
                self.map.insert_ring(points)
            }
            EditOp::RemoveEdge { half_edge } => {
                let h = self.half_edge(*half_edge)?;
                self.map.remove_edge(h)
            }
            EditOp::RemoveVertex { vertex } => {
                let v = self.vertex(*vertex)?;
                self.map.remove_vertex(v)
            }
            EditOp::MoveVertex { vertex, to } => {
                let v = self.vertex(*vertex)?;
                self.map.move_vertex(v, to.point()).map(done)
            }
            EditOp::AddFeature {} => {
                self.map.add_feature(None);
                Ok(Edited::default())
            }
            EditOp::SetFeaturesOf { face, features } => {
                let f = self.face(*face)?;
                self.map.set_features_of(f, ids(*features)).map(done)
            }
            EditOp::SetFeaturesAlong { half_edge, features } => {
                let h = self.half_edge(*half_edge)?;
                self.map.set_features_along(h, ids(*features)).map(done)
            }
        })
    }

    fn vertex(&self, pick: MapVertexPick) -> Option<VertexKey> {
        match pick {
            MapVertexPick::Live(k) => self.vertices.nth(k),
            MapVertexPick::Retired(k) => nth(&self.vertices.retired, k),
        }
    }

    fn half_edge(&self, pick: MapHalfEdgePick) -> Option<HalfEdgeKey> {
        match pick {
            MapHalfEdgePick::Live(k) => self.half_edges.nth(k),
            MapHalfEdgePick::Retired(k) => nth(&self.half_edges.retired, k),
        }
    }

    fn face(&self, pick: MapFacePick) -> Option<FaceKey> {
        match pick {
            MapFacePick::Live(k) => self.faces.nth(k),
            MapFacePick::Retired(k) => nth(&self.faces.retired, k),
        }
    }

    fn at(&self, pick: AtPick) -> Option<At> {
        Some(match pick {
            AtPick::Point(spot) => At::Point(spot.point()),
            AtPick::Near(spot, hint) => At::Near(spot.point(), self.half_edge(hint)?),
            AtPick::Vertex(pick) => At::Vertex(self.vertex(pick)?),
        })
    }
}

fn ids(pick: FeaturesPick) -> impl Iterator<Item = FeatureId> {
    (0..16).filter(move |bit| pick.0 >> bit & 1 == 1).map(FeatureId::new)
}

#[derive(Clone, Debug)]
pub(super) struct Keys<K: Key> {
    all: Vec<K>,
    /// The indices in `all` of the live keys.
    places: SecondaryMap<K, usize>,
    /// The number of live keys in ranges of `all` (a Fenwick tree): range i, from 1, ends at key i, with the lowest bit of i as
    /// length.
    counts: Vec<usize>,
    /// The removed keys, in order of removal.
    pub(super) retired: Vec<K>,
}

const fn lowest_bit(i: usize) -> usize {
    i & i.wrapping_neg()
}

impl<K: Key> Keys<K> {
    fn new(keys: impl Iterator<Item = K>) -> Self {
        let mut new = Self { all: Vec::new(), places: SecondaryMap::new(), counts: Vec::new(), retired: Vec::new() };
        for key in keys {
            new.push(key);
        }
        new
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// Returns the live keys, in order. O(all).
    pub(super) fn live(&self) -> Vec<K> {
        self.all.iter().copied().filter(|key| self.places.contains_key(*key)).collect()
    }

    /// Returns the `k`-th live key, modulo their number. O(log all).
    pub(super) fn nth(&self, k: u32) -> Option<K> {
        let mut left = (k as usize).checked_rem(self.len())?;
        let (mut before, mut step) = (0, self.all.len().checked_ilog2().map_or(0, |log| 1 << log));
        while step > 0 {
            if let Some(count) = self.counts.get(before + step - 1).filter(|count| **count <= left) {
                left -= count;
                before += step;
            }
            step /= 2;
        }
        self.all.get(before).copied()
    }

    /// Returns the other key of a pair that was added together.
    pub(super) fn beside(&self, key: K) -> Option<K> {
        self.all.get(self.places.get(key)? ^ 1).copied()
    }

    fn push(&mut self, key: K) {
        let number = self.all.len() + 1;
        let (mut count, mut end) = (1, number - 1);
        while end > number - lowest_bit(number) {
            count += self.counts[end - 1];
            end -= lowest_bit(end);
        }
        self.counts.push(count);
        self.places.insert(key, number - 1);
        self.all.push(key);
    }

    /// Updates the lists by the keys that an edit named: removed keys are retired, in order of creation, and new keys are
    /// appended, in order of their slots. O(k log all) for k keys.
    pub(super) fn update(&mut self, named: Vec<K>, is_there: impl Fn(K) -> bool, slot: impl Fn(K) -> usize) {
        let (there, gone): (Vec<K>, Vec<K>) = named.into_iter().partition(|key| is_there(*key));
        let mut gone: Vec<usize> = gone.into_iter().filter_map(|key| self.places.remove(key)).collect();
        gone.sort_unstable();
        for place in gone {
            self.retired.push(self.all[place]);
            let mut number = place + 1;
            while let Some(count) = self.counts.get_mut(number - 1) {
                *count -= 1;
                number += lowest_bit(number);
            }
        }
        let mut new: Vec<K> = there.into_iter().filter(|key| !self.places.contains_key(*key)).collect();
        new.sort_by_key(|key| slot(*key));
        new.dedup();
        for key in new {
            self.push(key);
        }
    }
}
