//! Canonical forms: two structures have the same one if and only if they are isomorphic.
//!
//! Isomorphic means: there is a one-to-one correspondence of half-edges and isolated vertices that keeps `twin`,
//! `next`, faces and outer boundary components. So the orientation of the plane is kept, and so are nesting and the
//! unbounded face; names of records, the order of lists, and which half-edge a record starts with are not.
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
//! A connected map with a *root*, one marked half-edge, has no symmetry left: numbering its cycles one by one, each
//! consecutively from the half-edge by which it was first met across an edge, beginning with the root, gives every
//! half-edge a number that depends on the map alone. The code of the rooted map says, in that order, for each cycle how
//! long it is and for each half-edge the number of its twin. It takes O(E).
//!
//! Without root, the code is the least of those of all roots. Where the unbounded face or the surrounding one is
//! marked, only the half-edges of the outside cycle come into question, and no mark is needed in the code. A root is
//! given up at the first place where its code exceeds the least so far, so the worst case, O(E · number of roots), is
//! that of maps with many symmetries.
//!
//! Nesting is a tree, and trees are put in canonical form as Aho, Hopcroft and Ullman do it (*The Design and Analysis
//! of Computer Algorithms*, 1974, section 3.2): from the deepest level upwards, every component gets its rank among the
//! codes of its level, and the code of a component says of each face how many isolated vertices lie in it and which
//! ranks.

mod map;
mod nesting;

use crate::validate::View;
use alloc::vec::Vec;
use map::{Map, Search};
use nesting::Nesting;

/// A canonical form, as bytes. Equal maps have equal forms, different maps different forms; the order means nothing.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code(Vec<u8>);

impl Code {
    /// The bytes: numbers, the smaller the shorter.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        &self.0
    }

    /// Numbers as LEB128: seven bits per byte, so that those below 128 take one.
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

/// A connected map on a closed surface without any mark: no root, no unbounded face.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Unrooted {
    /// The least code among its rootings.
    pub code: Code,
    /// The number of its automorphisms that keep the orientation.
    pub automorphisms: usize,
    /// The number of different rooted maps that this map yields: `2E / automorphisms`, and 1 if it has no edge.
    pub rootings: usize,
}

/// The canonical form of a planar subdivision. See [`Canonizer::subdivision`].
pub fn code<V: View + ?Sized>(view: &V) -> Option<Code> {
    Canonizer::new().subdivision(view)
}

/// Tells whether two structures are the same planar subdivision but for names. Ones that are not valid are isomorphic to
/// nothing.
pub fn isomorphic<V: View + ?Sized, W: View + ?Sized>(one: &V, other: &W) -> bool {
    let mut canonizer = Canonizer::new();
    canonizer.subdivision(one).is_some_and(|code| canonizer.subdivision(other) == Some(code))
}

/// Finds canonical forms. Keep one where many are to be found: its working memory is used again.
///
/// A structure that is not valid may have no form; one in which `twin` pairs the half-edges and `next` permutes them is
/// enough for the forms of connected maps. No structure whatever makes these functions panic or run on: they give up.
#[derive(Debug, Default)]
pub struct Canonizer {
    map: Map,
    search: Search,
    nesting: Nesting,
}

impl Canonizer {
    /// With no memory in use yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The canonical form of a planar subdivision: its components, how they nest, and its unbounded face.
    ///
    /// O(n log n) beside, for each component, O(its size · length of its outside cycle) in the worst case, that of many
    /// symmetries.
    pub fn subdivision<V: View + ?Sized>(&mut self, view: &V) -> Option<Code> {
        self.map.read(view)?;
        self.nesting.read(&mut self.map, view)?;
        Some(Code::of_numbers(self.nesting.code(&self.map, &mut self.search)))
    }

    /// The code of the component of a half-edge, given by its index in the view, rooted there: on whatever surface, and
    /// without regard to faces and what lies in them. O(n).
    pub fn rooted<V: View + ?Sized>(&mut self, view: &V, root: usize) -> Option<Code> {
        self.map.read(view)?;
        let root = self.map.dense(root)?;
        self.search.begin(self.map.len());
        self.search.offer(&self.map, root, |_| &[]);
        Some(Code::of_numbers(self.search.least()))
    }

    /// The code of a connected map, on whatever surface and without marks. None if there are several components, or
    /// none.
    ///
    /// O(E²) in the worst case, that of many symmetries.
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
