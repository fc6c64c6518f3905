//! Convex pieces: the decomposition of Hertel and Mehlhorn.
//!
//! A face is triangulated, including its holes, by edges between its vertices: the *diagonals*. Then each diagonal is examined
//! once, and removed unless it is essential. The remaining ones cut the face into convex pieces, without a new vertex.
//!
//! ```text
//!   ┌─────────┐        ┌─────────┐        ┌─────────┐
//!   │         │        │╲ ╲      │        │         │
//!   │   ┌─────┘        │  ╲┌─────┘        │   ┌─────┘
//!   │   │        ──►   │  ╱│         ──►  │  ╱│
//!   │   │              │╱  │              │╱  │
//!   └───┘              └───┘              └───┘
//!    a face             triangulated       what is essential
//! ```
//!
//! # How is a triangulation stored, and essentiality checked?
//!
//! The triangulation is the map itself: each diagonal is an ordinary edge, so the structure that contained the face contains its
//! triangles. Only the list of the diagonals is separate, as keys of half-edges ([`Triangulation::diagonals`]).
//!
//! A diagonal `d` is essential at its origin if the corner that appears there without it is larger than a straight angle. The
//! corner lies between the half-edges that leave the vertex before and after `d`:
//!
//! ```text
//!      ccw(d) = twin(prev(d))            without d:      ccw(d)
//!       ╲                                                 ╲
//!        ╲    d                                            ╲  one corner, from cw(d) to ccw(d)
//!         o────────►                                        o
//!        ╱                                                 ╱
//!       ╱                                                 ╱
//!      cw(d) = next(twin(d))                             cw(d)
//! ```
//!
//! So two links and one exact predicate decide at each end, in O(1) for any degree of the vertex ([`is_essential`]). Removing a
//! diagonal enlarges the corners next to it and shrinks none. So an essential diagonal remains essential, and one pass over the
//! list, in any order, is enough ([`remove_inessential`]).
//!
//! # How many pieces
//!
//! A corner of a face is *reflex* if it is larger than a straight angle. A kept diagonal is essential at one of its ends, at a
//! reflex corner. At most two are essential at each reflex corner, and at most three at an isolated vertex. So a face with r
//! reflex corners, i isolated vertices and h other inner boundary components has at most 2r + 3i + 1 − (h + i) pieces. A simple
//! polygon has at most 2r + 1, while every decomposition has at least ⌈r / 2⌉ + 1: at most four times the minimum. (With holes
//! the theorem does not promise the factor of four.)
//!
//! Edges that dangle in the face, holes that touch a boundary, and isolated vertices are never inside a piece.
//!
//! Sources: S. Hertel and K. Mehlhorn, "Fast triangulation of simple polygons", FCT 1983, LNCS 158, 207-218; J. O'Rourke,
//! "Computational Geometry in C", 2nd edition, section 2.5. The triangulation is the constrained Delaunay triangulation of
//! the crate `spade`.
//!
//! ```
//! use twinedge_algorithm::convex::decompose;
//! use twinedge_map::PlanarMap;
//!
//! // The letter L has one reflex corner, and falls into two pieces.
//! let mut map = PlanarMap::new();
//! let l = map.insert_ring([[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [3.0, 2.0], [3.0, 3.0], [0.0, 3.0]])?;
//! let face = l.faces_split[0].1;
//! let found = decompose(&mut map, [face])?;
//! assert_eq!((found[0].reflex, found[0].triangles, found[0].pieces.len()), (1, 4, 2));
//! assert!(map.validate().is_valid());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod essential;
mod triangulate;

pub use error::ConvexError;
pub use essential::{is_essential, remove_inessential};
pub use triangulate::{Triangulation, triangulate};

use twinedge::dcel::{FaceKey, HalfEdge, HalfEdgeKey};
use twinedge_map::PlanarMap;

/// The decomposition of one face.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Decomposition {
    /// The face, by its old key, which may now be stale or belong to a piece.
    pub face: FaceKey,
    /// The number of triangles before diagonals were removed.
    pub triangles: usize,
    /// The number of diagonals before removal.
    pub diagonals: usize,
    /// The essential diagonals, each by one of its half-edges: they are edges of the map.
    pub kept: Vec<HalfEdgeKey>,
    /// The number of reflex corners of the face; an isolated vertex counts as one.
    pub reflex: usize,
    /// The convex pieces, faces of the map. Each is covered by the features that covered the face.
    pub pieces: Vec<FaceKey>,
}

impl Decomposition {
    /// Returns the number of diagonals removed.
    #[must_use]
    pub const fn removed(&self) -> usize {
        self.diagonals - self.kept.len()
    }
}

/// Cuts faces into convex pieces, by edges between vertices of each; repetitions have no effect. Returns the decomposition of
/// each face, in order of first mention.
///
/// O(n log n) for the n half-edges of the faces, expected: each drawn or removed diagonal walks the shorter of two cycles.
///
/// # Errors
/// [`ConvexError`].
pub fn decompose(
    map: &mut PlanarMap,
    faces: impl IntoIterator<Item = FaceKey>,
) -> Result<Vec<Decomposition>, ConvexError> {
    map.atomically(|map| {
        let triangulations = triangulate(map, faces)?;
        triangulations.into_iter().map(|triangulation| merged(map, triangulation)).collect()
    })
}

/// Removes the inessential diagonals of a triangulation, and lists the pieces.
fn merged(map: &mut PlanarMap, triangulation: Triangulation) -> Result<Decomposition, ConvexError> {
    let Triangulation { face, boundary, diagonals, triangles, reflex } = triangulation;
    let kept = remove_inessential(map, &diagonals)?;
    let mut pieces = Vec::with_capacity(kept.len() + 1);
    for h in core::iter::once(boundary).chain(kept.iter().copied()) {
        let h = map.dcel().half_edge(h)?;
        let sides: &[HalfEdge<'_>] = if pieces.is_empty() { &[h] } else { &[h, h.twin()] };
        pieces.extend(sides.iter().map(|side| side.face()).map(|face| (face.index(), face.key())));
    }
    pieces.sort_by_key(|(index, _)| *index);
    pieces.dedup();
    let pieces = pieces.into_iter().map(|(_, key)| key).collect();
    Ok(Decomposition { face, triangles, diagonals: diagonals.len(), kept, reflex, pieces })
}
