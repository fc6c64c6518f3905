//! Operators as data: the table, programs, and calls.
//!
//! An [`Op`] chooses its arguments by small numbers, so any bytes are a program that runs. A [`Call`] contains handles instead, and a
//! structure applies it.

use super::arguments::{CornerPick, FacePick, Fit, HalfEdgePick, InnerPick, List, SecondPick, VertexPick};
use super::choose::Choose;
use crate::dcel::{Corner, Side, Turn};
use crate::language;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::{self, Display};

// The table of operators; bytes, text, random and simpler programs follow from it. The weights sum to 32. Operators of meshes have
// weight 0: random programs contain them only on request.
language! {
    header "twinedge program 1" Header,
    /// One operator with its arguments.
    #[derive(Copy)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[allow(missing_docs, reason = "the arguments are those of `Call`")]
    op Op over List,
    /// The kinds of operators, for a [`Generator`](crate::program::Generator). [`SHARES`](Self::SHARES) lists their weights, which sum
    /// to 32. Operators of meshes are drawn only if given a weight.
    kind OpKind,
    /// A sequence of operators. A [`Runner`](crate::program::Runner) runs it from the empty map or any other start.
    ///
    /// # As text
    ///
    /// [`Display`](core::fmt::Display) writes one operator per line, [`FromStr`](core::str::FromStr) reads it back, and `#` begins a
    /// comment:
    ///
    /// ```text
    /// twinedge program 1
    /// add_isolated_vertex unbounded
    /// split_vertex i0 ~0                   # the second corner is the first that fits
    /// connect h0 h1 left inner 0,2 also h5 # the new face to the left, with inner boundary components 0 and 2, and that of h5
    /// remove_edge !h0                      # a stale handle
    /// ```
    ///
    /// | word | chooses |
    /// | --- | --- |
    /// | `h3` | the half-edge with number 3 (counted from 0), and its corner |
    /// | `i3` | the isolated vertex with number 3, and its corner |
    /// | `o3` | the origin of `h3`, wrongly taken for an isolated vertex |
    /// | `!h3`, `!v3`, `!f3` | a removed half-edge, vertex or face |
    /// | `~3` | a corner that fits the first one |
    /// | `unbounded` | the unbounded face |
    ///
    /// Numbers count from 0, modulo the length of the list: half-edges in order of creation, the two of an edge adjacent, those in the
    /// start first; isolated vertices in the order in which they became isolated.
    ///
    /// ```
    /// use twinedge::program::{StepOutcome, Program, Runner};
    /// let program = Program::from_bytes(b"any bytes are a program");
    /// let mut runner = Runner::new(twinedge::dcel::Dcel::new());
    /// for op in &program.0 {
    ///     runner.step(*op);
    ///     assert!(runner.subject().validate().is_valid());
    /// }
    /// // It can be written down, and read again.
    /// assert_eq!(program.to_string().parse(), Ok(program));
    /// ```
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    program Program,
    /// [`Call::AddIsolatedVertex`].
    AddIsolatedVertex add_isolated_vertex 5 { face: FacePick }
    /// [`Call::RemoveIsolatedVertex`].
    RemoveIsolatedVertex remove_isolated_vertex 1 { vertex: VertexPick }
    /// [`Call::Connect`].
    Connect connect 9 { from: CornerPick, to: SecondPick [from, Fit::Face], new_face: Side, inner: InnerPick }
    /// [`Call::RemoveEdge`].
    RemoveEdge remove_edge 3 { half_edge: HalfEdgePick }
    /// [`Call::SplitEdge`].
    SplitEdge split_edge 2 { half_edge: HalfEdgePick }
    /// [`Call::JoinEdges`].
    JoinEdges join_edges 1 { half_edge: HalfEdgePick }
    /// [`Call::SplitVertex`].
    SplitVertex split_vertex 3 { from: CornerPick, to: SecondPick [from, Fit::Vertex] }
    /// [`Call::ContractEdge`].
    ContractEdge contract_edge 2 { half_edge: HalfEdgePick }
    /// [`Call::FlipEdge`].
    FlipEdge flip_edge 3 { half_edge: HalfEdgePick, turn: Turn }
    /// [`Call::MoveInner`].
    MoveInner move_inner 3 { inner: CornerPick, face: FacePick }
    /// [`Call::MeshFlipEdge`].
    MeshFlipEdge mesh_flip_edge 0 { half_edge: HalfEdgePick }
    /// [`Call::MeshSplitEdge`].
    MeshSplitEdge mesh_split_edge 0 { half_edge: HalfEdgePick }
    /// [`Call::MeshSplitFace`].
    MeshSplitFace mesh_split_face 0 { half_edge: HalfEdgePick }
    /// [`Call::MeshCollapseEdge`].
    MeshCollapseEdge mesh_collapse_edge 0 { half_edge: HalfEdgePick }
}

