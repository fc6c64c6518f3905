//! Arcs cut where they meet.

use crate::clash::{Clash, clashes_of, crossing};
use crate::drawing::{Drawing, sorted, toggle};
use crate::place::Place;
use crate::predicates::{eastward, on_arc, on_one_meridian};
use crate::vector::{dot, minus};
use rustc_hash::FxHashMap;
use thiserror::Error;
use twinedge_geometry::Point;

/// The maximal number of rounds. The places where arcs cross are rounded, so the parts may cross other arcs.
const ROUNDS: usize = 20;

/// Arcs that meet only at common ends, and that make up the arcs of a drawing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Network {
    pub(crate) places: Vec<Place>,
    pub(crate) degrees: Vec<Point>,
    pub(crate) arcs: Vec<[u32; 2]>,
    /// The polygons on only one side of each arc.
    pub(crate) polygons: Vec<Vec<u32>>,
}

/// The error that arcs still crossed after many rounds of cutting, because the places of crossings are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("the places where edges cross are rounded, and edges that are cut there cross again and again")]
pub struct Unresolved;

impl Network {
    /// Cuts the arcs of a drawing where they meet and at the north pole. Also returns the clashes.
    pub(crate) fn new(drawing: &Drawing) -> (Vec<Clash>, Result<Self, Unresolved>) {
        let mut network = Self {
            places: drawing.places().to_vec(),
            degrees: (0..drawing.places().len() as u32).map(|place| drawing.degrees(place)).collect(),
            arcs: drawing.arcs().iter().map(|arc| arc.ends).collect(),
            polygons: drawing.arcs().iter().map(|arc| arc.polygons.clone()).collect(),
        };
        let clashes = clashes_of(&network.places, &network.arcs, 0);
        let mut numbers = (0..).zip(&network.places).map(|(number, place)| (place.key(), number)).collect();
        let mut cuts = network.cuts(&clashes, &mut numbers);
        for arc in network.over_the_pole() {
            let pole = network.number(Place::NORTH, &mut numbers);
            cuts.entry(arc).or_default().push(pole);
        }
        // Borders that coincide up to rounding could be cut into ever more parts.
        let most = 2 * drawing.arcs().len() + 4 * clashes.len();
        for _ in 0..ROUNDS {
            if cuts.is_empty() {
                return (clashes, Ok(network));
            }
            if network.arcs.len() > most {
                break;
            }
            let first = network.cut(&cuts);
            let next = clashes_of(&network.places, &network.arcs, first);
            cuts = network.cuts(&next, &mut numbers);
        }
        (clashes, Err(Unresolved))
    }

    /// Removes the places that are not ends of arcs.
    pub(crate) fn compact(mut self) -> Self {
        let mut number = vec![u32::MAX; self.places.len()];
        let mut kept = Self { polygons: self.polygons, ..Self::default() };
        for end in self.arcs.iter_mut().flatten() {
            let old = *end as usize;
            if number[old] == u32::MAX {
                number[old] = kept.places.len() as u32;
                kept.places.push(self.places[old]);
                kept.degrees.push(self.degrees[old]);
            }
            *end = number[old];
        }
        Self { arcs: self.arcs, ..kept }
    }

    fn at(&self, place: u32) -> Place {
        self.places[place as usize]
    }

    /// Returns the place at the other end of a dart. Each arc has two darts, first the one in its own direction.
    pub(crate) fn target(&self, dart: u32) -> Place {
        self.at(self.arcs[dart as usize / 2][1 - dart as usize % 2])
    }

    /// Returns the number of a place, adding the place if it is new.
    fn number(&mut self, place: Place, numbers: &mut FxHashMap<[u64; 3], u32>) -> u32 {
        let next = self.places.len() as u32;
        let number = *numbers.entry(place.key()).or_insert(next);
        if number == next {
            self.places.push(place);
            self.degrees.push(place.degrees().into());
        }
        number
    }

    fn over_the_pole(&self) -> Vec<u32> {
        let is_over = |ends: &[u32; 2]| {
            let [a, b] = ends.map(|end| self.at(end));
            !a.is_pole()
                && !b.is_pole()
                && !on_one_meridian(a, b)
                && eastward(a, b).is_eq()
                && on_arc(Place::NORTH, a, b)
        };
        (0..).zip(&self.arcs).filter(|(_, ends)| is_over(ends)).map(|(arc, _)| arc).collect()
    }

    fn cuts(&mut self, clashes: &[Clash], numbers: &mut FxHashMap<[u64; 3], u32>) -> FxHashMap<u32, Vec<u32>> {
        let mut cuts: FxHashMap<u32, Vec<u32>> = FxHashMap::default();
        for clash in clashes {
            match *clash {
                Clash::Cross { arcs } => {
                    let [first, second] = arcs.map(|arc| self.arcs[arc as usize].map(|end| self.at(end)));
                    let crossing = self.number(crossing(first, second), numbers);
                    for arc in arcs {
                        cuts.entry(arc).or_default().push(crossing);
                    }
                }
                Clash::Touch { place, arc } => cuts.entry(arc).or_default().push(place),
                Clash::Overlap { arcs: [first, second] } => {
                    for (one, other) in [(first, second), (second, first)] {
                        let [a, b] = self.arcs[other as usize].map(|end| self.at(end));
                        let inside = self.arcs[one as usize].into_iter().filter(|end| on_arc(self.at(*end), a, b));
                        cuts.entry(other).or_default().extend(inside);
                    }
                }
            }
        }
        cuts
    }

    /// Cuts arcs at places. Returns the number of the first part; earlier arcs are unchanged.
    fn cut(&mut self, cuts: &FxHashMap<u32, Vec<u32>>) -> usize {
        let mut whole = Self { places: std::mem::take(&mut self.places), ..Self::default() };
        let mut parts = Vec::new();
        let arcs = std::mem::take(&mut self.arcs).into_iter().zip(std::mem::take(&mut self.polygons));
        for (arc, (ends, polygons)) in (0..).zip(arcs) {
            match cuts.get(&arc) {
                None => {
                    whole.arcs.push(ends);
                    whole.polygons.push(polygons);
                }
                Some(cuts) => {
                    let chain = along(&whole.places, ends, cuts);
                    parts.extend(chain.windows(2).map(|pair| ([pair[0], pair[1]], polygons.clone())));
                }
            }
        }
        let first = whole.arcs.len();
        let mut known: FxHashMap<[u32; 2], usize> =
            whole.arcs.iter().enumerate().map(|(arc, ends)| (sorted(*ends), arc)).collect();
        for (ends, polygons) in parts {
            let next = whole.arcs.len();
            let number = *known.entry(sorted(ends)).or_insert(next);
            if number == next {
                whole.arcs.push(ends);
                whole.polygons.push(polygons);
            } else {
                for polygon in polygons {
                    toggle(&mut whole.polygons[number], polygon);
                }
            }
        }
        whole.degrees = std::mem::take(&mut self.degrees);
        *self = whole;
        first
    }
}

/// Returns the ends of an arc and its cuts, in order, without duplicates.
fn along(places: &[Place], [a, b]: [u32; 2], cuts: &[u32]) -> Vec<u32> {
    let [from, to] = [a, b].map(|end| places[end as usize].unit());
    let part = |place: u32| dot(minus(places[place as usize].unit(), from), minus(to, from));
    let mut inside: Vec<u32> = cuts.iter().copied().filter(|cut| *cut != a && *cut != b).collect();
    inside.sort_by(|p, q| part(*p).total_cmp(&part(*q)).then(p.cmp(q)));
    inside.dedup();
    [a].into_iter().chain(inside).chain([b]).collect()
}
