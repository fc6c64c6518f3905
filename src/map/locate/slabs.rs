//! A plane drawing, cut in slabs by the walls of some of its vertices.

use super::lists::Lists;
use super::trapezoids::Drawn;
use crate::geometry::Point;
use crate::geometry::predicates::compare_lexicographic;

/// About how many points a slab has at least.
const POINTS_PER_SLAB: usize = 512;

/// How many points of the sample are between neighbouring walls.
const SAMPLES_PER_SLAB: usize = 8;

/// Slabs of a drawing, 2^n of them. Slab i is what comes, in lexicographic order, after wall i - 1, that point included,
/// and before wall i.
pub(super) struct Slabs {
    /// The points at which the slabs meet, in lexicographic order.
    pub(super) walls: Vec<u32>,
    /// The points of each slab.
    points: Lists,
    /// The segments of which a part is in each slab.
    segments: Lists,
    /// The place of each point in the list of its slab.
    places: Vec<u32>,
}

/// One drawing of those, and what its points and segments are called in the whole.
pub(super) struct Slab {
    pub(super) drawn: Drawn,
    pub(super) points: Vec<u32>,
    pub(super) segments: Vec<u32>,
}

impl Slabs {
    pub(super) fn new(drawn: &Drawn) -> Self {
        let levels = (drawn.points.len() / POINTS_PER_SLAB).checked_ilog2().unwrap_or(0);
        let slabs = 1_usize << levels;
        let at = |point: u32| drawn.points[point as usize];
        let stride = (drawn.points.len() / (SAMPLES_PER_SLAB * slabs)).max(1);
        let mut sample: Vec<u32> = (0..drawn.points.len() as u32).step_by(stride).collect();
        sample.sort_unstable_by(|a, b| compare_lexicographic(at(*a), at(*b)));
        let mut walls: Vec<u32> = (1..slabs).map(|wall| sample[wall * sample.len() / slabs]).collect();
        let at_walls: Vec<Point> = walls.iter().map(|wall| at(*wall)).collect();
        let mut slab_of: Vec<u32> = drawn
            .points
            .iter()
            .map(|p| at_walls.partition_point(|wall| compare_lexicographic(*wall, *p).is_le()) as u32)
            .collect();
        // Fewer walls, until few segments pass through one.
        let mut crossings = vec![0_usize; levels as usize];
        for [low, high] in &drawn.segments {
            let [low, high] = [low, high].map(|end| slab_of[*end as usize]);
            if low != high {
                for level in 0..levels {
                    crossings[level as usize] += ((high >> level) - (low >> level)) as usize;
                }
            }
        }
        let limit = drawn.segments.len() / 8;
        let removed = crossings.iter().position(|crossings| *crossings <= limit).unwrap_or(levels as usize);
        let kept = slabs >> removed;
        walls = (1..kept).map(|wall| walls[(wall << removed) - 1]).collect();
        slab_of.iter_mut().for_each(|slab| *slab >>= removed);
        let points = Lists::new(kept, slab_of.iter().map(|slab| [*slab; 2]));
        let segments = Lists::new(kept, drawn.segments.iter().map(|ends| ends.map(|end| slab_of[end as usize])));
        let mut places = vec![0; drawn.points.len()];
        for slab in 0..kept {
            for (place, point) in (0..).zip(points.list(slab)) {
                places[*point as usize] = place;
            }
        }
        Self { walls, points, segments, places }
    }

    pub(super) fn len(&self) -> usize {
        self.walls.len() + 1
    }

    pub(super) fn slab(&self, slab: usize, drawn: &Drawn) -> Slab {
        let mut points = self.points.list(slab).to_vec();
        let own = points.len();
        let segments = self.segments.list(slab).to_vec();
        let is_own = |point: u32| points.get(self.places[point as usize] as usize) == Some(&point);
        let all_ends = segments.iter().flat_map(|segment| drawn.segments[*segment as usize]);
        let mut others: Vec<u32> = all_ends.filter(|end| !is_own(*end)).collect();
        others.sort_unstable();
        others.dedup();
        let ends = |segment: u32| {
            drawn.segments[segment as usize].map(|end| {
                if is_own(end) {
                    self.places[end as usize]
                } else {
                    (own + others.partition_point(|other| *other < end)) as u32
                }
            })
        };
        let ends: Vec<[u32; 2]> = segments.iter().map(|segment| ends(*segment)).collect();
        points.extend(others);
        let drawn = Drawn {
            points: points.iter().map(|point| drawn.points[*point as usize]).collect(),
            ends: segments.iter().map(|segment| drawn.ends[*segment as usize]).collect(),
            segments: ends,
        };
        Slab { drawn, points, segments }
    }
}
