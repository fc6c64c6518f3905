//! Builds a [`Dcel`] from a rotation system.

use super::from_view::{Keys, keys};
use super::gather::{Numbers, Pieces};
use crate::dcel::assemble::Assembly;
use crate::dcel::operators::Corner;
use crate::dcel::structure::Dcel;
use crate::numbers::{NIL, cycles};
use crate::store::{BoundaryStart, RecordKind, VertexLink};
use alloc::vec;
use alloc::vec::Vec;
use thiserror::Error;

/// The position of a component of a rotation system in the plane, which [`Dcel::from_rotations`] cannot infer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Placement {
    /// The corner facing the outside of the component: a dart with the outside to its left, or the component's isolated vertex.
    pub outside: Corner<u32, u32>,
    /// A dart of another component, with this component in the face to its left; `None` for the unbounded face. If that face is
    /// the outside of the other component, the two lie side by side.
    pub within: Option<u32>,
}

/// The error of [`Dcel::from_rotations`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum RotationsError {
    /// A vertex lists a dart whose number is too large.
    #[error("vertex {vertex} lists dart {dart}, but {darts} darts are listed, counted from 0")]
    NoSuchDart {
        /// The vertex.
        vertex: usize,
        /// The dart that it lists.
        dart: u32,
        /// The number of darts that all vertices list.
        darts: usize,
    },
    /// A dart is listed twice.
    #[error("dart {dart} is listed by vertex {} and by vertex {}", .vertices[0], .vertices[1])]
    RepeatedDart {
        /// The dart.
        dart: u32,
        /// The vertices that list it, or one vertex twice.
        vertices: [usize; 2],
    },
    /// The number of darts is odd, so the last one has no twin.
    #[error("dart {dart} is the last one and has no twin")]
    Unpaired {
        /// The dart.
        dart: u32,
    },
    /// A component lies on a surface that cannot be drawn in the plane.
    #[error("the component of vertex {vertex} has genus {genus}, and a planar subdivision has genus 0")]
    Genus {
        /// Its vertex with the smallest number.
        vertex: u32,
        /// Its genus.
        genus: usize,
    },
    /// A placement names a dart or an isolated vertex that does not exist.
    #[error("placement {placement} names {corner:?}, which is not there")]
    NoSuchCorner {
        /// The placement, by its position.
        placement: usize,
        /// The corner that it names.
        corner: Corner<u32, u32>,
    },
    /// Two placements name the same component.
    #[error("placements {} and {} are of the same component", .placements[0], .placements[1])]
    PlacedTwice {
        /// The placements, by their positions.
        placements: [usize; 2],
    },
    /// By the placements, a component lies inside itself, directly or through others.
    #[error("the component of placement {placement} lies inside itself")]
    InsideItself {
        /// The position of one of these placements.
        placement: usize,
    },
    /// There are more records of this kind than a [`Dcel`] can hold.
    #[error("there are more {0} than fit")]
    Full(RecordKind),
}