/// A change in the numbers of vertices, edges, faces and components.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CountChange {
    /// V.
    pub vertices: i8,
    /// E.
    pub edges: i8,
    /// F.
    pub faces: i8,
    /// C.
    pub components: i8,
}

const fn counts(vertices: i8, edges: i8, faces: i8, components: i8) -> CountChange {
    CountChange { vertices, edges, faces, components }
}

impl OpKind {
    /// The changes that an operator of this kind may make to the counts of a map, if applied.
    #[must_use]
    pub const fn changes(self) -> &'static [CountChange] {
        match self {
            Self::AddIsolatedVertex => const { &[counts(1, 0, 0, 1)] },
            Self::RemoveIsolatedVertex => const { &[counts(-1, 0, 0, -1)] },
            Self::Connect => const { &[counts(0, 1, 1, 0), counts(0, 1, 0, -1)] },
            Self::RemoveEdge => const { &[counts(0, -1, -1, 0), counts(0, -1, 0, 1)] },
            Self::SplitEdge | Self::SplitVertex => const { &[counts(1, 1, 0, 0)] },
            Self::JoinEdges | Self::ContractEdge => const { &[counts(-1, -1, 0, 0)] },
            Self::FlipEdge | Self::MoveInner | Self::MeshFlipEdge => const { &[counts(0, 0, 0, 0)] },
            Self::MeshSplitEdge => const { &[counts(1, 3, 2, 0), counts(1, 2, 1, 0)] },
            Self::MeshSplitFace => const { &[counts(1, 3, 2, 0)] },
            Self::MeshCollapseEdge => const { &[counts(-1, -3, -2, 0), counts(-1, -2, -1, 0)] },
        }
    }
}

/// An operator with the handles that it chose, as returned by [`Runner::resolve`](crate::program::Runner::resolve) and passed to
/// [`Subject::apply`](crate::program::Subject::apply). Handles may be stale.
///
/// Each operator means the method of the same name of [`Dcel`](crate::dcel::Dcel), whose page has a picture. Operators of meshes are
/// defined by basic operators, in [`mesh`](crate::program::mesh).
///
/// An operator refuses for the first reason that applies: first for each argument in order ([`Stale`](super::Refusal::Stale), then
/// [`NotIsolated`](super::Refusal::NotIsolated) for the corner of a vertex that is not isolated), then for the reasons that its variant
/// lists. [`Full`](super::Refusal::Full) may come anywhere.
///
/// `Display` writes the handles alone, as in `h0 to h3, inner v1`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the variants say what their arguments are")]
pub enum Call<V, H, F> {
    /// Adds an isolated vertex in a face, and returns the vertex.
    AddIsolatedVertex { face: F },
    /// Removes an isolated vertex.
    RemoveIsolatedVertex { vertex: V },
    /// Connects two corners of one face by a new edge, and returns the half-edge from the first to the second.
    ///
    /// If the edge splits the face, the new face lies to the `new_face` side of that half-edge and gets the inner boundary components
    /// named in `inner` (repeated names count once). A bridge ignores both, but still refuses a stale handle.
    ///
    /// [`FacesDiffer`](super::Refusal::FacesDiffer); then, if the face is split, [`NotInner`](super::Refusal::NotInner).
    Connect { from: Corner<H, V>, to: Corner<H, V>, new_face: Side, inner: Vec<Corner<H, V>> },
    /// Removes an edge. If two faces become one, returns the removed face: either of the two, but not the unbounded one.
    RemoveEdge { half_edge: H },
    /// Puts a new vertex on an edge. The given half-edge keeps its origin; returns the new half-edge that follows it.
    SplitEdge { half_edge: H },
    /// Joins the edge of a half-edge with the following edge. The given half-edge keeps its origin; the following edge and the vertex
    /// between them are removed.
    ///
    /// [`DegreeNotTwo`](super::Refusal::DegreeNotTwo); then [`Loop`](super::Refusal::Loop).
    JoinEdges { half_edge: H },
    /// Splits a vertex in two, and returns the new half-edge between them. Its target gets the half-edges met when turning
    /// counter-clockwise from the first corner to the second, or none for equal corners. Either of the two vertices may be the new one.
    ///
    /// [`VerticesDiffer`](super::Refusal::VerticesDiffer).
    SplitVertex { from: Corner<H, V>, to: Corner<H, V> },
    /// Contracts an edge to a point, and returns the removed vertex: either of the two.
    ///
    /// [`Loop`](super::Refusal::Loop).
    ContractEdge { half_edge: H },
    /// Turns an edge one step inside the two faces that it separates.
    ///
    /// [`NotSeparating`](super::Refusal::NotSeparating).
    FlipEdge { half_edge: H, turn: Turn },
    /// Moves the inner boundary component of the corner, with everything inside, to another face. Moving it to its own face does
    /// nothing.
    ///
    /// [`IsOuter`](super::Refusal::IsOuter); then [`InsideItself`](super::Refusal::InsideItself).
    MoveInner { inner: Corner<H, V>, face: F },
    /// Turns an edge inside the two triangles that it separates: [`mesh::flip_edge`](crate::program::mesh::flip_edge).
    MeshFlipEdge { half_edge: H },
    /// Puts a new vertex on an edge and joins it with the vertex opposite in each triangle:
    /// [`mesh::split_edge`](crate::program::mesh::split_edge).
    MeshSplitEdge { half_edge: H },
    /// Puts a new vertex into the triangle to the left of a half-edge and joins it with its corners:
    /// [`mesh::split_face`](crate::program::mesh::split_face).
    MeshSplitFace { half_edge: H },
    /// Collapses an edge together with its triangles: [`mesh::collapse_edge`](crate::program::mesh::collapse_edge).
    MeshCollapseEdge { half_edge: H },
}

