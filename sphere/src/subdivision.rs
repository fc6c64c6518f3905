//! The half-edge structure of arcs that meet at common ends only.

use crate::clash::Clash;
use crate::drawing::Drawing;
use crate::nest::{Sky, placements};
use crate::noding::{Network, Unresolved};
use crate::place::Place;
use crate::predicates::compare_around;
use thiserror::Error;
use twinedge::dcel::{Dcel, RotationsError};
use twinedge_geometry::Point;

/// The map that arcs draw on the sphere.
///
/// The structure is one of the plane: as a sphere has no outside, the face at the north pole, or if the pole is a vertex one of those around it, takes the place of the unbounded one. Everything that is
/// true of subdivisions of the plane is true of it, so that [`validate`](twinedge::validate::validate) checks it as such, with the nesting of its components.
#[derive(Clone, Debug)]
pub struct Subdivision {
    network: Network,
    dcel: Dcel,
    /// By dart: two of each arc, the one that runs as the arc does first.
    darts: Vec<Dart>,
    /// The face that takes the place of the unbounded one.
    at_pole: u32,
    sky: Sky,
}

/// A half-edge, and what is known of it.
#[derive(Clone, Copy, Debug, Default)]
struct Dart {
    next: u32,
    /// The number of the face to the left, from 0 without vacancies.
    face: u32,
}

/// The error of building the structure.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SubdivisionError {
    /// Arcs could not be cut.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// There are more records than fit.
    #[error("the arcs do not make a map: {0}")]
    Dcel(#[from] RotationsError),
}

impl Subdivision {
    /// The map that a drawing is, with its arcs cut where they meet, and where it had to be cut. Arcs that only have ends in common are as they were.
    ///
    /// O((n + k) log n) for n arcs that meet k times, as long as few are long and lie side by side.
    ///
    /// # Errors
    /// [`SubdivisionError`], beside all clashes.
    pub fn new(drawing: &Drawing) -> (Vec<Clash>, Result<Self, SubdivisionError>) {
        let (clashes, network) = Network::new(drawing);
        (clashes, network.map_err(Into::into).and_then(Self::of))
    }

    fn of(network: Network) -> Result<Self, SubdivisionError> {
        let network = network.compact();
        let rotations = rotations(&network);
        let (placements, sky) = placements(&network, &rotations);
        let (dcel, keys) = Dcel::from_rotations(&rotations, &placements)?;
        let mut numbers = vec![u32::MAX; dcel.faces().map(|face| face.index() + 1).max().unwrap_or_default()];
        for (number, face) in (0..).zip(dcel.faces()) {
            numbers[face.index()] = number;
        }
        let mut darts = vec![Dart::default(); 2 * network.arcs.len()];
        // Darts have the indices of their numbers, and a difference that is the same for all.
        let first = keys.half_edge(0).and_then(|key| dcel.half_edge(key).ok()).map_or(0, |h| h.index());
        for h in dcel.half_edges() {
            let face = numbers[h.face().index()];
            darts[h.index() - first] = Dart { next: (h.next().index() - first) as u32, face };
        }
        let at_pole = numbers[dcel.unbounded_face().index()];
        Ok(Self { network, dcel, darts, at_pole, sky })
    }

    /// The structure.
    #[must_use]
    pub const fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// The places of the vertices.
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.network.places
    }

    /// The number of vertices around which half-edges are not in order (G2): 0, as they were sorted by the predicate that is asked here. O(n).
    #[must_use]
    pub fn out_of_order(&self) -> usize {
        let mut first = vec![None; self.network.places.len()];
        for dart in 0..self.darts.len() as u32 {
            first[self.origin(dart) as usize].get_or_insert(dart);
        }
        let is_out_of_order = |(center, start): (&Place, &u32)| {
            let (mut dart, mut turns) = (*start, 0);
            loop {
                let next = self.next(dart ^ 1);
                // Clockwise, the directions fall, but for one step in each turn.
                let step = compare_around(*center, self.network.target(dart), self.network.target(next));
                turns += usize::from(step.is_le());
                dart = next;
                if dart == *start {
                    return turns != 1;
                }
            }
        };
        let vertices = self.network.places.iter().zip(&first).filter_map(|(at, dart)| Some((at, dart.as_ref()?)));
        vertices.filter(|one| is_out_of_order(*one)).count()
    }

    /// The number of components that lie in another face than the structure says (G5), or have one in them: 0, as they were placed by what is to the north of them. Here all is asked that lies over and under a place of each,
    /// up to the pole: from arc to arc, the face must be the same on both sides of what is between. O(k·s log s) for k components, and s arcs in a stripe of longitudes.
    #[must_use]
    pub fn misplaced(&self) -> usize {
        let is_misplaced = |(column, pole): &(Vec<u32>, Option<u32>)| {
            let at_pole = pole.map_or(self.at_pole, |dart| self.face(dart));
            let between = column.windows(2).any(|pair| self.face(pair[0]) != self.face(pair[1] ^ 1));
            between || column.last().is_some_and(|top| self.face(*top) != at_pole)
        };
        self.sky.columns().filter(is_misplaced).count()
    }

    pub(crate) fn dart_count(&self) -> usize {
        self.darts.len()
    }

    pub(crate) fn face_count(&self) -> usize {
        self.dcel.face_count()
    }

    /// The face to the left of a dart.
    pub(crate) fn face(&self, dart: u32) -> u32 {
        self.darts[dart as usize].face
    }

    pub(crate) fn next(&self, dart: u32) -> u32 {
        self.darts[dart as usize].next
    }

    pub(crate) fn origin(&self, dart: u32) -> u32 {
        self.network.arcs[dart as usize / 2][dart as usize % 2]
    }

    pub(crate) fn place(&self, vertex: u32) -> Place {
        self.network.places[vertex as usize]
    }

    pub(crate) fn degrees(&self, vertex: u32) -> Point {
        self.network.degrees[vertex as usize]
    }

    /// The face in which a place lies; on an arc, or at a pole that is a vertex, one of those beside it.
    pub(crate) fn locate(&self, place: Place) -> u32 {
        let place = if place == Place::SOUTH { Place::beside_south() } else { place };
        self.sky.dart_over(place).map_or(self.at_pole, |dart| self.face(dart))
    }

    /// The polygons on one side only of the edge of a dart.
    pub(crate) fn polygons(&self, dart: u32) -> &[u32] {
        &self.network.polygons[dart as usize / 2]
    }

    /// The cycles, as the first dart of each.
    pub(crate) fn cycles(&self) -> Vec<Vec<u32>> {
        let mut seen = vec![false; self.darts.len()];
        let mut cycles = Vec::new();
        for start in 0..self.darts.len() as u32 {
            if seen[start as usize] {
                continue;
            }
            let (mut cycle, mut dart) = (Vec::new(), start);
            while !seen[dart as usize] {
                seen[dart as usize] = true;
                cycle.push(dart);
                dart = self.next(dart);
            }
            cycles.push(cycle);
        }
        cycles
    }
}

/// The darts around each vertex, counter-clockwise. O(n log n).
fn rotations(network: &Network) -> Vec<Vec<u32>> {
    let mut rotations = vec![Vec::new(); network.places.len()];
    for (arc, ends) in (0..).zip(&network.arcs) {
        for (dart, end) in (2 * arc..).zip(ends) {
            rotations[*end as usize].push(dart);
        }
    }
    for (center, rotation) in network.places.iter().zip(&mut rotations) {
        rotation.sort_by(|a, b| compare_around(*center, network.target(*a), network.target(*b)));
    }
    rotations
}
