//! The rules G1 … G5.

use crate::Embedding;
use crate::drawing::columns::Columns;
use crate::drawing::components::Components;
use crate::drawing::lists::{Listed, Lists};
use crate::drawing::segments::Segments;
use crate::numbers::NIL;
use core::cmp::Ordering;
use twinedge::validate::{Findings, Flow, Halt, Link, Part, Parts, Rule, Start, Unchecked, Violation};
use twinedge_geometry::Point;
use twinedge_geometry::crossing::clashes;
use twinedge_geometry::predicates::{Orientation, compare_angle, compare_lexicographic, in_range, orientation};
use twinedge_geometry::sweep::sweep_plane;

/// G1 finite: coordinates are finite, and no edge has zero length.
///
/// A coordinate also breaks the rule if the predicates are not exact for it. Segments between bends must have a length.
pub(crate) fn finite(findings: &mut Findings, columns: &Columns) -> Flow {
    let mut checked = 0;
    for v in columns.vertices() {
        checked += 1;
        if !in_range(columns.points[v]) {
            findings.add(Violation::NotFinite { vertex: v })?;
        }
    }
    findings.checked(Rule::G1, checked);
    let bends = &columns.bends;
    for place in (0..bends.points.len()).filter(|place| !in_range(bends.points[*place])) {
        let (half_edge, bend) = bends.owner(place);
        findings.add(Violation::BendNotFinite { half_edge, bend })?;
    }
    for half_edge in columns.half_edges().filter(|h| columns.is_asked(*h)) {
        if bends.range(half_edge).is_empty() {
            if columns.tail(half_edge) == columns.head(half_edge) {
                findings.add(Violation::ZeroLength { half_edge })?;
            }
            continue;
        }
        let mut from = columns.tail(half_edge);
        for (segment, to) in columns.line(half_edge).enumerate() {
            if std::mem::replace(&mut from, to) == to {
                findings.add(Violation::SegmentZeroLength { half_edge, segment })?;
            }
        }
    }
    Ok(())
}

/// G2 angles: half-edges around a vertex are in angular order.
///
/// In one clockwise turn around a vertex, the angle rises exactly once. An edge with bends has the direction to its nearest bend.
pub(crate) fn angles(findings: &mut Findings, columns: &Columns) -> Flow {
    let mut seen = vec![false; columns.points.len()];
    let mut checked = 0;
    // A walk ends at an open boundary, so it begins at the half-edge that follows that border.
    let borders = columns.half_edges().filter(|h| columns.twin[*h] == NIL).map(|h| columns.next(h));
    for first in borders.chain(columns.half_edges()) {
        let v = columns.origin(first);
        if std::mem::replace(&mut seen[v], true) {
            continue;
        }
        checked += 1;
        let center = columns.points[v];
        let mut rises = 0;
        let mut h = first;
        while let Some(after) = columns.clockwise(h) {
            if compare_angle(center, columns.towards(h), columns.towards(after)) == Ordering::Less {
                rises += 1;
                if rises > 1 {
                    findings.add(Violation::OutOfOrder { vertex: v, half_edge: h, found: after })?;
                    break;
                }
            }
            h = after;
            if h == first {
                break;
            }
        }
    }
    findings.checked(Rule::G2, checked);
    Ok(())
}

/// G3 winding: outer cycles turn counter-clockwise, inner ones clockwise.
pub(crate) fn winding(findings: &mut Findings, columns: &Columns, lists: &Lists) -> Flow {
    let mut checked = 0;
    let mut seen = vec![false; columns.origin.len()];
    for Listed { boundary, start, is_outer, .. } in &lists.all {
        // By B1, no two boundary components start on one cycle.
        let Start::HalfEdge(h) = *start else { continue };
        if seen[h] {
            continue;
        }
        checked += 1;
        match (is_outer, turns_clockwise(columns, h, &mut seen)) {
            (true, true) => findings.add(Violation::OuterClockwise { boundary: *boundary })?,
            (false, false) => findings.add(Violation::InnerCounterClockwise { boundary: *boundary })?,
            _ => {}
        }
    }
    findings.checked(Rule::G3, checked);
    Ok(())
}

/// Returns true if the face lies outside the cycle: at the lexicographically smallest point, a vertex or a bend, the face lies to
/// the left. A cycle may pass that point more than once.
fn turns_clockwise(columns: &Columns, start: usize, seen: &mut [bool]) -> bool {
    let mut low = columns.tail(start);
    let mut around = false;
    let (mut before, mut at) = (low, columns.towards(start));
    let mut pass = |after: Point| {
        match compare_lexicographic(at, low) {
            Ordering::Less => {
                low = at;
                around = corner_opens_left(before, at, after);
            }
            Ordering::Equal => around |= corner_opens_left(before, at, after),
            Ordering::Greater => {}
        }
        (before, at) = (at, after);
    };
    let mut h = start;
    // The walk already starts at the first point of the cycle's line.
    let mut skip = 1;
    loop {
        seen[h] = true;
        columns.line(h).skip(skip).for_each(&mut pass);
        skip = 0;
        h = columns.next(h);
        if h == start {
            pass(columns.towards(start));
            return around;
        }
    }
}

