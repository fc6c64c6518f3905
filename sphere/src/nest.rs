//! The faces in which components lie.
//!
//! From a place of each component a line goes along its meridian to the north pole, to the east of the meridian by less than anything: so it meets no
//! vertex, and arcs along meridians do not matter. All other arcs have one latitude for each longitude that they span. Above the last arc of the component itself, the first of another one is that of the face in which it lies.
//! If there is none, it lies in the face at the pole.
//!
//! Of two such arcs that do not cross, one is above the other wherever both are. So they are compared at an end that both span, by [`side`]: exactly.

use crate::noding::Network;
use crate::place::Place;
use crate::predicates::{compare_around, eastward, on_one_meridian, side};
use core::cmp::Ordering;
use twinedge::dcel::{Corner, Placement};
use twinedge_geometry::predicates::Orientation;

/// The number of stripes of longitudes into which arcs are sorted is at most so large.
const STRIPES: usize = 4096;

/// An arc that does not lie along a meridian, from the west to the east.
#[derive(Clone, Copy, Debug)]
struct Span {
    west: Place,
    east: Place,
    /// The dart to the east, which has the north to its left.
    dart: u32,
    component: u32,
}

impl Span {
    /// Returns true if the meridian just to the east of that of a place goes through the arc. The place is no pole.
    fn is_over(&self, p: Place) -> bool {
        let begins = on_one_meridian(self.west, p) || eastward(self.west, p).is_gt();
        begins && eastward(p, self.east).is_gt()
    }

    /// Returns true if it lies to the north of a place that is not on it, and is over it.
    fn is_above(&self, place: Place) -> bool {
        above(side(self.west, self.east, place)).is_lt()
    }

    /// Greater if this one lies to the north of another one, where both go through the same meridian; they do not cross.
    fn compare(&self, other: &Self) -> Ordering {
        if other.is_over(self.west) {
            let at_west = above(side(other.west, other.east, self.west));
            if at_west.is_ne() {
                return at_west;
            }
        } else {
            let at_west = above(side(self.west, self.east, other.west)).reverse();
            if at_west.is_ne() {
                return at_west;
            }
        }
        // They begin at the same place.
        if eastward(self.east, other.east).is_ge() {
            above(side(self.west, self.east, other.east)).reverse()
        } else {
            above(side(other.west, other.east, self.east))
        }
    }
}

/// Greater if a place is to the left of an arc to the east.
fn above(side: Orientation) -> Ordering {
    match side {
        Orientation::CounterClockwise => Ordering::Greater,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Less,
    }
}

/// The component of each vertex, and how many there are.
fn components(vertices: usize, arcs: &[[u32; 2]]) -> (Vec<u32>, usize) {
    let mut parent: Vec<u32> = (0..vertices as u32).collect();
    for [a, b] in arcs {
        let (a, b) = (root(&mut parent, *a), root(&mut parent, *b));
        parent[a.max(b) as usize] = a.min(b);
    }
    // Roots are smaller than what hangs on them.
    let (mut number, mut count) = (vec![0; vertices], 0);
    for v in 0..vertices as u32 {
        let root = root(&mut parent, v);
        if root == v {
            number[v as usize] = count;
            count += 1;
        } else {
            number[v as usize] = number[root as usize];
        }
    }
    (number, count as usize)
}

fn root(parent: &mut [u32], mut v: u32) -> u32 {
    while parent[v as usize] != v {
        parent[v as usize] = parent[parent[v as usize] as usize];
        v = parent[v as usize];
    }
    v
}

/// The arcs over each longitude, by which it is found what is to the north of a place.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sky {
    spans: Vec<Span>,
    stripes: Vec<Vec<u32>>,
    /// A place of each component that has a span.
    starts: Vec<Place>,
    /// The darts from the north pole with the places at their other ends, in order of longitude.
    at_pole: Vec<(u32, Place)>,
}