impl Dcel {
    /// Builds the structure in which each vertex has this rotation: the darts that leave it, counter-clockwise.
    ///
    /// A *dart* is the number of a half-edge. The half-edges of an edge have the numbers `2e` and `2e + 1`, and each number
    /// below the number of half-edges is listed once. A vertex without darts is isolated. Loops and parallel edges are
    /// accepted. Faces are traced: a dart is followed by the dart clockwise from its twin.
    ///
    /// ```text
    ///           2
    ///         ╱   ╲            vertex 0: [0, 5]
    ///     5 ╱4     3╲ 2        vertex 1: [2, 1]
    ///     ╱           ╲        vertex 2: [4, 3]
    ///   0 ─────────────1
    ///       0 ─►   ◄─ 1        dart 0 goes from 0 to 1, dart 1 back, …
    /// ```
    ///
    /// A rotation system does not determine the unbounded face, nor the faces in which its components lie. [`Placement`]s do,
    /// at most one for each component. A component without a placement lies in the unbounded face, and its outside is the face
    /// to the left of its smallest dart.
    ///
    /// The returned keys are indexed by number of vertex, and for half-edges by dart. The index of a dart is its number plus 2.
    /// Faces have no numbers: `map.half_edge(key)?.face()` is the face to the left of a dart.
    ///
    /// O(n) time and memory for n vertices, darts and placements. The result needs no validation.
    ///
    /// # Errors
    /// [`RotationsError::NoSuchDart`], [`RotationsError::RepeatedDart`] and [`RotationsError::Unpaired`] for darts;
    /// [`RotationsError::Genus`] for the first non-planar component; [`RotationsError::NoSuchCorner`],
    /// [`RotationsError::PlacedTwice`] and [`RotationsError::InsideItself`] for placements; [`RotationsError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::{Corner, Dcel, Placement};
    ///
    /// // The triangle above, with an isolated vertex in it. Dart 1 has the outside to its left.
    /// let triangle = Placement { outside: Corner::At(1), within: None };
    /// let island = Placement { outside: Corner::Isolated(3), within: Some(0) };
    /// let (map, keys) = Dcel::from_rotations([&[0, 5][..], &[2, 1], &[4, 3], &[]], &[triangle, island])?;
    /// assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (4, 3, 2));
    /// let inside = map.half_edge(keys.half_edge(0).unwrap())?.face();
    /// assert!(!inside.is_unbounded());
    /// assert_eq!(inside.inner_count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_rotations<R: AsRef<[u32]>>(
        rotations: impl IntoIterator<Item = R>,
        placements: &[Placement],
    ) -> Result<(Self, Keys), RotationsError> {
        let system = System::read(rotations)?;
        let (boundary, starts) = cycles(&system.next);
        let starts: Vec<_> = starts.into_iter().map(BoundaryStart::HalfEdge).collect();
        let pieces = Pieces::find(&system.origin, &system.next, &system.leaving);
        let genera = pieces.genera(&system.origin, &starts);
        if let Some(piece) = genera.iter().position(|genus| *genus > 0) {
            return Err(RotationsError::Genus { vertex: pieces.first[piece], genus: genera[piece] });
        }
        let placed = Nesting::new(&system, &pieces, placements)?;
        system.assemble(&boundary, starts, &pieces, &placed)
    }
}

struct System {
    /// By dart.
    origin: Vec<u32>,
    next: Vec<u32>,
    /// By vertex: a leaving dart, or nil.
    leaving: Vec<u32>,
}

impl System {
    fn read<R: AsRef<[u32]>>(rotations: impl IntoIterator<Item = R>) -> Result<Self, RotationsError> {
        let (mut listed, mut starts) = (Vec::new(), vec![0]);
        for rotation in rotations {
            listed.extend_from_slice(rotation.as_ref());
            starts.push(listed.len());
        }
        let darts = listed.len();
        if darts >= 1 << 31 {
            return Err(RotationsError::Full(RecordKind::Edge));
        }
        if starts.len() >= 1 << 31 {
            return Err(RotationsError::Full(RecordKind::Vertex));
        }
        let mut system = Self { origin: vec![NIL; darts], next: vec![NIL; darts + darts % 2], leaving: Vec::new() };
        for (vertex, range) in starts.windows(2).enumerate() {
            let rotation = &listed[range[0]..range[1]];
            system.leaving.push(rotation.first().copied().unwrap_or(NIL));
            let mut clockwise = rotation.last().copied();
            for dart in rotation.iter().copied() {
                let origin =
                    system.origin.get_mut(dart as usize).ok_or(RotationsError::NoSuchDart { vertex, dart, darts })?;
                let before = core::mem::replace(origin, vertex as u32);
                if before != NIL {
                    return Err(RotationsError::RepeatedDart { dart, vertices: [before as usize, vertex] });
                }
                // With an odd number of darts, the place of the last dart's missing twin is at the end.
                system.next[dart as usize ^ 1] = clockwise.replace(dart).unwrap_or(dart);
            }
        }
        system.next.truncate(darts);
        if darts % 2 == 1 { Err(RotationsError::Unpaired { dart: darts as u32 - 1 }) } else { Ok(system) }
    }

