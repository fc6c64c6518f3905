//! Cutting gathered segments where they meet, before a map is built from them.

use super::error::BuildError;
use super::gathered::{Dart, GatheredFeatures};
use rustc_hash::FxHashMap;
use twinedge::dcel::RecordKind;
use twinedge_geometry::Point;
use twinedge_geometry::bounds::Bounds;
use twinedge_geometry::boxes::Boxes;
use twinedge_geometry::noding::{NodingError, NodingSummary, Snap, node_numbered};
use twinedge_geometry::predicates::{MIN_COORDINATE, compare_lexicographic, on_segment};

/// The treatment of segments that meet other than at shared endpoints.
///
/// ```text
///            \ /               \ /              \ /
///     None    X         Exact   X       Snap     o       o: a new vertex, on the grid
///            / \  /            / \  /           / \  /
///       ----------        ------o---       ------o---
///       not plane          an error           plane
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Noding {
    /// Builds the map from the segments as they are; [`PlanarMap::validate`](crate::PlanarMap::validate) reports any faults.
    #[default]
    None,
    /// Cuts segments at the input points that lie exactly on them. Nothing moves and no point is added, so two segments that
    /// cross where the input has no point are an error, [`BuildError::Crossing`].
    Exact,
    /// Cuts segments wherever they meet and rounds everything to a grid, by [snap rounding](twinedge_geometry::noding). On finite
    /// input this fails only if coordinates are out of reach of the grid.
    Snap(Snap),
}

pub(super) struct CutSegments {
    pub(super) points: Vec<Point>,
    pub(super) segments: Vec<[u32; 2]>,
    pub(super) summary: NodingSummary,
}

/// The pieces of each segment as darts, in the direction from its first end to its second.
struct Pieces {
    darts: Vec<Dart>,
    starts: Vec<usize>,
}

impl Pieces {
    fn new(segments: usize) -> Self {
        Self { darts: Vec::with_capacity(segments), starts: vec![0] }
    }

    /// Adds the next segment, given by the vertices along it. `number` returns the number of a piece by its ends, smaller first.
    fn push(&mut self, chain: impl Iterator<Item = u32>, mut number: impl FnMut([u32; 2]) -> Option<u32>) {
        let mut last = None;
        for to in chain {
            if let Some(from) = last.replace(to).filter(|from| *from != to) {
                let number = number([from.min(to), from.max(to)]);
                self.darts.extend(number.map(|number| number << 1 | u32::from(from > to)));
            }
        }
        self.starts.push(self.darts.len());
    }

    /// Replaces the segments that features use by their pieces.
    fn follow(&self, features: &mut GatheredFeatures) {
        features.replace(|out, dart| {
            let segment = (dart >> 1) as usize;
            let pieces = &self.darts[self.starts[segment]..self.starts[segment + 1]];
            if dart & 1 == 0 {
                out.extend_from_slice(pieces);
            } else {
                out.extend(pieces.iter().rev().map(|piece| piece ^ 1));
            }
        });
    }
}

struct Numbers<'a> {
    segments: &'a [[u32; 2]],
    /// The index of each point's first segment, and the number of segments.
    first: Vec<u32>,
}

impl<'a> Numbers<'a> {
    fn new(segments: &'a [[u32; 2]], points: usize) -> Self {
        let mut first = vec![0; points + 1];
        for [point, _] in segments {
            first[*point as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        Self { segments, first }
    }

    /// Returns the number of the segment with these ends. O(log degree).
    fn of(&self, ends: [u32; 2]) -> Option<u32> {
        let [from, to] = [0, 1].map(|i| self.first[ends[0] as usize + i]);
        let place = self.segments[from as usize..to as usize].binary_search(&ends).ok()?;
        Some(from + place as u32)
    }
}

/// Cuts segments at the points that lie on them. O((n + k) log n) for k points in bounding boxes, but not in the worst case.
pub(super) fn exact(
    points: Vec<Point>,
    segments: &[[u32; 2]],
    features: &mut GatheredFeatures,
) -> Result<CutSegments, BuildError> {
    let at = |v: u32| Bounds::one(points[v as usize]);
    let tree = Boxes::new(0..points.len() as u32, &at);
    let mut out = Vec::with_capacity(segments.len());
    let mut numbers: FxHashMap<[u32; 2], u32> = FxHashMap::default();
    let mut pieces = Pieces::new(segments.len());
    let mut summary = NodingSummary::default();
    let mut full = false;
    for [from, to] in segments {
        let (a, b) = (points[*from as usize], points[*to as usize]);
        let mut along = tree.meeting(&Bounds::one(a).joined(Bounds::one(b)));
        along.retain(|v| on_segment(points[*v as usize], a, b));
        let forth = compare_lexicographic(a, b);
        along.sort_by(|p, q| {
            let order = compare_lexicographic(points[*p as usize], points[*q as usize]);
            if forth.is_lt() { order } else { order.reverse() }
        });
        summary.split += usize::from(along.len() > 2);
        pieces.push(along.into_iter(), |ends| {
            if let Some(number) = numbers.get(&ends) {
                return Some(*number);
            }
            let number = u32::try_from(out.len()).ok().filter(|number| *number < 1 << 30);
            full |= number.is_none();
            numbers.extend(number.map(|number| (ends, number)));
            out.extend(number.map(|_| ends));
            number
        });
    }
    if full {
        return Err(BuildError::Full(RecordKind::Edge));
    }
    summary.duplicates = pieces.darts.len() - out.len();
    pieces.follow(features);
    Ok(CutSegments { points, segments: out, summary })
}

/// Returns the number of cuts that [`Builder`](crate::Builder) allows by default for this number of segments. O(1).
#[must_use]
pub const fn usual_cuts(segments: usize) -> usize {
    segments.saturating_mul(16).saturating_add(1 << 20)
}

/// Cuts segments wherever they meet, and rounds to a grid; see [`noding`](twinedge_geometry::noding).
pub(super) fn snapped(
    points: Vec<Point>,
    segments: Vec<[u32; 2]>,
    features: &mut GatheredFeatures,
    snap: Snap,
    cuts: usize,
) -> Result<CutSegments, BuildError> {
    // The predicates must also be exact on grid points.
    if matches!(snap, Snap::Size(size) if size < MIN_COORDINATE) {
        return Err(BuildError::CellSize);
    }
    let noded = match node_numbered(&points, &segments, snap, cuts) {
        Ok(noded) if noded.summary.cell < MIN_COORDINATE => {
            node_numbered(&points, &segments, Snap::Size(MIN_COORDINATE), cuts)
        }
        outcome => outcome,
    };
    let noded = noded.map_err(|error| match error {
        NodingError::Size => BuildError::CellSize,
        NodingError::NotFinite { at } | NodingError::OutOfRange { at } => {
            let p = at.point(&[], &points).unwrap_or_default();
            BuildError::OutOfReach { x: p.x, y: p.y }
        }
        NodingError::TooManyCuts { allowed } => BuildError::TooManyCuts { allowed },
        // Too many segments.
        _ => BuildError::Full(RecordKind::Vertex),
    })?;
    if noded.points.len().max(noded.segments.len()) >= 1 << 30 {
        return Err(BuildError::Full(RecordKind::Edge));
    }
    let count = segments.len();
    drop((points, segments));
    let number = Numbers::new(&noded.segments, noded.points.len());
    let mut pieces = Pieces::new(count);
    for segment in 0..count {
        pieces.push(noded.chain(segment).into_iter().flatten(), |ends| number.of(ends));
    }
    pieces.follow(features);
    Ok(CutSegments { points: noded.points, segments: noded.segments, summary: noded.summary })
}
