//! From points and segments to a subdivision: rotations, cycles, faces and their nesting.
//!
//! ```text
//!   segments ─► rotations, sorted by angle ─► next ─► cycles ─► outer ones get a face each
//!          │                                             └───► the outside of each component: the edge below its lowest
//!          └──► one sweep ─► the edges below, a clash ─────────► vertex, and thereby the face it lies in
//! ```
//!
//! Source: de Berg et al., "Computational Geometry", 3rd edition, section 2.3.

use super::error::BuildError;
use super::gathered::{Dart, target};
use crate::numbers::{NIL, Sets, cycles};
use core::cmp::Ordering;
use twinedge::dcel::extend::{Assembly, AssemblyError, BoundaryStart, VertexLink};
use twinedge::dcel::{Dcel, RecordKind};
use twinedge_geometry::crossing::Clash;
use twinedge_geometry::predicates::{compare_angle, compare_lexicographic};
use twinedge_geometry::sweep::sweep_all;
use twinedge_geometry::{Point, threads};

/// Below this number of darts, the work is not divided among threads.
const MANY: usize = 1 << 14;

const UNBOUNDED: u32 = 0;

pub(super) struct Placement {
    /// The lexicographically smallest point of each component, from left to right.
    lowest: Vec<u32>,
    /// The segment directly below each of these points.
    below: Vec<Option<u32>>,
    /// The first place where segments meet other than at shared endpoints, or `None`.
    pub(super) clash: Option<Clash>,
}

impl Placement {
    /// Sweeps over distinct points and distinct segments in range. O(n log n).
    pub(super) fn new(points: &[Point], segments: &[[u32; 2]]) -> Result<Self, BuildError> {
        let (lowest, swept) = threads::join(|| lowest_points(points, segments), || sweep_all(points, segments));
        let (below, clash) = swept.map_err(|_| BuildError::Full(RecordKind::Vertex))?;
        Ok(Self { below: below.of(&lowest), lowest, clash })
    }
}

pub(super) const fn half_edge(dart: Dart) -> u32 {
    Assembly::half_edge_index(dart)
}

/// Returns the points by index of their vertex.
pub(super) fn points_by_vertex(mut points: Vec<Point>) -> Vec<Point> {
    let unused = Assembly::vertex_index(0) as usize;
    points.reserve_exact(unused);
    points.splice(0..0, core::iter::repeat_n(Point::default(), unused));
    points
}

/// The darts that leave each point, counter-clockwise from the positive x axis.
struct Rotations {
    first: Vec<u32>,
    darts: Vec<Dart>,
}

