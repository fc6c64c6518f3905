//! Drawing a chain of segments: planned as a whole, then applied.

use super::at::At;
use super::error::EditError;
use super::outcome::Edited;
use crate::locate::Located;
use crate::planar_map::PlanarMap;
use rustc_hash::FxHashMap;
use twinedge::dcel::{OperatorError, RecordKind, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, meeting};
use twinedge_geometry::sweep::sweep_plane;

/// A chain that is known to cross nothing.
struct ChainPlan {
    points: Vec<Point>,
    places: Vec<Located>,
    /// For each segment, the vertices of the map on it.
    stops: Vec<Vec<VertexKey>>,
    /// True if segments of the chain meet only at its points.
    simple: bool,
}

/// Returns a key that is equal for equal points. Callers never pass −0.
pub(super) fn bits(p: Point) -> [u64; 2] {
    [p.x.to_bits(), p.y.to_bits()]
}

impl PlanarMap {
    /// Draws a chain of segments, closed or not.
    pub(super) fn draw(&mut self, points: &[At], closed: bool) -> Result<Edited, EditError> {
        self.editable()?;
        let plan = self.plan(points, closed)?;
        self.room_for_drawing(plan.points.len() + plan.stops.iter().map(Vec::len).sum::<usize>())?;
        self.atomically(|map| map.draw_planned(plan))
    }

    fn draw_planned(&mut self, plan: ChainPlan) -> Result<Edited, EditError> {
        let mut edited = Edited::default();
        let mut made = FxHashMap::default();
        for (p, place) in plan.points.iter().zip(&plan.places) {
            let v = match made.get(&bits(*p)) {
                Some(v) => *v,
                None => self.realise(*p, *place, &mut edited)?,
            };
            made.insert(bits(*p), v);
            edited.vertices.push(v);
        }
        for (i, stops) in plan.stops.into_iter().enumerate() {
            let next = (i + 1) % plan.points.len();
            let (mut from, to) = (edited.vertices[i], edited.vertices[next]);
            let stops = if plan.simple {
                stops
            } else {
                // A point of the chain may lie on this segment and may not have been a vertex when the segment was planned.
                self.trace(Located::Vertex(from), plan.points[i], plan.points[next])?.stops
            };
            for stop in stops.into_iter().chain([to]) {
                let h = self.join(from, stop, &mut edited)?;
                edited.way.push(h);
                from = stop;
            }
        }
        Ok(edited)
    }

    fn plan(&self, chain: &[At], closed: bool) -> Result<ChainPlan, EditError> {
        let points = chain.iter().map(|at| self.point_of(*at)).collect::<Result<Vec<Point>, EditError>>()?;
        let ways: Vec<[Point; 2]> = points.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let closing = match (points.as_slice(), closed) {
            ([first, .., last], true) => Some([*last, *first]),
            _ => None,
        };
        let ways: Vec<[Point; 2]> = ways.into_iter().chain(closing).collect();
        if let Some([Point { x, y }, _]) = ways.iter().find(|[from, to]| from == to) {
            return Err(EditError::NoLength { x: *x, y: *y });
        }
        let Some(first) = chain.first() else {
            return Ok(ChainPlan { points, places: Vec::new(), stops: Vec::new(), simple: true });
        };
        let mut places = vec![self.place_of(*first)?];
        let mut stops = Vec::with_capacity(ways.len());
        for (i, [from, to]) in ways.iter().enumerate() {
            let trace = self.trace(places[i], *from, *to)?;
            stops.push(trace.stops);
            places.push(trace.end);
        }
        places.truncate(points.len());
        let simple = is_simple(&ways)?;
        Ok(ChainPlan { points, places, stops, simple })
    }
}

/// Returns true if segments meet only at shared ends, or an error if two of them cross. O(m log m) for true, otherwise O(m²).
fn is_simple(ways: &[[Point; 2]]) -> Result<bool, EditError> {
    if ways.len() < 2 {
        return Ok(true);
    }
    let mut points = Vec::new();
    let mut numbers = FxHashMap::default();
    let mut number = |p: Point| {
        *numbers.entry(bits(p)).or_insert_with(|| {
            points.push(p);
            points.len() as u32 - 1
        })
    };
    let segments: Vec<[u32; 2]> = ways.iter().map(|ends| ends.map(&mut number)).collect();
    let swept = sweep_plane(&points, &segments).map_err(|_| OperatorError::Full(RecordKind::Vertex))?;
    if swept.is_some() {
        return Ok(true);
    }
    for (second, [c, d]) in ways.iter().enumerate() {
        let crosses = |[a, b]: &[Point; 2]| meeting(*a, *b, *c, *d) == Meeting::Cross;
        if let Some(first) = ways[..second].iter().position(crosses) {
            return Err(EditError::SelfCrossing { first, second });
        }
    }
    Ok(false)
}
