//! All small triangulations, all operators, all arguments.
//!
//! Every simple triangulation of the sphere and of the disc with up to N vertices is made, as a list of triangles, without a
//! half-edge. Their numbers equal the published ones: spheres without root (OEIS A000109) and with one (A000260, Tutte), discs
//! with one at the border (Brown). On each of them, every operator of the structure is tried with every argument, including those
//! of meshes, and the result is compared with the definition by steps, as in [`conformance`](twinedge::program::conformance).

mod outcome;
mod triangulations;

pub use outcome::{MeshFinding, MeshesResults, MeshesRow, MeshesWork, OperatorRow, Shape};
pub use triangulations::Triangulation;

use crate::outcome::Outcome;
use crate::published;
use crate::run::Run;
use crate::structure::Structure;
use std::collections::BTreeMap;
use twinedge::program::conformance::{Conformance, ConformanceSummary, InStep};
use twinedge::program::panics::catch;
use twinedge::program::{Op, Refusal, Subject, every_mesh_op, every_op};
use twinedge::validate::Expectation;

/// The number of consecutive attempts at an operator on a map that the structure does not support.
const SURELY_UNSUPPORTED: u32 = 8;

/// Tries every operator with every argument on every small triangulation.
///
/// A panic of the structure is caught and reported. Time grows about tenfold with each vertex; see [`MeshesWork::estimate`].
///
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::validate::Expectation;
/// use twinedge_trials::meshes::{MeshStructure, MeshesWork};
/// use twinedge_trials::{Run, Structure, meshes};
/// // A structure of planar maps has discs only. One of triangles is given by `MeshStructure::new`.
/// let mine = MeshStructure::plane(Structure::new("mine", Dcel::new, Expectation::plane()));
/// let outcome = meshes(&mine, MeshesWork { vertices: 4 }, &Run::default()).into_result()?;
/// // Brown: of a triangle with 0 and 1 vertices in it, 1; of a square, its two diagonals.
/// assert_eq!(outcome.rows.iter().map(|row| row.rooted).collect::<Vec<_>>(), [1, 1, 2]);
/// # Ok::<(), twinedge_trials::Failed>(())
/// ```
#[must_use]
pub fn meshes<K: Subject>(structure: &MeshStructure<K>, work: MeshesWork, run: &Run<'_>) -> Outcome<MeshesResults> {
    let mut rows = Vec::new();
    let mut maps = Vec::new();
    for shape in work.shapes().filter(|shape| structure.has(*shape)) {
        if run.is_stopped() {
            break;
        }
        let (all, rooted_published, unrooted_published) = match shape {
            Shape::Sphere { vertices } => {
                (triangulations::of_sphere(vertices), published::tutte(vertices), published::spheres(vertices))
            }
            Shape::Disc { outer, inner } => {
                (triangulations::of_disc(outer, inner), published::brown(outer, inner), None)
            }
        };
        maps.extend(all.maps.iter().map(|map| (rows.len(), map.clone())));
        rows.push(MeshesRow {
            shape,
            maps: all.maps.len() as u64,
            rooted: all.rooted,
            rooted_published,
            unrooted: all.unrooted,
            unrooted_published,
            applied: 0,
            refused: 0,
            differences: 0,
        });
    }
    let numbers: Vec<usize> = run.part().numbers(maps.len()).collect();
    let worker =
        || Worker { structure, rows: rows.clone(), summary: ConformanceSummary::default(), findings: Vec::new() };
    let workers = run.each("operators on triangulations", numbers.len(), worker, |worker, position| {
        let (row, map) = &maps[numbers[position]];
        worker.visit(*row, map, run);
    });
    let mut results = MeshesResults::new(structure.name(), rows);
    for worker in workers {
        results.add(&worker.rows, &worker.summary, &worker.findings);
    }
    Outcome::new(work, run, results)
}

struct Worker<'a, K> {
    structure: &'a MeshStructure<K>,
    rows: Vec<MeshesRow>,
    summary: ConformanceSummary,
    findings: Vec<MeshFinding>,
}