impl Rotations {
    fn new(points: &[Point], segments: &[[u32; 2]]) -> Self {
        let mut first = vec![0_u32; points.len() + 1];
        for [a, b] in segments {
            first[*a as usize + 1] += 1;
            first[*b as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let mut free = first.clone();
        let mut darts = vec![NIL; 2 * segments.len()];
        for (dart, from) in segments.iter().flatten().enumerate() {
            let place = &mut free[*from as usize];
            darts[*place as usize] = dart as u32;
            *place += 1;
        }
        sort_by_angle(points, segments, 0, &first, &mut darts);
        Self { first, darts }
    }

    fn range(&self, v: usize) -> core::ops::Range<usize> {
        self.first[v] as usize..self.first[v + 1] as usize
    }

    fn leaving(&self, v: usize) -> &[Dart] {
        &self.darts[self.range(v)]
    }
}

/// Sorts the darts that leave each point, starting with point number `from`. `first` holds the index of each point's first dart,
/// and the end, counted from the first dart of all.
fn sort_by_angle(points: &[Point], segments: &[[u32; 2]], from: usize, first: &[u32], darts: &mut [Dart]) {
    let of = first.len() - 1;
    let place = |i: usize| (first[i] - first[0]) as usize;
    if of > 1 && darts.len() > MANY {
        let (half, middle) = (of / 2, place(of / 2));
        let (these, others) = darts.split_at_mut(middle);
        threads::join(
            || sort_by_angle(points, segments, from, &first[..=half], these),
            || sort_by_angle(points, segments, from + half, &first[half..], others),
        );
        return;
    }
    for i in 0..of {
        let leaving = &mut darts[place(i)..place(i + 1)];
        let (at, head) = (points[from + i], |d: &Dart| points[target(segments, *d) as usize]);
        // Darts of segments that overlap leave in the same direction.
        let order = |a: &Dart, b: &Dart| compare_angle(at, head(a), head(b)).then(a.cmp(b));
        match leaving {
            [] | [_] => {}
            // Most points of most drawings are like this.
            [a, b] if order(a, b).is_le() => {}
            [a, b] => core::mem::swap(a, b),
            _ => threads::sort_unstable_by(leaving, order),
        }
    }
}

struct Cycles {
    next: Vec<Dart>,
    of: Vec<u32>,
    starts: Vec<Dart>,
}

impl Cycles {
    fn new(rotations: &Rotations, points: usize) -> Self {
        let count = rotations.darts.len();
        let mut next = vec![NIL; count];
        for v in 0..points {
            let leaving = rotations.leaving(v);
            let Some(last) = leaving.last() else { continue };
            // The next dart after an arriving dart is the dart clockwise of its twin.
            let mut clockwise = *last;
            for dart in leaving {
                next[*dart as usize ^ 1] = clockwise;
                clockwise = *dart;
            }
        }
        let (of, starts) = cycles(&next);
        Self { next, of, starts }
    }
}

/// The rotations of points and segments, and their cycles.
pub(super) struct CombinatorialMap {
    rotations: Rotations,
    cycles: Cycles,
}

impl CombinatorialMap {
    /// O(n log n).
    pub(super) fn new(points: &[Point], segments: &[[u32; 2]]) -> Self {
        let rotations = Rotations::new(points, segments);
        let cycles = Cycles::new(&rotations, points.len());
        Self { rotations, cycles }
    }
}

/// Returns the lexicographically smallest point of each connected component, smallest first.
fn lowest_points(points: &[Point], segments: &[[u32; 2]]) -> Vec<u32> {
    let is_less = |a: u32, b: u32| compare_lexicographic(points[a as usize], points[b as usize]) == Ordering::Less;
    let mut sets = Sets::new(points.len());
    for [a, b] in segments {
        sets.join(*a, *b);
    }
    let mut lowest = vec![NIL; points.len()];
    for v in 0..points.len() as u32 {
        let low = &mut lowest[sets.find(v) as usize];
        if *low == NIL || is_less(v, *low) {
            *low = v;
        }
    }
    lowest.retain(|v| *v != NIL);
    threads::sort_unstable_by(&mut lowest, |a, b| compare_lexicographic(points[*a as usize], points[*b as usize]));
    lowest
}

/// Returns the dart at the lowest point of a component whose corner contains the direction straight left. It lies on the outside.
fn outside_dart(rotations: &Rotations, points: &[Point], segments: &[[u32; 2]], low: u32) -> Option<Dart> {
    let at = points[low as usize];
    let leaving = rotations.leaving(low as usize);
    // Everything lies to the right, first upwards from the axis, then from straight down to the axis.
    let upper = leaving.partition_point(|d| {
        let head = points[target(segments, *d) as usize];
        head.y >= at.y
    });
    leaving.get(upper.wrapping_sub(1)).or(leaving.last()).copied()
}

/// Arranges distinct points and distinct segments in range into a subdivision, given the sweep and the rotations. O(n log n).
pub(super) fn arrange(
    points: &[Point],
    segments: &[[u32; 2]],
    swept: &Placement,
    turned: CombinatorialMap,
) -> Result<Dcel, BuildError> {
    let Placement { lowest, below, .. } = swept;
    let CombinatorialMap { rotations, cycles } = turned;

    // Marks each cycle on the outside of its component and finds the face that contains the component.
    let mut outside = vec![false; cycles.starts.len()];
    let outside_darts: Vec<_> = lowest.iter().map(|v| outside_dart(&rotations, points, segments, *v)).collect();
    for dart in outside_darts.iter().flatten() {
        outside[cycles.of[*dart as usize] as usize] = true;
    }

    // Each cycle bounds a face of its own, unless it is the outside of its component; the component then lies in another face.
    let mut outer = Vec::with_capacity(outside.len());
    let mut face_of = vec![UNBOUNDED; outside.len()];
    for (cycle, _) in (0..).zip(&outside).filter(|(_, outside)| !**outside) {
        outer.push(cycle);
        face_of[cycle as usize] = outer.len() as u32;
    }
    let mut vertices: Vec<VertexLink<u32, u32>> =
        (0..points.len()).map(|v| VertexLink::Leaving(rotations.leaving(v).first().copied().unwrap_or(NIL))).collect();
    drop(rotations);
    let mut starts: Vec<BoundaryStart<u32, u32>> = cycles.starts.iter().copied().map(BoundaryStart::HalfEdge).collect();
    let mut inner = Vec::with_capacity(lowest.len());
    // Left to right, so the face of the segment below a component is already known.
    for ((low, dart), below) in lowest.iter().zip(&outside_darts).zip(below) {
        let face = below.map_or(UNBOUNDED, |segment| {
            let [a, b] = segments[segment as usize];
            let rises = compare_lexicographic(points[a as usize], points[b as usize]) == Ordering::Less;
            let above = segment << 1 | u32::from(!rises);
            face_of[cycles.of[above as usize] as usize]
        });
        let boundary = if let Some(dart) = dart {
            let cycle = cycles.of[*dart as usize];
            face_of[cycle as usize] = face;
            cycle
        } else {
            let boundary = starts.len() as u32;
            starts.push(BoundaryStart::Vertex(*low));
            vertices[*low as usize] = VertexLink::Isolated(boundary);
            boundary
        };
        inner.push((face, boundary));
    }
    let assembly = Assembly {
        vertices: &vertices,
        // The point where dart 2s + i starts is the i-th end of segment s.
        origin: segments.as_flattened(),
        next: &cycles.next,
        boundary: &cycles.of,
        starts: &starts,
        outer: &outer,
        inner: &inner,
    };
    assembly.assemble().map_err(|error| match error {
        AssemblyError::Full(kind) => BuildError::Full(kind),
        // These columns are valid by construction.
        _ => BuildError::Full(RecordKind::Vertex),
    })
}
