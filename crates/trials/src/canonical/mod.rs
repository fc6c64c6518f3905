//! Canonical forms: two structures have equal forms if and only if they are isomorphic.
//!
//! Two structures are isomorphic if a one-to-one correspondence of their half-edges and isolated vertices keeps `twin`,
//! `next`, faces and outer boundary components. An isomorphism therefore keeps the orientation of the plane, nesting and
//! the unbounded face, but not names, the order of lists or the half-edge with which a record starts.
//!
//! ```
//! use twinedge::dcel::Dcel;
//! use twinedge::program::{Program, Runner};
//! use twinedge_trials::canonical;
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

use map::{Map, NIL, Search, fill};
use std::ops::Range;
use twinedge::validate::{Start, View};

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

/// The contents of the faces of a view, and the codes found so far.
#[derive(Debug, Default)]
struct Nesting {
    /// By cycle: the face that it bounds from outside; NIL if it is the outside of its component.
    inside: Vec<u32>,
    /// By component: a half-edge of its outside cycle, and the face that lists it.
    outsides: Vec<(u32, u32)>,
    /// By face: how many isolated vertices it lists.
    isolated: Vec<u32>,
    unbounded: u32,
    /// By face: where its components begin in `contents`; one more at the end.
    begins: Vec<u32>,
    contents: Vec<u32>,
    /// By component: where its cycles begin in `cycles`; one more at the end.
    cycle_begins: Vec<u32>,
    cycles: Vec<u32>,
    /// The components level by level, the outermost first, and where each level ends.
    levels: Vec<u32>,
    ends: Vec<usize>,
    /// By component: its rank in its level, and its code, a stretch of `codes`.
    ranks: Vec<u32>,
    spans: Vec<Range<usize>>,
    codes: Vec<u32>,
    /// By face: its note, a stretch of `notes`.
    note_spans: Vec<Range<usize>>,
    notes: Vec<u32>,
    result: Vec<u32>,
}

impl Nesting {
    /// Reads the faces of a view; `None` unless each cycle, isolated vertex and component has exactly one place. O(n).
    fn read<V: View + ?Sized>(&mut self, map: &mut Map, view: &V) -> Option<()> {
        let faces = view.face_slots();
        u32::try_from(faces).ok().filter(|faces| *faces < NIL)?;
        fill(&mut self.inside, map.cycles.len(), NIL)?;
        fill(&mut self.outsides, map.components(), (NIL, NIL))?;
        fill(&mut self.isolated, faces, 0)?;
        map.mark_busy(view)?;
        self.unbounded = NIL;
        let mut listed = 0;
        for f in (0..faces).filter(|f| view.is_face(*f)) {
            match outer_start(view, f) {
                Some(Start::HalfEdge(h)) => {
                    let cycle = map.cycle[map.dense(h)? as usize] as usize;
                    if std::mem::replace(&mut self.inside[cycle], f as u32) != NIL {
                        return None;
                    }
                    listed += 1;
                }
                None if self.unbounded == NIL => self.unbounded = f as u32,
                _ => return None,
            }
            for position in 0..view.inner_count(f) {
                match inner_start(view, f, position)? {
                    Start::HalfEdge(h) => {
                        let h = map.dense(h)?;
                        let outside = &mut self.outsides[map.component[h as usize] as usize];
                        if outside.0 != NIL {
                            return None;
                        }
                        *outside = (h, f as u32);
                        listed += 1;
                    }
                    Start::Vertex(v) => {
                        map.mark_isolated(v)?;
                        self.isolated[f] += 1;
                    }
                }
            }
        }
        // Each component has one outside, so with this number of entries every cycle is covered once if none is covered
        // twice.
        let once = |(h, _): &(u32, u32)| *h != NIL && self.inside[map.cycle[*h as usize] as usize] == NIL;
        if !map.all_busy(view) || self.unbounded == NIL || listed != map.cycles.len() || !self.outsides.iter().all(once)
        {
            return None;
        }
        self.sort_contents(faces)?;
        self.sort_cycles(map)?;
        self.sort_levels(map)
    }

    fn sort_contents(&mut self, faces: usize) -> Option<()> {
        let keys = self.outsides.iter().map(|(_, f)| *f);
        sort_by_key(keys, faces, &mut self.begins, &mut self.contents)
    }

    fn sort_cycles(&mut self, map: &Map) -> Option<()> {
        let keys = map.cycles.iter().map(|h| map.component[*h as usize]);
        sort_by_key(keys, map.components(), &mut self.cycle_begins, &mut self.cycles)
    }

    /// Sorts level by level, from the unbounded face inwards; `None` if a component is never reached because it lies
    /// inside itself.
    fn sort_levels(&mut self, map: &Map) -> Option<()> {
        self.levels.clear();
        self.ends.clear();
        self.levels.extend_from_slice(stretch(&self.begins, &self.contents, self.unbounded));
        let mut done = 0;
        while done < self.levels.len() {
            self.ends.push(self.levels.len());
            for position in done..self.levels.len() {
                for cycle in stretch(&self.cycle_begins, &self.cycles, self.levels[position]) {
                    let f = self.inside[*cycle as usize];
                    if f != NIL {
                        self.levels.extend_from_slice(stretch(&self.begins, &self.contents, f));
                    }
                }
            }
            done = self.ends.last().copied().unwrap_or(self.levels.len());
        }
        (self.levels.len() == map.components()).then_some(())
    }