impl<K: Subject> Worker<'_, K> {
    fn visit(&mut self, row: usize, map: &Triangulation, run: &Run<'_>) {
        let mut pair = None;
        let Some(first) = self.begin(row, map) else { return };
        let on = first.subject();
        let ops: Vec<Op> = every_mesh_op(on).into_iter().chain(every_op(on)).collect();
        drop(first);
        // The number of consecutive answers on this map that the operator is not supported: it is tried again elsewhere, so that
        // the counts do not depend on the distribution of maps among threads.
        let mut lacks: BTreeMap<&str, u32> = BTreeMap::new();
        for op in ops {
            let lacks = lacks.entry(op.name()).or_default();
            if *lacks >= SURELY_UNSUPPORTED {
                continue;
            }
            if run.is_stopped() {
                return;
            }
            let Some(mut trial) = pair.take().or_else(|| self.begin(row, map)) else { return };
            let before = trial.summary();
            if let Err(failure) = trial.step(op) {
                self.note(row, map, Some(op), failure.difference.to_string());
                continue;
            }
            let (before, after) = (before.total(), trial.summary().total());
            let is_applied = after.applied > before.applied;
            *lacks = if after.unsupported > before.unsupported { *lacks + 1 } else { 0 };
            self.rows[row].applied += u64::from(is_applied);
            self.rows[row].refused += u64::from(after.refused > before.refused);
            if is_applied {
                self.summary.add(&trial.summary());
            } else {
                pair = Some(trial);
            }
        }
        if let Some(pair) = pair {
            self.summary.add(&pair.summary());
        }
    }

    /// Returns the structure and the reference, both with this triangulation.
    fn begin(&mut self, row: usize, map: &Triangulation) -> Option<InStep<K>> {
        let made = catch(|| self.structure.make(map)).map_err(|panic| format!("panicked: {panic}"));
        let made = made.and_then(|made| made.map_err(|refusal| format!("it cannot be made: {refusal}")));
        match made.and_then(|subject| self.structure.asked().begin(subject).map_err(|failure| failure.to_string())) {
            Ok(pair) => Some(pair),
            Err(message) => {
                self.note(row, map, None, message);
                None
            }
        }
    }

    fn note(&mut self, row: usize, map: &Triangulation, op: Option<Op>, message: String) {
        self.rows[row].differences += 1;
        let triangles = map.triangles.clone();
        self.findings.push(MeshFinding { triangles, operator: op.map(|op| op.to_string()), message });
        self.findings.truncate(crate::rows::MOST_FINDINGS);
    }
}

enum Make<K> {
    Triangles(fn(&Triangulation) -> K),
    Operators(Structure<K>),
}

/// A structure under test on which triangulations are made.
pub struct MeshStructure<K> {
    name: &'static str,
    make: Make<K>,
    asked: Conformance,
    is_open: bool,
}

impl<K> std::fmt::Debug for MeshStructure<K> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("MeshStructure").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<K: Subject> MeshStructure<K> {
    /// Returns a structure of this name that is made from triangles. It has spheres, and discs if the expectation is
    /// [open](Expectation::open).
    #[must_use]
    pub fn new(name: &'static str, make: fn(&Triangulation) -> K, expectation: Expectation) -> Self {
        let asked = Conformance::of(&expectation);
        Self { name, make: Make::Triangles(make), asked, is_open: expectation.is_open() }
    }

    /// Returns a structure of planar maps, on which triangulated discs are built by its operators `add_isolated_vertex`,
    /// `split_vertex` and `connect`. The unbounded face surrounds them.
    #[must_use]
    pub fn plane(structure: Structure<K>) -> Self {
        let asked = Conformance::of(&structure.expectation());
        Self { name: structure.name(), make: Make::Operators(structure), asked, is_open: true }
    }

    /// Allows the structure to reuse the handle of a removed record.
    #[must_use]
    pub fn without_stale_handles(mut self) -> Self {
        self.asked = self.asked.without_stale_handles();
        self
    }

    pub(super) const fn name(&self) -> &'static str {
        self.name
    }

    pub(super) const fn asked(&self) -> Conformance {
        self.asked
    }

    pub(super) const fn has(&self, shape: Shape) -> bool {
        match shape {
            Shape::Sphere { .. } => matches!(self.make, Make::Triangles(_)),
            Shape::Disc { .. } => self.is_open,
        }
    }

    pub(super) fn make(&self, map: &Triangulation) -> Result<K, Refusal> {
        match &self.make {
            Make::Triangles(make) => Ok(make(map)),
            Make::Operators(structure) => {
                let mut subject = structure.make();
                triangulations::build(&mut subject, map)?;
                Ok(subject)
            }
        }
    }
}