/// The placements of all components but that of the north pole, if it is a vertex, and the means by which they were found. Arcs meet at common ends only,
/// and none has the pole inside. Rotations are counter-clockwise.
///
/// O(n log n + k·s) for n arcs, k components, and s arcs in a stripe of longitudes.
pub(crate) fn placements(network: &Network, rotations: &[Vec<u32>]) -> (Vec<Placement>, Sky) {
    let Network { places, arcs, .. } = network;
    let (component, count) = components(places.len(), arcs);
    let pole = places.iter().position(|place| *place == Place::NORTH);
    let at_pole =
        pole.into_iter().flat_map(|pole| &rotations[pole]).map(|dart| (*dart, network.target(*dart))).collect();
    let mut sky = Sky::new(spans(places, arcs, &component), at_pole);

    // A place of each component at the western end of an arc, if there is one; or else the one of its first arc that is no pole.
    let mut starts: Vec<Option<(Place, u32)>> = vec![None; count];
    for span in &sky.spans {
        starts[span.component as usize].get_or_insert((span.west, span.dart));
    }
    sky.starts = starts.iter().flatten().map(|(start, _)| *start).collect();
    for (arc, ends) in (0_u32..).zip(arcs) {
        let dart = if places[ends[0] as usize].is_pole() { 2 * arc + 1 } else { 2 * arc };
        let from = places[ends[dart as usize % 2] as usize];
        starts[component[ends[0] as usize] as usize].get_or_insert((from, dart));
    }
    let mut found = Vec::new();
    for (number, start) in (0..).zip(starts) {
        let Some((start, dart)) = start.filter(|_| pole.is_none_or(|pole| component[pole] != number)) else { continue };
        let own = sky.over(start).filter(|span| span.component == number);
        let top = own.max_by(|a, b| a.compare(b));
        let within = match top {
            Some(top) => sky.lowest(start, |span| span.component != number && span.compare(&top).is_gt()),
            None => sky.lowest(start, |span| span.is_above(start)),
        };
        found.push(Placement { outside: Corner::At(top.map_or(dart, |top| top.dart)), within });
    }
    (found, sky)
}

impl Sky {
    /// A dart with the face to its left in which a place lies, or just to the north-east of it; none for the face at the north pole, if that is no vertex.
    ///
    /// O(s) for s arcs in a stripe of longitudes, and O(log n) if there is none to the north.
    pub(crate) fn dart_over(&self, place: Place) -> Option<u32> {
        self.lowest(place, |span| span.is_above(place))
    }

    /// For a place of each component, the darts to the east of all arcs over its meridian, from the south to the north, and the dart at the pole, if that is a vertex. A component
    /// that lies along a meridian has none.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (Vec<u32>, Option<u32>)> + '_ {
        self.starts.iter().map(|start| {
            let mut column: Vec<Span> = self.over(*start).collect();
            column.sort_by(Span::compare);
            (column.into_iter().map(|span| span.dart).collect(), self.lowest(*start, |_| false))
        })
    }

    /// The dart below the lowest of the arcs that are asked for over a place, or the one at the pole.
    fn lowest(&self, place: Place, is_asked: impl Fn(&Span) -> bool) -> Option<u32> {
        let lowest = self.over(place).filter(is_asked).min_by(Span::compare);
        let before = |(_, target): &(u32, Place)| compare_around(Place::NORTH, *target, place).is_le();
        let at_pole = || self.at_pole.iter().rfind(|dart| before(dart)).or(self.at_pole.last()).map(|(dart, _)| *dart);
        lowest.map(|span| span.dart ^ 1).or_else(at_pole)
    }

    /// Stripes are of longitudes that are rounded: a span is in one more on either side.
    fn new(spans: Vec<Span>, at_pole: Vec<(u32, Place)>) -> Self {
        let count = (spans.len() / 16).clamp(4, STRIPES);
        let mut stripes = vec![Vec::new(); count];
        for (number, span) in (0..).zip(&spans) {
            let [first, last] = [span.west, span.east].map(|end| stripe(end, count));
            let length = (last + count - first) % count;
            for step in 0..(length + 3).min(count) {
                stripes[(first + count - 1 + step) % count].push(number);
            }
        }
        Self { spans, stripes, starts: Vec::new(), at_pole }
    }

    /// The spans over the meridian just to the east of that of a place.
    fn over(&self, place: Place) -> impl Iterator<Item = Span> + '_ {
        let of_stripe = self.stripes.get(stripe(place, self.stripes.len())).into_iter().flatten();
        of_stripe.map(|number| self.spans[*number as usize]).filter(move |span| span.is_over(place))
    }
}

fn spans(places: &[Place], arcs: &[[u32; 2]], component: &[u32]) -> Vec<Span> {
    let span = |(arc, ends): (u32, &[u32; 2])| {
        let [a, b] = ends.map(|end| places[end as usize]);
        let component = component[ends[0] as usize];
        match eastward(a, b) {
            Ordering::Greater => Some(Span { west: a, east: b, dart: 2 * arc, component }),
            Ordering::Less => Some(Span { west: b, east: a, dart: 2 * arc + 1, component }),
            Ordering::Equal => None,
        }
    };
    (0..).zip(arcs).filter_map(span).collect()
}

/// The stripe in which a longitude lies.
#[allow(clippy::cast_sign_loss, reason = "the longitude is at least -180")]
fn stripe(p: Place, count: usize) -> usize {
    let part = (p.degrees()[0] + 180.0) / 360.0;
    ((part * count as f64) as usize).min(count.saturating_sub(1))
}
