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

use super::crossing::{Clash, clashes};
use super::predicates::{Orientation, compare_angle, compare_lexicographic, in_range, orientation};
use super::sweep::sweep;
use super::{MAX_COORDINATE, Point};
use crate::validate::{
    Collect, Expectation, Findings, Flow, Part, Record, Report, Rule, Start, Unchecked, View, Violation, validate,
};
use core::cmp::Ordering;

/// A structure whose vertices have coordinates.
pub trait Drawing: View {
    /// Where the vertex lies. Any answer will do for a slot without a live vertex.
    fn point(&self, vertex: usize) -> Point;
}

/// The rules of this module.
const GEOMETRIC: &[Rule] = &[Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5];

/// Validates any half-edge structure with coordinates: rules R1 … T4 as [`validate`] does, and then G1 … G5.
///
/// G rules are checked where the rules of topology that they build on hold, and reported as not checked elsewhere. If edges
/// clash, all clashes are found and counted, which takes O(n log n + p) for p pairs of edges whose bounding boxes meet;
/// else the cost is O(n log n).
///
/// ```
/// use twinedge::geometry::{Builder, validate_drawing};
/// use twinedge::validate::{Collect, Expectation, Rule};
///
/// let mut builder = Builder::new();
/// builder.segment([0.0, 0.0], [2.0, 2.0])?;
/// builder.segment([0.0, 2.0], [2.0, 0.0])?;
/// let map = builder.build()?;
/// let report = validate_drawing(&map, &Expectation::plane(), Collect::All);
/// assert_eq!(report.violations()[0].rule(), Rule::G4);
/// # Ok::<(), twinedge::geometry::BuildError>(())
/// ```
pub fn validate_drawing<D: Drawing + ?Sized>(drawing: &D, expectation: &Expectation, collect: Collect) -> Report {
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

/// The drawing as plain arrays, for the sweep.
struct Arrays {
    points: Vec<Point>,
    /// The vertex of each point.
    vertices: Vec<usize>,
    segments: Vec<[u32; 2]>,
    /// For each segment the half-edge that runs from its lexicographically smaller end to the larger.
    rising: Vec<usize>,
}

impl<D: Drawing + ?Sized> Run<'_, D> {
    fn all_rules(&mut self, topology: &Report) -> Flow {
        let live = Self::first_broken(topology, &[Rule::R1, Rule::L1, Rule::L2, Rule::L3]);
        if let Some(why) = live {
            for rule in GEOMETRIC {
                self.findings.not_checked(*rule, why);
            }
            return Ok(());
        }
        self.finite()?;
        if let Some(rule) = self.findings.broken(&[Rule::G1]) {
            for later in &GEOMETRIC[1..] {
                self.findings.not_checked(*later, Unchecked::Broken(rule));
            }
            return Ok(());
        }
        match Self::first_broken(topology, &[Rule::V1, Rule::V2]) {
            Some(why) => self.findings.not_checked(Rule::G2, why),
            None => self.angles()?,
        }
        let arrays = self.arrays();
        let lowest = self.lowest_vertices();
        let swept = self.disjoint(&arrays, &lowest)?;
        let faces = Self::first_broken(
            topology,
            &[Rule::V2, Rule::B1, Rule::B2, Rule::F1, Rule::F2, Rule::T1, Rule::T2, Rule::T3],
        );
        let why = faces.or_else(|| self.findings.broken(&[Rule::G4]).map(Unchecked::Broken));
        if let Some(why) = why {
            self.findings.not_checked(Rule::G3, why);
            self.findings.not_checked(Rule::G5, why);
            return Ok(());
        }
        self.winding()?;
        match self.findings.broken(&[Rule::G2, Rule::G3]) {
            Some(rule) => self.findings.not_checked(Rule::G5, Unchecked::Broken(rule)),
            None => self.inside(&arrays, &lowest, &swept)?,
        }
        Ok(())
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

    fn half_edges(&self) -> impl Iterator<Item = usize> + use<'_, D> {
        (0..self.drawing.half_edge_slots()).filter(|h| self.drawing.is_half_edge(*h))
    }

    /// Where a half-edge starts.
    fn tail(&self, h: usize) -> Point {
        self.drawing.origin(h).map_or(Point::default(), |v| self.drawing.point(v))
    }

    /// Where a half-edge ends: where its next starts.
    fn head(&self, h: usize) -> Point {
        self.drawing.next(h).map_or(Point::default(), |n| self.tail(n))
    }

    fn finite(&mut self) -> Flow {
        let mut checked = 0;
        for v in 0..self.drawing.vertex_slots() {
            if self.drawing.is_vertex(v) {
                checked += 1;
                if !in_range(self.drawing.point(v)) {
                    self.findings.add(Violation::NotFinite { vertex: v })?;
                }
            }
        }
        self.findings.checked(Rule::G1, checked);
        for h in 0..self.drawing.half_edge_slots() {
            if self.drawing.is_half_edge(h)
                && self.drawing.twin(h).is_none_or(|t| h < t)
                && self.tail(h) == self.head(h)
            {
                self.findings.add(Violation::ZeroLength { half_edge: h })?;
            }
        }
        Ok(())
    }

    /// Turning counter-clockwise once around a vertex, the angle falls back exactly once.
    fn angles(&mut self) -> Flow {
        let mut seen = vec![false; self.drawing.vertex_slots()];
        let mut checked = 0;
        for first in 0..self.drawing.half_edge_slots() {
            let Some(v) = self.drawing.origin(first).filter(|_| self.drawing.is_half_edge(first)) else { continue };
            if std::mem::replace(&mut seen[v], true) {
                continue;
            }
            checked += 1;
            let center = self.drawing.point(v);
            let clockwise = |h: usize| self.drawing.twin(h).and_then(|t| self.drawing.next(t));
            let mut rises = 0;
            let mut h = first;
            // At an open boundary the walk ends, and what it saw was in order if it rose once at the most.
            while let Some(after) = clockwise(h) {
                if compare_angle(center, self.head(h), self.head(after)) == Ordering::Less {
                    rises += 1;
                    if rises > 1 {
                        self.findings.add(Violation::OutOfOrder { vertex: v, half_edge: h, found: after })?;
                        break;
                    }
                }
                h = after;
                if h == first {
                    break;
                }
            }
        }
        self.findings.checked(Rule::G2, checked);
        Ok(())
    }

    fn arrays(&self) -> Arrays {
        let slots = self.drawing.vertex_slots();
        let mut number = vec![u32::MAX; slots];
        let mut arrays = Arrays { points: Vec::new(), vertices: Vec::new(), segments: Vec::new(), rising: Vec::new() };
        for (v, number) in number.iter_mut().enumerate() {
            if self.drawing.is_vertex(v) {
                *number = arrays.points.len() as u32;
                arrays.points.push(self.drawing.point(v));
                arrays.vertices.push(v);
            }
        }
        for h in self.half_edges() {
            let (Some(v), Some(n)) = (self.drawing.origin(h), self.drawing.next(h)) else { continue };
            let Some(w) = self.drawing.origin(n) else { continue };
            let rises = compare_lexicographic(self.drawing.point(v), self.drawing.point(w)) == Ordering::Less;
            if rises || self.drawing.twin(h).is_none() {
                arrays.segments.push([number[v], number[w]]);
                arrays.rising.push(h);
            }
        }
        arrays
    }

    /// The lexicographically smallest vertex of each component, as places in the arrays.
    fn lowest_vertices(&self) -> Vec<u32> {
        let slots = self.drawing.vertex_slots();
        let mut component = vec![u32::MAX; slots];
        let mut lowest: Vec<u32> = Vec::new();
        let mut leaving = vec![usize::MAX; slots];
        for h in self.half_edges() {
            if let Some(v) = self.drawing.origin(h) {
                leaving[v] = h;
            }
        }
        let mut stack = Vec::new();
        let mut place = 0;
        let mut places = vec![u32::MAX; slots];
        for (v, entry) in places.iter_mut().enumerate() {
            if self.drawing.is_vertex(v) {
                *entry = place;
                place += 1;
            }
        }
        for first in 0..slots {
            if !self.drawing.is_vertex(first) || component[first] != u32::MAX {
                continue;
            }
            let number = lowest.len() as u32;
            component[first] = number;
            stack.push(first);
            let mut low = first;
            while let Some(v) = stack.pop() {
                if compare_lexicographic(self.drawing.point(v), self.drawing.point(low)) == Ordering::Less {
                    low = v;
                }
                let start = leaving[v];
                let mut h = start;
                while h != usize::MAX {
                    if let Some(w) = self.drawing.next(h).and_then(|n| self.drawing.origin(n))
                        && std::mem::replace(&mut component[w], number) == u32::MAX
                    {
                        stack.push(w);
                    }
                    h = self.drawing.twin(h).and_then(|t| self.drawing.next(t)).unwrap_or(usize::MAX);
                    if h == start {
                        break;
                    }
                }
            }
            lowest.push(places[low]);
        }
        lowest
    }

    /// Runs G4, and gives for each component the segment below it.
    fn disjoint(&mut self, arrays: &Arrays, lowest: &[u32]) -> Result<Vec<Option<u32>>, crate::validate::Halt> {
        self.findings.checked(Rule::G4, arrays.segments.len() as u64);
        // The arrays describe a drawing: G1 holds, and every number was given out above.
        let Ok(swept) = sweep(&arrays.points, &arrays.segments, lowest) else {
            self.findings.not_checked(Rule::G4, Unchecked::TooLarge);
            return Ok(Vec::new());
        };
        if swept.clash.is_some() {
            let (found, total) =
                clashes(&arrays.points, &arrays.segments, self.findings.room()).unwrap_or_else(|_| (Vec::new(), 0));
            let kept = found.len() as u64;
            for clash in found {
                self.findings.add(Self::violation(arrays, clash))?;
            }
            self.findings.add_uncollected(Rule::G4, total.saturating_sub(kept));
        }
        Ok(swept.below)
    }

    fn violation(arrays: &Arrays, clash: Clash) -> Violation {
        let vertex = |p: u32| arrays.vertices[p as usize];
        let edge = |s: u32| arrays.rising[s as usize];
        match clash {
            Clash::SamePlace { a, b } => Violation::SamePlace { first: vertex(a), second: vertex(b) },
            Clash::Cross { a, b } => Violation::Cross { first: edge(a), second: edge(b) },
            Clash::Overlap { a, b } => Violation::Overlap { first: edge(a), second: edge(b) },
            Clash::Touch { vertex: v, segment } => Violation::Touch { vertex: vertex(v), half_edge: edge(segment) },
        }
    }

    /// The starts of the boundary components of a face, each with the record by which a report names it, outer ones marked.
    fn boundary_starts(&self, f: usize) -> impl Iterator<Item = (Start, usize, bool)> + use<'_, D> {
        let by_record = self.expectation.has(Part::BoundaryComponents);
        let outer = if by_record {
            self.drawing.outer(f).and_then(|b| Some((self.drawing.boundary_start(b)?, b, true)))
        } else {
            self.drawing.outer_half_edge(f).map(|h| (Start::HalfEdge(h), h, true))
        };
        let count = if self.expectation.has(Part::Holes) { self.drawing.inner_count(f) } else { 0 };
        let inner = (0..count).filter_map(move |i| {
            if by_record {
                let b = self.drawing.inner(f, i)?;
                Some((self.drawing.boundary_start(b)?, b, false))
            } else {
                let start = self.drawing.inner_start(f, i)?;
                let (Start::HalfEdge(name) | Start::Vertex(name)) = start;
                Some((start, name, false))
            }
        });
        outer.into_iter().chain(inner)
    }

    fn faces(&self) -> impl Iterator<Item = usize> + use<'_, D> {
        (0..self.drawing.face_slots()).filter(|f| self.drawing.is_face(*f))
    }

    fn winding(&mut self) -> Flow {
        let mut checked = 0;
        let drawing = self.drawing;
        for f in (0..drawing.face_slots()).filter(|f| drawing.is_face(*f)) {
            let starts: Vec<_> = self.boundary_starts(f).collect();
            for (start, boundary, outer) in starts {
                let Start::HalfEdge(h) = start else { continue };
                checked += 1;
                match (outer, self.turns_clockwise(h)) {
                    (true, true) => self.findings.add(Violation::OuterClockwise { boundary })?,
                    (false, false) => self.findings.add(Violation::InnerCounterClockwise { boundary })?,
                    _ => {}
                }
            }
        }
        self.findings.checked(Rule::G3, checked);
        Ok(())
    }

    /// Whether the face lies around the cycle, not inside it: whether at the lexicographically smallest vertex it lies to
    /// the left. A cycle may pass there more than once.
    fn turns_clockwise(&self, start: usize) -> bool {
        let mut low = self.tail(start);
        let mut around = false;
        let mut h = start;
        while let Some(n) = self.drawing.next(h) {
            let (before, at, after) = (self.tail(h), self.tail(n), self.head(n));
            match compare_lexicographic(at, low) {
                Ordering::Less => {
                    low = at;
                    around = Self::corner_opens_left(before, at, after);
                }
                Ordering::Equal => around |= Self::corner_opens_left(before, at, after),
                Ordering::Greater => {}
            }
            h = n;
            if h == start {
                break;
            }
        }
        around
    }

    /// Whether the corner to the left of the way `before`, `at`, `after` holds the direction straight to the left, `at`
    /// being the smallest of the three.
    fn corner_opens_left(before: Point, at: Point, after: Point) -> bool {
        before == after || orientation(at, before, after) == Orientation::CounterClockwise
    }

    /// The face to the left of a half-edge.
    fn face_of(&self, h: usize) -> Option<usize> {
        if self.expectation.has(Part::BoundaryComponents) {
            self.drawing.boundary_face(self.drawing.boundary(h)?)
        } else {
            self.drawing.face(h)
        }
    }

    /// Below the lowest vertex of a component there is an edge, and above that edge the face in which the component lies;
    /// or there is none, and it lies in the unbounded face. If all components that start further to the left lie where
    /// they should, the face to the left of that edge is the right one; so one pass proves it for all.
    fn inside(&mut self, arrays: &Arrays, lowest: &[u32], below: &[Option<u32>]) -> Flow {
        let unbounded = self.faces().find(|f| !self.boundary_starts(*f).any(|(.., outer)| outer));
        let mut found_at = vec![usize::MAX; self.drawing.vertex_slots()];
        for (place, below) in lowest.iter().zip(below) {
            let found = match below {
                Some(segment) => self.face_of(arrays.rising[*segment as usize]),
                None => unbounded,
            };
            found_at[arrays.vertices[*place as usize]] = found.unwrap_or(usize::MAX);
        }
        let mut checked = 0;
        let drawing = self.drawing;
        for f in (0..drawing.face_slots()).filter(|f| drawing.is_face(*f)) {
            let starts: Vec<_> = self.boundary_starts(f).filter(|(.., outer)| !outer).collect();
            for (start, boundary, _) in starts {
                checked += 1;
                let vertex = match start {
                    Start::Vertex(v) => v,
                    Start::HalfEdge(h) => self.lowest_on_cycle(h),
                };
                let found = found_at[vertex];
                if found != f && found != usize::MAX {
                    self.findings.add(Violation::WrongFace { boundary, face: f, found })?;
                }
            }
        }
        self.findings.checked(Rule::G5, checked);
        Ok(())
    }

    /// The lexicographically smallest vertex of a cycle, which is that of its component if the cycle is the outside.
    fn lowest_on_cycle(&self, start: usize) -> usize {
        let mut low = start;
        let mut h = start;
        while let Some(n) = self.drawing.next(h) {
            if compare_lexicographic(self.tail(n), self.tail(low)) == Ordering::Less {
                low = n;
            }
            h = n;
            if h == start {
                break;
            }
        }
        self.drawing.origin(low).unwrap_or_default()
    }
}

/// The records of a violation as points, to show where it is: ends of half-edges, places of vertices.
#[must_use]
pub fn places<D: Drawing + ?Sized>(drawing: &D, violation: &Violation) -> Vec<Point> {
    let bound = 2.0 * MAX_COORDINATE;
    let vertex = |v: usize| drawing.is_vertex(v).then(|| drawing.point(v)).filter(|p| p.x.abs() < bound);
    let mut points = Vec::new();
    for record in violation.records().into_iter().flatten() {
        match record {
            Record::Vertex(v) => points.extend(vertex(v)),
            Record::HalfEdge(h) => {
                points.extend(drawing.origin(h).and_then(vertex));
                points.extend(drawing.twin(h).and_then(|t| drawing.origin(t)).and_then(vertex));
            }
            Record::Boundary(b) => {
                points.extend(
                    drawing
                        .boundary_start(b)
                        .and_then(|start| match start {
                            Start::HalfEdge(h) => drawing.origin(h),
                            Start::Vertex(v) => Some(v),
                        })
                        .and_then(vertex),
                );
            }
            Record::Face(_) => {}
        }
    }
    points
}
