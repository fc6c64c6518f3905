//! All places where arcs meet elsewhere than at common ends.

use crate::place::Place;
use crate::predicates::meeting;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};
use twinedge::geometry::predicates::{Endpoint, Meeting};

/// A reason why arcs do not draw a map. Places and arcs are named by their numbers; of two arcs the smaller comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Clash {
    /// Two arcs cross in a place inside both.
    Cross {
        /// The arcs.
        arcs: [u32; 2],
    },
    /// Two arcs of one great circle have more than a place in common.
    Overlap {
        /// The arcs.
        arcs: [u32; 2],
    },
    /// A place that is the end of an arc lies inside another one.
    Touch {
        /// The place.
        place: u32,
        /// The arc.
        arc: u32,
    },
}

/// All clashes of arcs between these places, sorted, each once. Of two arcs that end at the same place, one that touches a third is enough.
///
/// O(n log n + p log p) for n arcs, and p pairs of which the boxes in space meet: of short arcs, those that lie side by side.
#[must_use]
pub fn clashes(places: &[Place], arcs: &[[u32; 2]]) -> Vec<Clash> {
    clashes_of(places, arcs, 0)
}

/// The clashes of the arcs from a number on, among themselves and with those before, which have none among themselves.
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
            // Of two that are asked about, the smaller one asks.
            if one < other || (other as usize) < first {
                found.extend(classify(places, arcs, [one.min(other), one.max(other)]));
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

type Boxed = GeomWithData<Rectangle<[f64; 3]>, u32>;

/// A box around an arc. It reaches as far beyond that of the chord as the middle of the arc is from the middle of the chord, and rounding.
fn boxed(arc: u32, ends: [Place; 2]) -> Boxed {
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
