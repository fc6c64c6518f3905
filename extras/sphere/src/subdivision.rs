//! The half-edge structure of arcs that meet only at common ends.

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
/// The structure is a planar subdivision. A sphere has no outside, so the unbounded face is the face at the north pole, or a face around the
/// pole if the pole is a vertex. The rules of planar subdivisions hold, so [`validate`](twinedge::validate::validate) checks the structure with the
/// nesting of its components.
#[derive(Clone, Debug)]
pub struct Subdivision {
    network: Network,
    dcel: Dcel,
    /// Two darts for each arc, first the one in the arc's direction.
    darts: Vec<Dart>,
    /// The face that acts as the unbounded face.
    at_pole: u32,
    sky: Sky,
}

/// A half-edge, with its face.
#[derive(Clone, Copy, Debug, Default)]
struct Dart {
    next: u32,
    /// The number of the face to the left; faces are numbered from 0 without gaps.
    face: u32,
}

/// The error of building the structure.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SubdivisionError {
    /// The arcs could not be cut.
    #[error(transparent)]
    Unresolved(#[from] Unresolved),
    /// There are too many records.
    #[error("the arcs do not make a map: {0}")]
    Dcel(#[from] RotationsError),
}

impl Subdivision {
    /// Creates the map of a drawing by cutting its arcs where they meet. Also returns the clashes. Arcs that only share ends are unchanged.
    ///
    /// O((n + k) log n) for n arcs that meet k times, if few of them are long and lie side by side.
    ///
    /// # Errors
    /// [`SubdivisionError`], together with all clashes.
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
        // The index of each half-edge is its dart's number plus a constant.
        let first = keys.half_edge(0).and_then(|key| dcel.half_edge(key).ok()).map_or(0, |h| h.index());
        for h in dcel.half_edges() {
            let face = numbers[h.face().index()];
            darts[h.index() - first] = Dart { next: (h.next().index() - first) as u32, face };
        }
        let at_pole = numbers[dcel.unbounded_face().index()];
        Ok(Self { network, dcel, darts, at_pole, sky })
    }

    /// Returns the half-edge structure.
    #[must_use]
    pub const fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// Returns the places of the vertices.
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.network.places
    }

    /// Returns the number of vertices around which half-edges are not in order (G2). Always 0, because the same predicate sorted them. O(n).
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
                // The directions decrease clockwise, except for one step in each turn.
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

    /// Returns the number of components for which the nesting (G5) is inconsistent. Always 0, because components were placed by the arcs to their
    /// north. This checks all arcs over and under a place of each component, up to the pole: between consecutive arcs, the face must be the same on
    /// both sides. O(k·s log s) for k components, and s arcs in a stripe of longitudes.
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

    /// Returns the face that contains a place; on an arc, or at a pole that is a vertex, one of the adjacent faces.
    pub(crate) fn locate(&self, place: Place) -> u32 {
        let place = if place == Place::SOUTH { Place::beside_south() } else { place };
        self.sky.dart_over(place).map_or(self.at_pole, |dart| self.face(dart))
    }

    /// Returns the polygons on only one side of a dart's edge.
    pub(crate) fn polygons(&self, dart: u32) -> &[u32] {
        &self.network.polygons[dart as usize / 2]
    }

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

/// Returns the darts around each vertex, counter-clockwise. O(n log n).
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
