//! All places where arcs meet other than at common ends.

use crate::drawing::Drawing;
use crate::place::Place;
use crate::predicates::{meeting, on_arc};
use crate::vector::{cross, dot, minus};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Endpoint, Meeting};

/// A reason why arcs do not draw a map. Places and arcs are given by number, the smaller arc first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Clash {
    /// Two arcs cross at a place inside both.
    Cross {
        /// The arcs.
        arcs: [u32; 2],
    },
    /// Two arcs of one great circle share more than a place.
    Overlap {
        /// The arcs.
        arcs: [u32; 2],
    },
    /// A place that is the end of an arc lies inside another arc.
    Touch {
        /// The place.
        place: u32,
        /// The arc.
        arc: u32,
    },
}

impl Clash {
    /// Returns the place of a clash in degrees: the rounded crossing of two arcs, or for an overlap an end inside the other arc, or else a common
    /// end.
    #[must_use]
    pub fn at(&self, drawing: &Drawing) -> Point {
        let places = |arc: u32| drawing.arcs()[arc as usize].ends.map(|end| drawing.places()[end as usize]);
        match *self {
            Self::Cross { arcs } => {
                let [first, second] = arcs.map(places);
                crossing(first, second).degrees().into()
            }
            Self::Overlap { arcs: [first, second] } => {
                let pairs = [(first, second), (second, first)];
                let mut ends = pairs
                    .into_iter()
                    .flat_map(|(one, other)| drawing.arcs()[one as usize].ends.map(|end| (end, other)));
                let is_inside = |(end, other): &(u32, u32)| {
                    let ([a, b], p) = (places(*other), drawing.places()[*end as usize]);
                    p != a && p != b && on_arc(p, a, b)
                };
                let inside = ends.find(is_inside).map_or(drawing.arcs()[first as usize].ends[0], |(end, _)| end);
                drawing.degrees(inside)
            }
            Self::Touch { place, .. } => drawing.degrees(place),
        }
    }
}

/// Returns all clashes of arcs between these places, sorted and without duplicates. If several arcs end at the same place and touch a third arc
/// there, only one clash is reported.
///
/// O(n log n + p log p) for n arcs, and p pairs whose boxes in space meet: for short arcs, these lie side by side.
#[must_use]
pub fn clashes(places: &[Place], arcs: &[[u32; 2]]) -> Vec<Clash> {
    clashes_of(places, arcs, 0)
}

/// Returns the clashes of the arcs from `first` on, among themselves and with earlier arcs, which have no clashes among themselves.
pub(crate) fn clashes_of(places: &[Place], arcs: &[[u32; 2]], first: usize) -> Vec<Clash> {
    let boxes: Vec<_> = (0..).zip(arcs).map(|(arc, ends)| boxed(arc, ends.map(|end| places[end as usize]))).collect();
    let queries: Vec<_> = boxes[first..].to_vec();
    let tree = RTree::bulk_load(boxes);
    let mut found = Vec::new();
    for query in queries {
        let one = query.data;
        let window = AABB::from_corners(query.geom().lower(), query.geom().upper());
        for other in tree.locate_in_envelope_intersecting(window) {
            let other = other.data;
            // If both arcs of a pair are new, only the smaller number searches.
            if one < other || (other as usize) < first {
                found.extend(classify(places, arcs, [one.min(other), one.max(other)]));
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

pub(crate) type Boxed = GeomWithData<Rectangle<[f64; 3]>, u32>;

/// Returns a box around an arc, with its number. It extends beyond the chord's box by the distance between the middles of arc and chord, plus
/// rounding.
pub(crate) fn boxed(arc: u32, ends: [Place; 2]) -> Boxed {
    const ROUNDING: f64 = 1e-14;
    let [a, b] = ends.map(Place::unit);
    let square: f64 = (0..3).map(|i| (b[i] - a[i]).powi(2)).sum();
    let beyond = 1.0 - libm::sqrt((1.0 - square / 4.0).max(0.0)) + ROUNDING;
    let low = [0, 1, 2].map(|i| a[i].min(b[i]) - beyond);
    let high = [0, 1, 2].map(|i| a[i].max(b[i]) + beyond);
    GeomWithData::new(Rectangle::from_corners(low, high), arc)
}

fn classify(places: &[Place], arcs: &[[u32; 2]], pair: [u32; 2]) -> Option<Clash> {
    let [[a, b], [c, d]] = pair.map(|arc| arcs[arc as usize]);
    let at = |place: u32| places[place as usize];
    Some(match meeting(at(a), at(b), at(c), at(d)) {
        Meeting::Disjoint | Meeting::SharedEndpoint => return None,
        Meeting::Cross => Clash::Cross { arcs: pair },
        Meeting::Overlap => Clash::Overlap { arcs: pair },
        Meeting::Touch(end) => {
            let (place, arc) = match end {
                Endpoint::A => (a, pair[1]),
                Endpoint::B => (b, pair[1]),
                Endpoint::C => (c, pair[0]),
                Endpoint::D => (d, pair[0]),
            };
            Clash::Touch { place, arc }
        }
    })
}

/// Returns the rounded place where two arcs cross. The error is about 1e-16 radians, divided by the sine of the angle at which they cross.
pub(crate) fn crossing(first: [Place; 2], second: [Place; 2]) -> Place {
    let [[a, b], [c, d]] = [first.map(Place::unit), second.map(Place::unit)];
    let across = cross(c, minus(d, c));
    // The distances of the ends from the other arc's circle. Subtract first, because arcs are short.
    let beyond = |p: [f64; 3]| dot(across, minus(p, c)).abs();
    let (at_a, at_b) = (beyond(a), beyond(b));
    // Both are 0 only if the arcs differ by no more than rounding.
    Place::toward([0, 1, 2].map(|i| a[i] * at_b + b[i] * at_a)).unwrap_or(first[0])
}