impl<V, H, F> Call<V, H, F> {
    /// Connects two corners. If that splits their face, the new face lies to the left and contains nothing.
    #[must_use]
    pub const fn connect(from: Corner<H, V>, to: Corner<H, V>) -> Self {
        Self::Connect { from, to, new_face: Side::Left, inner: Vec::new() }
    }

    /// The kind of the operator, without handles.
    #[must_use]
    pub const fn kind(&self) -> OpKind {
        match self {
            Self::AddIsolatedVertex { .. } => OpKind::AddIsolatedVertex,
            Self::RemoveIsolatedVertex { .. } => OpKind::RemoveIsolatedVertex,
            Self::Connect { .. } => OpKind::Connect,
            Self::RemoveEdge { .. } => OpKind::RemoveEdge,
            Self::SplitEdge { .. } => OpKind::SplitEdge,
            Self::JoinEdges { .. } => OpKind::JoinEdges,
            Self::SplitVertex { .. } => OpKind::SplitVertex,
            Self::ContractEdge { .. } => OpKind::ContractEdge,
            Self::FlipEdge { .. } => OpKind::FlipEdge,
            Self::MoveInner { .. } => OpKind::MoveInner,
            Self::MeshFlipEdge { .. } => OpKind::MeshFlipEdge,
            Self::MeshSplitEdge { .. } => OpKind::MeshSplitEdge,
            Self::MeshSplitFace { .. } => OpKind::MeshSplitFace,
            Self::MeshCollapseEdge { .. } => OpKind::MeshCollapseEdge,
        }
    }

    /// Maps the handles.
    pub fn map<W, I, G>(self, vertex: impl Fn(V) -> W, edge: impl Fn(H) -> I, face: impl Fn(F) -> G) -> Call<W, I, G> {
        let place = |corner| match corner {
            Corner::At(h) => Corner::At(edge(h)),
            Corner::Isolated(v) => Corner::Isolated(vertex(v)),
        };
        match self {
            Self::AddIsolatedVertex { face: f } => Call::AddIsolatedVertex { face: face(f) },
            Self::RemoveIsolatedVertex { vertex: v } => Call::RemoveIsolatedVertex { vertex: vertex(v) },
            Self::Connect { from, to, new_face, inner } => {
                let inner = inner.into_iter().map(place).collect();
                Call::Connect { from: place(from), to: place(to), new_face, inner }
            }
            Self::RemoveEdge { half_edge } => Call::RemoveEdge { half_edge: edge(half_edge) },
            Self::SplitEdge { half_edge } => Call::SplitEdge { half_edge: edge(half_edge) },
            Self::JoinEdges { half_edge } => Call::JoinEdges { half_edge: edge(half_edge) },
            Self::SplitVertex { from, to } => Call::SplitVertex { from: place(from), to: place(to) },
            Self::ContractEdge { half_edge } => Call::ContractEdge { half_edge: edge(half_edge) },
            Self::FlipEdge { half_edge, turn } => Call::FlipEdge { half_edge: edge(half_edge), turn },
            Self::MoveInner { inner, face: f } => Call::MoveInner { inner: place(inner), face: face(f) },
            Self::MeshFlipEdge { half_edge } => Call::MeshFlipEdge { half_edge: edge(half_edge) },
            Self::MeshSplitEdge { half_edge } => Call::MeshSplitEdge { half_edge: edge(half_edge) },
            Self::MeshSplitFace { half_edge } => Call::MeshSplitFace { half_edge: edge(half_edge) },
            Self::MeshCollapseEdge { half_edge } => Call::MeshCollapseEdge { half_edge: edge(half_edge) },
        }
    }
}

