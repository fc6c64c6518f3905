//! Canonical forms: two structures have equal forms if and only if they are isomorphic.
//!
//! Two structures are isomorphic if a one-to-one correspondence of their half-edges and isolated vertices keeps `twin`,
//! `next`, faces and outer boundary components. An isomorphism therefore keeps the orientation of the plane, nesting and
//! the unbounded face, but not names, the order of lists or the half-edge with which a record starts.
//!
//! ```
//! use twinedge::dcel::Dcel;
//! use twinedge::program::{Program, Runner, canonical};
//! let build = |text: &str| -> Dcel {
//!     let program: Program = text.parse().unwrap();
//!     let mut runner = Runner::new(Dcel::new());
//!     runner.run(&program);
//!     runner.into_subject()
//! };
//! // A path of two edges, grown at its end or by splitting its only edge.
//! let grown = build("twinedge program 1\n add_isolated_vertex unbounded\n split_vertex i0 i0\n split_vertex h1 h1");
//! let split = build("twinedge program 1\n add_isolated_vertex unbounded\n split_vertex i0 i0\n split_edge h0");
//! assert!(canonical::isomorphic(&grown, &split));
//! ```
//!
//! # How
//!
//! A connected map with a *root*, one marked half-edge, has no symmetry. Number its cycles one by one, starting with the
//! cycle of the root, each consecutively from the half-edge through which it was first reached. Every half-edge then has
//! a number that depends on the map alone. The code of the rooted map lists, in that order, the length of each cycle and
//! the number of each half-edge's twin. Computing it takes O(E).
//!
//! The code of a map without a root is the least code of all its roots. If the unbounded or the surrounding face is
//! marked, only half-edges of the outside cycle are candidates, and the code needs no mark. A root is abandoned where
//! its code first exceeds the least so far, so only maps with many symmetries take the worst case, O(E · number of
//! roots).
//!
//! Nesting is a tree, and trees are put in canonical form as by Aho, Hopcroft and Ullman (*The Design and Analysis of
//! Computer Algorithms*, 1974, section 3.2): from the deepest level upwards, every component gets its rank among the
//! codes of its level. Its code lists, for each face, the number of isolated vertices and the ranks of the components in
//! it.

mod map;
mod nesting;

use crate::validate::View;
use alloc::vec::Vec;
use map::{Map, Search};
use nesting::Nesting;

/// A canonical form, as bytes. Two maps are isomorphic if and only if their codes are equal; the order of codes has no
/// meaning.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code(Vec<u8>);

impl Code {
    /// The bytes: numbers of variable length.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        &self.0
    }

    /// Encodes numbers as LEB128: seven bits per byte, so a number below 128 takes one byte.
    fn of_numbers<'a>(numbers: impl IntoIterator<Item = &'a u32>) -> Self {
        let numbers = numbers.into_iter();
        let mut bytes = Vec::with_capacity(numbers.size_hint().0);
        for number in numbers {
            let mut rest = *number;
            while rest >= 0x80 {
                bytes.push(rest as u8 | 0x80);
                rest >>= 7;
            }
            bytes.push(rest as u8);
        }
        Self(bytes)
    }
}

/// A connected map on a closed surface, without a root or an unbounded face.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Unrooted {
    /// The least code among its rootings.
    pub code: Code,
    /// The number of its orientation-preserving automorphisms.
    pub automorphisms: usize,
    /// The number of different rooted maps of this map: `2E / automorphisms`, and 1 if it has no edge.
    pub rootings: usize,
}

/// The canonical form of a planar subdivision. See [`Canonizer::subdivision`].
pub fn code<V: View + ?Sized>(view: &V) -> Option<Code> {
    Canonizer::new().subdivision(view)
}

/// Tells whether two structures are the same planar subdivision up to names. An invalid structure is isomorphic to
/// nothing.
pub fn isomorphic<V: View + ?Sized, W: View + ?Sized>(one: &V, other: &W) -> bool {
    let mut canonizer = Canonizer::new();
    canonizer.subdivision(one).is_some_and(|code| canonizer.subdivision(other) == Some(code))
}

/// Computes canonical forms. Reuse one to compute many: it keeps its working memory.
///
/// An invalid structure may have no form; the forms of connected maps only need `twin` to pair the half-edges and `next`
/// to permute them. These functions return `None` instead of panicking or running on, whatever the structure.
#[derive(Debug, Default)]
pub struct Canonizer {
    map: Map,
    search: Search,
    nesting: Nesting,
}

impl Canonizer {
    /// Creates a canonizer without allocating.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The canonical form of a planar subdivision: its components, how they nest, and its unbounded face.
    ///
    /// O(n log n), plus O(size · length of its outside cycle) for each component in the worst case, a map with many
    /// symmetries.
    pub fn subdivision<V: View + ?Sized>(&mut self, view: &V) -> Option<Code> {
        self.map.read(view)?;
        self.nesting.read(&mut self.map, view)?;
        Some(Code::of_numbers(self.nesting.code(&self.map, &mut self.search)))
    }

    /// The code of the component of a half-edge, given by its index in the view, rooted there. The surface may have any
    /// genus; faces and nesting are ignored. O(n).
    pub fn rooted<V: View + ?Sized>(&mut self, view: &V, root: usize) -> Option<Code> {
        self.map.read(view)?;
        let root = self.map.dense(root)?;
        self.search.begin(self.map.len());
        self.search.offer(&self.map, root, |_| &[]);
        Some(Code::of_numbers(self.search.least()))
    }

    /// The code of a connected map without marks, on a surface of any genus; `None` unless there is exactly one
    /// component.
    ///
    /// O(E²) in the worst case, a map with many symmetries.
    pub fn unrooted<V: View + ?Sized>(&mut self, view: &V) -> Option<Unrooted> {
        self.map.read(view)?;
        let vertices = (0..view.vertex_slots()).filter(|v| view.is_vertex(*v)).take(2).count();
        if self.map.len() == 0 {
            let code = Code::of_numbers(&[]);
            return (vertices == 1).then_some(Unrooted { code, automorphisms: 1, rootings: 1 });
        }
        self.map.mark_busy(view)?;
        if self.map.components() != 1 || !self.map.all_busy(view) {
            return None;
        }
        self.search.begin(self.map.len());
        for root in 0..self.map.len() as u32 {
            self.search.offer(&self.map, root, |_| &[]);
        }
        let automorphisms = self.search.ties();
        Some(Unrooted {
            code: Code::of_numbers(self.search.least()),
            automorphisms,
            rootings: self.map.len() / automorphisms.max(1),
        })
    }
}
