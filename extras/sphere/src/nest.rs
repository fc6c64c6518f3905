//! The faces in which components lie.
//!
//! From a place of each component a line follows its meridian to the north pole, infinitesimally to the east, so that it meets no vertex, and arcs
//! along meridians do not matter. All other arcs have one latitude for each longitude that they span. The component lies in the face below the first
//! foreign arc above its own last arc. If there is no such arc, it lies in the face at the pole.
//!
//! If two such arcs do not cross, one is above the other wherever both exist. So [`side`] compares them exactly at an end that both span.

use crate::noding::Network;
use crate::place::Place;
use crate::predicates::{compare_around, eastward, on_one_meridian, side};
use core::cmp::Ordering;
use twinedge::dcel::{Corner, Placement};
use twinedge_geometry::predicates::Orientation;

/// The maximal number of stripes of longitudes into which arcs are sorted.
const STRIPES: usize = 4096;

/// An arc that does not follow a meridian, from west to east.
#[derive(Clone, Copy, Debug)]
struct Span {
    west: Place,
    east: Place,
    /// The eastward dart, with the north to its left.
    dart: u32,
    component: u32,
}

impl Span {
    /// Returns true if the meridian immediately east of a place crosses the arc. The place must not be a pole.
    fn is_over(&self, p: Place) -> bool {
        let begins = on_one_meridian(self.west, p) || eastward(self.west, p).is_gt();
        begins && eastward(p, self.east).is_gt()
    }

    /// Returns true if the span lies to the north of a place. The span must be over the place, and the place must not be on it.
    fn is_above(&self, place: Place) -> bool {
        above(side(self.west, self.east, place)).is_lt()
    }

    /// Compares two spans that share a meridian and do not cross: the northern one is greater.
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

/// Returns `Greater` if a place is to the left of an eastward arc.
fn above(side: Orientation) -> Ordering {
    match side {
        Orientation::CounterClockwise => Ordering::Greater,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Less,
    }
}

/// Returns the component of each vertex, and the number of components.
fn components(vertices: usize, arcs: &[[u32; 2]]) -> (Vec<u32>, usize) {
    let mut parent: Vec<u32> = (0..vertices as u32).collect();
    for [a, b] in arcs {
        let (a, b) = (root(&mut parent, *a), root(&mut parent, *b));
        parent[a.max(b) as usize] = a.min(b);
    }
    // A root is smaller than its descendants.
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

/// The arcs over each longitude, for finding the first arc to the north of a place.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sky {
    spans: Vec<Span>,
    stripes: Vec<Vec<u32>>,
    /// A place of each component that has a span.
    starts: Vec<Place>,
    /// The darts from the north pole with the places at their other ends, in order of longitude.
    at_pole: Vec<(u32, Place)>,
}

/// Returns the placements of all components except the north pole's, if it is a vertex, and the index used to find them. Arcs must meet only at
/// common ends, and the pole must not be inside an arc. Rotations are counter-clockwise.
///
/// O(n log n + k·s) for n arcs, k components, and s arcs in a stripe of longitudes.
pub(crate) fn placements(network: &Network, rotations: &[Vec<u32>]) -> (Vec<Placement>, Sky) {
    let Network { places, arcs, .. } = network;
    let (component, count) = components(places.len(), arcs);
    let pole = places.iter().position(|place| *place == Place::NORTH);
    let at_pole =
        pole.into_iter().flat_map(|pole| &rotations[pole]).map(|dart| (*dart, network.target(*dart))).collect();
    let mut sky = Sky::new(spans(places, arcs, &component), at_pole);

    // For each component, a place at the western end of an arc if possible; otherwise a place of its first arc that is not a pole.
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
    /// Returns a dart with the face to its left that contains a place, or the point immediately north-east of it; `None` for the face at the north
    /// pole, if the pole is not a vertex.
    ///
    /// O(s) for s arcs in a stripe of longitudes, and O(log n) if there is none to the north.
    pub(crate) fn dart_over(&self, place: Place) -> Option<u32> {
        self.lowest(place, |span| span.is_above(place))
    }

    /// For a place of each component, returns the eastward darts of all arcs over its meridian, from south to north, and the dart at the pole, if
    /// that is a vertex. A component along a meridian is left out.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (Vec<u32>, Option<u32>)> + '_ {
        self.starts.iter().map(|start| {
            let mut column: Vec<Span> = self.over(*start).collect();
            column.sort_by(Span::compare);
            (column.into_iter().map(|span| span.dart).collect(), self.lowest(*start, |_| false))
        })
    }

    /// Returns the dart below the lowest selected arc over a place, or the dart at the pole.
    fn lowest(&self, place: Place, is_asked: impl Fn(&Span) -> bool) -> Option<u32> {
        let lowest = self.over(place).filter(is_asked).min_by(Span::compare);
        let before = |(_, target): &(u32, Place)| compare_around(Place::NORTH, *target, place).is_le();
        let at_pole = || self.at_pole.iter().rfind(|dart| before(dart)).or(self.at_pole.last()).map(|(dart, _)| *dart);
        lowest.map(|span| span.dart ^ 1).or_else(at_pole)
    }

    /// The longitudes of stripes are rounded, so a span is also in the next stripe on either side.
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

    /// Returns the spans over the meridian immediately east of a place.
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

/// Returns the stripe of a longitude.
#[allow(clippy::cast_sign_loss, reason = "the longitude is at least -180")]
fn stripe(p: Place, count: usize) -> usize {
    let part = (p.degrees()[0] + 180.0) / 360.0;
    ((part * count as f64) as usize).min(count.saturating_sub(1))
}