fn word<H: Display, V: Display>(corner: &Corner<H, V>) -> &dyn Display {
    match corner {
        Corner::At(h) => h,
        Corner::Isolated(v) => v,
    }
}

impl<V: Display, H: Display, F: Display> Display for Call<V, H, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AddIsolatedVertex { face } => write!(f, "in {face}"),
            Self::RemoveIsolatedVertex { vertex } => write!(f, "{vertex}"),
            Self::Connect { from, to, inner, .. } => {
                write!(f, "{} to {}", word(from), word(to))?;
                let before = core::iter::once(", inner ").chain(core::iter::repeat(" "));
                before.zip(inner).try_for_each(|(before, corner)| write!(f, "{before}{}", word(corner)))
            }
            Self::SplitVertex { from, to } => write!(f, "{} to {}", word(from), word(to)),
            Self::MoveInner { inner, face } => write!(f, "{} to {face}", word(inner)),
            Self::RemoveEdge { half_edge }
            | Self::SplitEdge { half_edge }
            | Self::JoinEdges { half_edge }
            | Self::ContractEdge { half_edge }
            | Self::FlipEdge { half_edge, .. }
            | Self::MeshFlipEdge { half_edge }
            | Self::MeshSplitEdge { half_edge }
            | Self::MeshSplitFace { half_edge }
            | Self::MeshCollapseEdge { half_edge } => write!(f, "{half_edge}"),
        }
    }
}

/// The handle that an operator returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle<V, H, F> {
    /// A vertex.
    Vertex(V),
    /// A half-edge.
    HalfEdge(H),
    /// A face.
    Face(F),
}

/// Choices from bytes, recording whether the bytes sufficed.
struct Finite<'a, I> {
    bytes: &'a mut I,
    is_over: bool,
}

impl<I: Iterator<Item = u8>> Choose for Finite<'_, I> {
    fn choose(&mut self, n: usize) -> usize {
        let byte = self.bytes.next();
        self.is_over |= byte.is_none();
        usize::from(byte.unwrap_or_default()) % n.max(1)
    }
}

impl Op {
    /// Reads one operator from the beginning of the bytes; `None` if they end too early. Takes at most 14 bytes.
    ///
    /// In random bytes, operators that add elements are more frequent than operators that remove them, and fitting arguments more
    /// frequent than refused ones.
    pub fn from_bytes(bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        let first = bytes.next()?;
        let mut place = u32::from(first & 31);
        let (kind, _) = OpKind::SHARES.iter().find(|(_, share)| {
            let is_it = place < *share;
            place = place.saturating_sub(*share);
            is_it
        })?;
        let mut source = Finite { bytes, is_over: false };
        let op = Self::draw(*kind, &mut source, first >> 5);
        (!source.is_over).then_some(op)
    }
}

/// The first byte of an operator chooses among 32 values.
const _: () = {
    let (mut i, mut sum) = (0, 0);
    while i < OpKind::SHARES.len() {
        sum += OpKind::SHARES[i].1;
        i += 1;
    }
    assert!(sum == 32, "the shares of all operators are 32 together");
};

impl Program {
    /// Decodes a program. An incomplete operator at the end is ignored. O(bytes).
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Self {
        let mut bytes = bytes.iter().copied();
        Self(core::iter::from_fn(|| Op::from_bytes(&mut bytes)).collect())
    }

    /// Writes the program as a Rust expression, for use where `twinedge::program::Program` is in scope.
    #[must_use]
    pub fn to_rust(&self) -> String {
        let lines = self.0.iter().fold(String::new(), |lines, op| lines + "\n    " + &format!("{op}"));
        format!("\"twinedge program 1{lines}\n\".parse::<Program>().unwrap()")
    }
}
