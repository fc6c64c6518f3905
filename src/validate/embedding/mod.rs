//! G1 … G5: do these coordinates draw that topology?
//!
//! ```text
//!   G1  finite coordinates, no edge of zero length
//!   G2  around a vertex, the rotation is the order of the angles
//!   G3  outer cycles turn counter-clockwise, inner ones clockwise
//!   G4  edges meet only at shared endpoints
//!   G5  each inner boundary component lies in the face that lists it
//! ```
//!
//! All decisions are exact (see [`predicates`](super::predicates)). G4 and G5 take one sweep, O(n log n).

mod columns;
mod components;
mod cycles;
mod edges;
mod vertices;

use crate::geometry::{MAX_COORDINATE, Point};
use crate::validate::{
    Collect, Expectation, Findings, Flow, Part, Record, Report, Rule, Start, Unchecked, View, Violation, validate,
};
use columns::Columns;
use components::Components;
use edges::Segments;

/// A structure whose vertices have coordinates.
pub trait Embedding: View {
    /// Where the vertex lies. It is asked of live vertices only.
    fn point(&self, vertex: usize) -> Point;
}

/// The rules of this module.
const GEOMETRIC: &[Rule] = &[Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5];

/// Validates any half-edge structure with coordinates: rules R1 … T4 as [`validate`] does, and then G1 … G5.
///
/// G rules are checked where the rules of topology that they build on hold, and reported as not checked elsewhere. If edges
/// clash, all clashes are found and counted, which takes O(n log n + p) for p pairs of edges whose bounding boxes meet;
/// else the cost is O(n log n). Like [`validate`], it does not panic unless the [`Embedding`] does, and it always ends.
///
/// Where there is no unbounded face, what lies outside everything must lie in no face ([`Part::UnboundedFace`]), and what
/// lies in a face must be listed by it.
///
/// ```
/// use twinedge::map::Builder;
/// use twinedge::validate::validate_embedding;
/// use twinedge::validate::{Collect, Expectation, Rule};
///
/// let mut builder = Builder::new();
/// builder.segment([0.0, 0.0], [2.0, 2.0])?;
/// builder.segment([0.0, 2.0], [2.0, 0.0])?;
/// let map = builder.build()?;
/// let report = validate_embedding(&map, &Expectation::plane(), Collect::All);
/// assert_eq!(report.violations()[0].rule(), Rule::G4);
/// # Ok::<(), twinedge::map::BuildError>(())
/// ```
pub fn validate_embedding<D: Embedding + ?Sized>(drawing: &D, expectation: &Expectation, collect: Collect) -> Report {
    let mut report = validate(drawing, expectation, collect);
    let mut run = Run { drawing, expectation: *expectation, findings: Findings::new(report.collect_left(collect)) };
    if report.violation_count() > 0 && collect == Collect::First {
        for rule in GEOMETRIC {
            run.findings.not_checked(*rule, Unchecked::Stopped);
        }
    } else if run.all_rules(&report).is_err() {
        for rule in GEOMETRIC {
            run.findings.not_checked_yet(*rule, Unchecked::Stopped);
        }
    }
    let (outcomes, violations) = run.findings.into_parts(GEOMETRIC);
    report.append(outcomes, violations);
    report
}

struct Run<'a, D: ?Sized> {
    drawing: &'a D,
    expectation: Expectation,
    findings: Findings,
}

impl<D: Embedding + ?Sized> Run<'_, D> {
    fn all_rules(&mut self, topology: &Report) -> Flow {
        let links = [Rule::R1, Rule::L1, Rule::L2, Rule::L3];
        let why = first_broken(topology, &links);
        // What has changed since is as good as broken.
        let columns = if why.is_none() { Columns::read(self.drawing) } else { None };
        let Some(columns) = columns else {
            let why = why.unwrap_or(Unchecked::Broken(Rule::R1));
            for rule in GEOMETRIC {
                self.findings.not_checked(*rule, why);
            }
            return Ok(());
        };
        self.finite(&columns)?;
        if let Some(rule) = self.findings.broken(&[Rule::G1]) {
            for later in &GEOMETRIC[1..] {
                self.findings.not_checked(*later, Unchecked::Broken(rule));
            }
            return Ok(());
        }
        match first_broken(topology, &[Rule::V1, Rule::V2]) {
            Some(why) => self.findings.not_checked(Rule::G2, why),
            None => self.angles(&columns)?,
        }
        let segments = Segments::of(&columns);
        let components = Components::of(&columns);
        let below = self.disjoint(&segments, &components.lowest)?;
        let faces =
            first_broken(topology, &[Rule::V2, Rule::B1, Rule::B2, Rule::F1, Rule::F2, Rule::T1, Rule::T2, Rule::T3]);
        let why = faces.or_else(|| self.findings.broken(&[Rule::G4]).map(Unchecked::Broken));
        let (None, Some(below)) = (why, below) else {
            let why = why.unwrap_or(Unchecked::TooLarge);
            self.findings.not_checked(Rule::G3, why);
            self.findings.not_checked(Rule::G5, why);
            return Ok(());
        };
        let lists = self.lists(&columns);
        self.winding(&columns, &lists)?;
        match self.findings.broken(&[Rule::G2, Rule::G3]) {
            Some(rule) => self.findings.not_checked(Rule::G5, Unchecked::Broken(rule)),
            None => self.inside(&columns, &components, &segments, &below, &lists)?,
        }
        Ok(())
    }
}

/// Why a rule that needs these cannot be checked, if one of them is broken or was not checked.
fn first_broken(topology: &Report, rules: &[Rule]) -> Option<Unchecked> {
    rules.iter().find_map(|rule| {
        let outcome = topology.outcome(*rule)?;
        match outcome.unchecked {
            _ if outcome.violations > 0 => Some(Unchecked::Broken(*rule)),
            Some(Unchecked::Lacks(Part::Leaving)) | None => None,
            Some(why) => Some(why),
        }
    })
}

/// The records of a violation as points, to show where it is: ends of half-edges, places of vertices.
#[must_use]
pub fn places<D: Embedding + ?Sized>(drawing: &D, violation: &Violation) -> Vec<Point> {
    let bound = 2.0 * MAX_COORDINATE;
    let vertex = |v: usize| {
        let live = v < drawing.vertex_slots() && drawing.is_vertex(v);
        live.then(|| drawing.point(v)).filter(|p| p.x.abs() < bound)
    };
    let half_edge = |h: usize| Some(h).filter(|h| *h < drawing.half_edge_slots());
    let origin = |h: usize| drawing.origin(half_edge(h)?).and_then(vertex);
    let mut points = Vec::new();
    for record in violation.records().into_iter().flatten() {
        match record {
            Record::Vertex(v) => points.extend(vertex(v)),
            Record::HalfEdge(h) => {
                points.extend(origin(h));
                points.extend(half_edge(h).and_then(|h| drawing.twin(h)).and_then(origin));
            }
            Record::Boundary(b) if b < drawing.boundary_slots() => {
                points.extend(drawing.boundary_start(b).and_then(|start| match start {
                    Start::HalfEdge(h) => origin(h),
                    Start::Vertex(v) => vertex(v),
                }));
            }
            Record::Boundary(_) | Record::Face(_) => {}
        }
    }
    points
}