    /// The code: the contents of the unbounded face, then the distinct codes of each level, outermost first.
    fn code(&mut self, map: &Map, search: &mut Search) -> &[u32] {
        self.ranks.clear();
        self.ranks.resize(map.components(), 0);
        self.spans.clear();
        self.spans.resize(map.components(), 0..0);
        self.note_spans.clear();
        self.note_spans.resize(self.isolated.len(), 0..0);
        self.codes.clear();
        self.notes.clear();
        let mut end = self.levels.len();
        for level in (0..self.ends.len()).rev() {
            let begin = level.checked_sub(1).map_or(0, |above| self.ends[above]);
            for position in begin..end {
                self.write_code(map, search, self.levels[position]);
            }
            self.rank(begin..end);
            end = begin;
        }
        self.write_note(self.unbounded);
        self.result.clear();
        self.result.extend_from_slice(&self.notes[self.note_spans[self.unbounded as usize].clone()]);
        let mut begin = 0;
        for end in self.ends.iter().copied() {
            let mut last = NIL;
            for c in self.levels[begin..end].iter().map(|c| *c as usize) {
                if std::mem::replace(&mut last, self.ranks[c]) != self.ranks[c] {
                    let code = &self.codes[self.spans[c].clone()];
                    self.result.push(code.len() as u32);
                    self.result.extend_from_slice(code);
                }
            }
            // No code is empty, so this ends the level.
            self.result.push(0);
            begin = end;
        }
        &self.result
    }

    /// Computes the code of a component. The components in its faces must have their ranks already.
    fn write_code(&mut self, map: &Map, search: &mut Search, component: u32) {
        for i in range(&self.cycle_begins, component) {
            let f = self.inside[self.cycles[i] as usize];
            if f != NIL {
                self.write_note(f);
            }
        }
        search.begin(map.len());
        let first = self.outsides[component as usize].0;
        let mut root = first;
        loop {
            search.offer(map, root, |h| match self.inside[map.cycle[h as usize] as usize] {
                NIL => &[],
                f => &self.notes[self.note_spans[f as usize].clone()],
            });
            root = map.next[root as usize];
            if root == first {
                break;
            }
        }
        let begin = self.codes.len();
        self.codes.extend_from_slice(search.least());
        self.spans[component as usize] = begin..self.codes.len();
    }

    /// Writes the contents of a face: the number of isolated vertices, the number of components, and their ranks.
    fn write_note(&mut self, face: u32) {
        let begin = self.notes.len();
        let contents = stretch(&self.begins, &self.contents, face);
        self.notes.extend([self.isolated[face as usize], contents.len() as u32]);
        self.notes.extend(contents.iter().map(|c| self.ranks[*c as usize]));
        self.notes[begin + 2..].sort_unstable();
        self.note_spans[face as usize] = begin..self.notes.len();
    }

    fn rank(&mut self, level: Range<usize>) {
        let code = |c: u32| &self.codes[self.spans[c as usize].clone()];
        self.levels[level.clone()].sort_by(|a, b| code(*a).cmp(code(*b)));
        let mut rank = 0;
        let mut last: Option<u32> = None;
        for c in &self.levels[level] {
            if last.is_some_and(|last| code(last) != code(*c)) {
                rank += 1;
            }
            self.ranks[*c as usize] = rank;
            last = Some(*c);
        }
    }
}

/// The start of the outer boundary component of a face, stored directly or through the component.
fn outer_start<V: View + ?Sized>(view: &V, face: usize) -> Option<Start> {
    match view.outer(face) {
        Some(b) => view.boundary_start(b),
        None => view.outer_half_edge(face).map(Start::HalfEdge),
    }
}

/// The start of an inner boundary component of a face, stored directly or through the component.
fn inner_start<V: View + ?Sized>(view: &V, face: usize, position: usize) -> Option<Start> {
    match view.inner(face, position) {
        Some(b) => view.boundary_start(b),
        None => view.inner_start(face, position),
    }
}

/// Sorts `0..` by keys below `count`: fills the beginning of each key and the sorted numbers. O(n + count).
fn sort_by_key(
    keys: impl Iterator<Item = u32> + Clone,
    count: usize,
    begins: &mut Vec<u32>,
    sorted: &mut Vec<u32>,
) -> Option<()> {
    fill(begins, count + 1, 0)?;
    let mut len = 0;
    for key in keys.clone() {
        begins[key as usize + 1] += 1;
        len += 1;
    }
    for key in 0..count {
        begins[key + 1] += begins[key];
    }
    fill(sorted, len, 0)?;
    for (number, key) in keys.enumerate() {
        let place = &mut begins[key as usize];
        sorted[*place as usize] = number as u32;
        *place += 1;
    }
    // Each beginning has moved to the next key's.
    begins.rotate_right(1);
    begins[0] = 0;
    Some(())
}

fn range(begins: &[u32], key: u32) -> Range<usize> {
    begins[key as usize] as usize..begins[key as usize + 1] as usize
}

fn stretch<'a>(begins: &[u32], sorted: &'a [u32], key: u32) -> &'a [u32] {
    &sorted[range(begins, key)]
}