/// Returns true if the corner left of the path `before`, `at`, `after` contains the direction to the left; `at` is the least.
fn corner_opens_left(before: Point, at: Point, after: Point) -> bool {
    before == after || orientation(at, before, after) == Orientation::CounterClockwise
}

/// G4 disjoint: edges meet only at shared endpoints.
///
/// Returns the segment below the smallest point of each component, or `None` for too many segments or a broken G4.
pub(crate) fn disjoint(
    findings: &mut Findings,
    columns: &Columns,
    segments: &Segments,
    components: &Components,
) -> Result<Option<Vec<Option<u32>>>, Halt> {
    findings.checked(Rule::G4, segments.edges as u64);
    let lowest = components.lowest.iter().zip(&components.lowest_bend);
    let number = |(vertex, bend): (&u32, &u32)| match *bend {
        NIL => segments.numbers[*vertex as usize],
        place => segments.bend(place as usize),
    };
    let queries: Vec<u32> = lowest.map(number).collect();
    // The arrays describe segments: G1 holds, and `Segments::of` issued every number.
    let Ok(swept) = sweep_plane(&segments.points, &segments.ends) else {
        findings.not_checked(Rule::G4, Unchecked::TooLarge);
        return Ok(None);
    };
    if swept.is_none() {
        let (found, total) =
            clashes(&segments.points, &segments.ends, findings.cap()).unwrap_or_else(|_| (Vec::new(), 0));
        let kept = found.len() as u64;
        for clash in found {
            findings.add(segments.violation(columns, clash))?;
        }
        findings.add_uncollected(Rule::G4, total.saturating_sub(kept));
    }
    Ok(swept.map(|below| below.of(&queries)))
}

/// G5 inside: each inner boundary component lies in the face that lists it, and a component that no face lists lies in no face.
///
/// The lowest point may be a bend. Without a record of the unbounded face, unlisted components lie outside everything.
///
/// The input: the embedding, and the results of earlier steps.
pub(crate) struct Inside<'a, E: ?Sized> {
    pub(crate) embedding: &'a E,
    pub(crate) parts: Parts,
    pub(crate) columns: &'a Columns,
    pub(crate) components: &'a Components,
    pub(crate) segments: &'a Segments,
    /// The segment below the lowest point of each component.
    pub(crate) below: &'a [Option<u32>],
    pub(crate) lists: &'a Lists,
}

impl<E: Embedding + ?Sized> Inside<'_, E> {
    fn face_of(&self, h: usize) -> Link {
        let face = if self.parts.has(Part::BoundaryComponents) {
            let b = self.embedding.boundary(h).filter(|b| *b < self.embedding.boundary_slots())?;
            self.embedding.boundary_face(b)
        } else {
            self.embedding.face(h)
        };
        face.filter(|f| *f < self.embedding.face_slots())
    }

    fn faces_around(&self) -> Vec<Link> {
        let around = |segment: &Option<u32>| match segment {
            Some(segment) => self.segments.above(self.columns, *segment).and_then(|h| self.face_of(h)),
            None => self.lists.unbounded,
        };
        self.below.iter().map(around).collect()
    }

    /// Runs G5. If there is an edge below the lowest point of a component, the component lies in the face above that edge, if
    /// any. Otherwise it lies in the unbounded face, if there is a record of it. The face above the edge is the correct one if
    /// all components that start further to the left are in the correct face; so one pass proves all.
    pub(crate) fn check(&self, findings: &mut Findings) -> Flow {
        let lies_in = self.faces_around();
        let mut is_listed = vec![false; lies_in.len()];
        let mut checked = 0;
        for Listed { face, boundary, start, .. } in self.lists.all.iter().filter(|one| !one.is_outer) {
            checked += 1;
            let vertex = match *start {
                Start::Vertex(v) => v,
                Start::HalfEdge(h) => self.columns.origin(h),
            };
            // By T1, this cycle or vertex is the outside of its component.
            let component = self.components.of[vertex] as usize;
            is_listed[component] = true;
            let found = lies_in[component];
            if found != Some(*face) {
                findings.add(Violation::WrongFace { boundary: *boundary, face: *face, found })?;
            }
        }
        findings.checked(Rule::G5, checked);
        // A component that lies in no face has no inner boundary component. Otherwise the face that contains it must list it.
        for (component, found) in lies_in.into_iter().enumerate() {
            let unlisted = !is_listed[component] && found != self.lists.unbounded;
            if let Some(face) = found.filter(|_| unlisted) {
                findings.add(Violation::Unlisted { vertex: self.components.lowest[component] as usize, face })?;
            }
        }
        Ok(())
    }
}
