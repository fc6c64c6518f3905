//! A plane drawing, cut into slabs by the walls of some of its vertices.
//!
//! ```text
//!      0   :  1  :  2  :   3
//!          :     b     :         A wall runs up and down from its vertex for ever. Slabs may be narrow or wide; each has about
//!          :     :     :         as many vertices as any other. A segment is drawn, whole, in each slab of which it has a part.
//!          a     :     :
//!          :     :     c
//! ```
//!
//! The nearest segments above and below a point are among the segments of its slab. So each slab can have its own search graph,
//! small enough to stay in a cache during construction, and several threads can build them.
//!
//! Few segments pass from one slab to the next: while there are too many, the number of slabs is halved. If most segments are
//! long, as in fans and long parallels, one slab is left. So all slabs together have O(n) segments.

use super::lists::Lists;
use super::trapezoids::Drawing;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;

/// The approximate minimum number of vertices per slab.
const LEAST: usize = 512;

/// The number of vertices of the sample between two neighbouring walls.
const SAMPLED: usize = 8;

/// On average, at most one of this number of segments may pass through a wall. Such a segment is drawn twice.
const PASSING: usize = 8;

/// The slabs of a drawing; their number is a power of two. In lexicographic order, slab i begins with vertex i - 1 of the walls
/// and ends before vertex i.
pub(super) struct Slabs {
    /// The vertices whose walls separate the slabs, in lexicographic order.
    pub(super) walls: Vec<u32>,
    points: Lists,
    segments: Lists,
    /// The position of each point in the list of its slab.
    places: Vec<u32>,
}

/// A drawing of the points and segments with a part in a slab, and their numbers in the whole drawing.
pub(super) struct Slab {
    pub(super) drawn: Drawing,
    pub(super) points: Vec<u32>,
    pub(super) segments: Vec<u32>,
}

impl Slabs {
    /// Cuts a drawing. O(n log n).
    pub(super) fn new(drawn: &Drawing) -> Self {
        let halvings = (drawn.points.len() / LEAST).checked_ilog2().unwrap_or(0);
        let mut walls = quantiles(&drawn.points, 1 << halvings);
        let at_walls: Vec<Point> = walls.iter().map(|wall| drawn.points[*wall as usize]).collect();
        let slab = |p: &Point| at_walls.partition_point(|wall| compare_lexicographic(*wall, *p).is_le()) as u32;
        let mut slabs: Vec<u32> = drawn.points.iter().map(slab).collect();
        // Counts the passes of segments through walls that remain after some halvings.
        let passes = |halvings: u32| -> usize {
            let slab = |end: u32| slabs[end as usize] >> halvings;
            drawn.segments.iter().map(|[low, high]| (slab(*high) - slab(*low)) as usize).sum()
        };
        let most = drawn.segments.len() / PASSING;
        let halved = (0..halvings).find(|halved| passes(*halved) <= most).unwrap_or(halvings);
        walls = walls.into_iter().skip((1 << halved) - 1).step_by(1 << halved).collect();
        for slab in &mut slabs {
            *slab >>= halved;
        }

        let count = walls.len() + 1;
        let points = Lists::new(count, slabs.iter().map(|slab| [*slab; 2]));
        let segments = Lists::new(count, drawn.segments.iter().map(|ends| ends.map(|end| slabs[end as usize])));
        let mut places = vec![0; drawn.points.len()];
        for slab in 0..count {
            for (place, point) in (0..).zip(points.list(slab)) {
                places[*point as usize] = place;
            }
        }
        Self { walls, points, segments, places }
    }

    pub(super) fn len(&self) -> usize {
        self.walls.len() + 1
    }

    /// Returns the contents of a slab: its points, then the endpoints outside it of segments that pass through its walls.
    pub(super) fn slab(&self, slab: usize, drawn: &Drawing) -> Slab {
        let own = self.points.list(slab);
        let place = |point: u32| {
            let place = self.places[point as usize];
            (own.get(place as usize) == Some(&point)).then_some(place)
        };
        let segments = self.segments.list(slab).to_vec();
        let ends = segments.iter().flat_map(|segment| drawn.segments[*segment as usize]);
        let mut outside: Vec<u32> = ends.filter(|end| place(*end).is_none()).collect();
        outside.sort_unstable();
        outside.dedup();
        let number =
            |end: u32| place(end).unwrap_or_else(|| (own.len() + outside.partition_point(|other| *other < end)) as u32);
        let ends = segments.iter().map(|segment| drawn.segments[*segment as usize].map(number)).collect();
        let points = [own, &outside].concat();
        let drawn = Drawing {
            points: points.iter().map(|point| drawn.points[*point as usize]).collect(),
            ends: segments.iter().map(|segment| drawn.ends[*segment as usize]).collect(),
            segments: ends,
        };
        Slab { drawn, points, segments }
    }
}

/// Returns points, in lexicographic order, that divide the given points into `parts` parts of about the same size. O(n).
fn quantiles(points: &[Point], parts: usize) -> Vec<u32> {
    let step = (points.len() / (SAMPLED * parts)).max(1);
    let mut sample: Vec<u32> = (0..points.len() as u32).step_by(step).collect();
    sample.sort_by(|a, b| compare_lexicographic(points[*a as usize], points[*b as usize]));
    (1..parts).map(|part| sample[part * sample.len() / parts]).collect()
}