    fn assemble(
        &self,
        boundary: &[u32],
        mut starts: Vec<BoundaryStart<u32, u32>>,
        pieces: &Pieces,
        placed: &Nesting,
    ) -> Result<(Dcel, Keys), RotationsError> {
        let mut is_outer = vec![true; starts.len()];
        for outside in placed.outside.iter().filter(|outside| **outside != NIL) {
            is_outer[boundary[*outside as usize] as usize] = false;
        }
        let mut face_of = vec![NIL; starts.len()];
        let mut outer = Vec::new();
        for b in (0..starts.len() as u32).filter(|b| is_outer[*b as usize]) {
            outer.push(b);
            face_of[b as usize] = outer.len() as u32;
        }
        let mut vertices: Vec<VertexLink<u32, u32>> = self.leaving.iter().copied().map(VertexLink::Leaving).collect();
        let mut inner = Vec::with_capacity(pieces.first.len());
        // Components that contain others come first, so their faces are known.
        for piece in placed.order.iter().copied() {
            let within = placed.within[piece as usize];
            let face = if within == NIL { 0 } else { face_of[boundary[within as usize] as usize] };
            let outside = placed.outside[piece as usize];
            if outside == NIL {
                let v = pieces.first[piece as usize];
                vertices[v as usize] = VertexLink::Isolated(starts.len() as u32);
                inner.push((face, starts.len() as u32));
                starts.push(BoundaryStart::Vertex(v));
            } else {
                let b = boundary[outside as usize];
                face_of[b as usize] = face;
                inner.push((face, b));
            }
        }
        let assembly = Assembly {
            vertices: &vertices,
            origin: &self.origin,
            next: &self.next,
            boundary,
            starts: &starts,
            outer: &outer,
            inner: &inner,
        };
        let dcel = assembly.assemble_right().map_err(RotationsError::Full)?;
        let numbers = Numbers {
            vertices: (0..self.leaving.len() as u32).collect(),
            half_edges: (0..self.origin.len() as u32).collect(),
            ..Numbers::default()
        };
        let keys = keys(&dcel, &numbers);
        Ok((dcel, keys))
    }
}

struct Nesting {
    /// By component: a dart with its outside to the left; nil for an isolated vertex.
    outside: Vec<u32>,
    /// By component: a dart with this component in the face to its left; nil for the unbounded face.
    within: Vec<u32>,
    /// All components, each before the components inside it.
    order: Vec<u32>,
}

impl Nesting {
    fn new(system: &System, pieces: &Pieces, placements: &[Placement]) -> Result<Self, RotationsError> {
        let count = pieces.first.len();
        let mut outside = vec![NIL; count];
        for (dart, v) in system.origin.iter().enumerate().rev() {
            outside[pieces.of[*v as usize] as usize] = dart as u32;
        }
        let mut placed = Self { outside, within: vec![NIL; count], order: Vec::with_capacity(count) };
        // By component: its placement.
        let mut by = vec![NIL; count];
        for (position, placement) in placements.iter().enumerate() {
            let no_such = |corner| RotationsError::NoSuchCorner { placement: position, corner };
            let origin = |dart: u32| system.origin.get(dart as usize).ok_or(no_such(Corner::At(dart)));
            let vertex = match placement.outside {
                Corner::At(dart) => *origin(dart)?,
                Corner::Isolated(v) if system.leaving.get(v as usize) == Some(&NIL) => v,
                corner @ Corner::Isolated(_) => return Err(no_such(corner)),
            };
            let piece = pieces.of[vertex as usize] as usize;
            let before = core::mem::replace(&mut by[piece], position as u32);
            if before != NIL {
                return Err(RotationsError::PlacedTwice { placements: [before as usize, position] });
            }
            if let Corner::At(dart) = placement.outside {
                placed.outside[piece] = dart;
            }
            if let Some(within) = placement.within {
                origin(within)?;
                placed.within[piece] = within;
            }
        }
        placed.sort(&by, |dart| pieces.of[system.origin[dart as usize] as usize])?;
        Ok(placed)
    }

    /// Finds the order: walks from each component outwards to one with a known place, then back.
    fn sort(&mut self, by: &[u32], piece_of: impl Fn(u32) -> u32) -> Result<(), RotationsError> {
        #[derive(Clone, Copy, PartialEq, Eq)]
        enum State {
            New,
            OnTheWay,
            Done,
        }
        let mut state = vec![State::New; by.len()];
        let mut way = Vec::new();
        for piece in 0..by.len() as u32 {
            let mut at = Some(piece);
            while let Some(piece) = at.filter(|piece| state[*piece as usize] != State::Done) {
                if state[piece as usize] == State::OnTheWay {
                    return Err(RotationsError::InsideItself { placement: by[piece as usize] as usize });
                }
                state[piece as usize] = State::OnTheWay;
                way.push(piece);
                let within = self.within[piece as usize];
                at = (within != NIL).then(|| piece_of(within));
            }
            while let Some(piece) = way.pop() {
                state[piece as usize] = State::Done;
                self.order.push(piece);
            }
        }
        Ok(())
    }
}
