//! The trait of structures that programs drive: handles, questions, and operators.

use super::operators::{Call, Handle};
use crate::dcel::Corner;
use crate::validate::{Link, Start, View};
use core::fmt::{self, Debug};
use thiserror::Error;

/// A corner of the subject `K`, named by handles. It also names the boundary component and the face on which it lies.
///
/// Subjects have no handles of boundary components: implementations may keep either record when two are merged, as
/// [`Dcel`](crate::dcel::Dcel) keeps the cheaper one. The corners of a component are the same in every structure.
pub type CornerOf<K> = Corner<<K as Subject>::HalfEdge, <K as Subject>::Vertex>;

/// A call of the subject `K`.
pub type CallOf<K> = Call<<K as Subject>::Vertex, <K as Subject>::HalfEdge, <K as Subject>::Face>;

/// A handle of the subject `K`.
pub type HandleOf<K> = Handle<<K as Subject>::Vertex, <K as Subject>::HalfEdge, <K as Subject>::Face>;

/// The reason for a refusal: the category of the error, common to all subjects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Error)]
#[non_exhaustive]
pub enum Refusal {
    /// A handle names no live record.
    #[error("a handle is stale")]
    Stale,
    /// The vertex has half-edges.
    #[error("the vertex is not isolated")]
    NotIsolated,
    /// The two corners lie in different faces.
    #[error("the corners lie in different faces")]
    FacesDiffer,
    /// The two corners are at different vertices.
    #[error("the corners are at different vertices")]
    VerticesDiffer,
    /// A boundary component chosen for the new face is not another inner one of the old face.
    #[error("a boundary component chosen for the new face is not another inner one of the old face")]
    NotInner,
    /// The boundary component is an outer one.
    #[error("an outer boundary component cannot be moved")]
    IsOuter,
    /// The degree of the target is not 2.
    #[error("the target does not have degree 2")]
    DegreeNotTwo,
    /// The edge starts and ends at the same vertex.
    #[error("the edge is a loop")]
    Loop,
    /// Both sides of the edge lie on one boundary component.
    #[error("the edge has the same boundary component on both sides")]
    NotSeparating,
    /// The face lies inside the component to be moved into it.
    #[error("the face lies inside what is to be moved into it")]
    InsideItself,
    /// A corner or a side of the edge is on the border, where the structure has no face.
    #[error("no face is there: it is on the border")]
    Border,
    /// A face would have several boundary components or none, but faces of this structure are discs.
    #[error("a face would not be a disc any more")]
    NotDisc,
    /// A face at the edge is not a triangle.
    #[error("a face at the edge is not a triangle")]
    NotTriangle,
    /// Two edges would join the same two vertices, or the surface would change: the link condition does not hold.
    #[error("the triangulation would not be simple any more")]
    NotSimple,
    /// The subject's own policy forbids it.
    #[error("a policy does not allow it")]
    Policy,
    /// The subject has no room for more records.
    #[error("there is no room")]
    Full,
    /// The subject does not have this operator.
    #[error("the operator is not supported")]
    Unsupported,
}

/// The outcome of one operator of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StepOutcome {
    /// The operator was applied.
    Applied,
    /// The subject refused.
    Refused(Refusal),
    /// The subject was not called: there was nothing to choose from, such as no half-edge or no stale handle.
    Skipped,
}

impl fmt::Display for StepOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Applied => f.write_str("applied"),
            Self::Refused(refusal) => write!(f, "refused: {refusal}"),
            Self::Skipped => f.write_str("skipped: nothing to choose from"),
        }
    }
}

/// Converts the refusal of a question during a choice into a refusal of the operator.
impl From<Refusal> for StepOutcome {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal)
    }
}

/// A structure that programs can drive: handles, questions and operators.
///
/// The variants of [`Call`] define the operators: their effects, values and refusals.
///
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::program::{Call, CallOf, HandleOf, Refusal, Subject, conformance};
/// use twinedge::validate::{Expectation, View};
/// use twinedge::{delegate_subject, delegate_view};
///
/// /// A structure that turns edges the wrong way.
/// #[derive(Clone, Default)]
/// struct Wrong(Dcel);
///
/// impl View for Wrong {
///     delegate_view!(|this| &this.0);
/// }
/// impl Subject for Wrong {
///     delegate_subject!(Dcel, |this| &this.0);
///
///     fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
///         self.0.apply(match call {
///             Call::FlipEdge { half_edge, turn } => Call::FlipEdge { half_edge, turn: turn.reversed() },
///             other => other,
///         })
///     }
/// }
/// assert!(conformance::check(Wrong::default, &Expectation::plane()).is_err());
/// ```
/// # Partial structures
///
/// A structure that can only turn edges matches [`Call::FlipEdge`], and answers [`Refusal::Unsupported`] to every other call. Where the
/// indices of its [`View`] are stable handles, [`subject_by_index!`](crate::subject_by_index) writes the questions. The example
/// `mesh_conformance` is such a structure.
///
/// A face may be missing: half-edges on the border of a mesh have none. There [`Subject::face_of`] answers [`Refusal::Border`], and
/// operators that need the face refuse with it. A structure without faces, or without `next` on the border, answers these questions
/// with [`Refusal::Unsupported`]. For structures with a border, and for structures whose faces are discs,
/// [`PointerModel::from_view`](crate::program::PointerModel::from_view) lists two more reasons to refuse, and their order.
///
/// # The view
///
/// [`View`] is the same structure as the validator sees it. Its indices may be unrelated to the handles:
/// [`Subject::half_edge_at`] and [`Subject::vertex_at`] convert indices into handles. A structure with keys keeps an [`Index`](crate::validate::adapt::Index) of all keys seen so far,
/// [extends](crate::validate::adapt::Index::extend) it after each operator, and answers `is_vertex`, `is_half_edge` and `is_face` by
/// testing whether the key is live.
pub trait Subject: View {
    /// Names a vertex. Like every handle, it must never name another element after its vertex is removed.
    type Vertex: Copy + Eq + Debug;
    /// Names a half-edge.
    type HalfEdge: Copy + Eq + Debug;
    /// Names a face.
    type Face: Copy + Eq + Debug;

    /// True if half-edges are found again after each operator, as by [`mesh::Named`](crate::program::mesh::Named). Only changes advice
    /// in messages.
    #[doc(hidden)]
    fn is_named(&self) -> bool {
        false
    }

    /// Returns the unbounded face; `None`, the default, if the structure has no such face.
    fn unbounded_face(&self) -> Option<Self::Face> {
        None
    }

    /// Returns the handle of the half-edge with this index in the view.
    fn half_edge_at(&self, index: usize) -> Option<Self::HalfEdge>;

    /// Returns the handle of the vertex with this index in the view. Called for isolated vertices only: a structure without them keeps
    /// the default.
    fn vertex_at(&self, index: usize) -> Option<Self::Vertex> {
        let _ = index;
        None
    }

    /// Returns the face in which a corner lies.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale); [`NotIsolated`](Refusal::NotIsolated); [`Border`](Refusal::Border).
    fn face_of(&self, corner: CornerOf<Self>) -> Result<Self::Face, Refusal>;

    /// Returns the vertex where a half-edge starts.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn origin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, Refusal>;

    /// Returns the other half-edge of the same edge.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn twin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Refusal>;

    /// Returns the half-edge that follows on the same cycle.
    ///
    /// # Errors
    /// [`Stale`](Refusal::Stale).
    fn next_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, Refusal>;

    /// Applies an operator, and returns the handle documented at the variant of [`Call`]. The default supports no operator.
    ///
    /// # Errors
    /// The first reason to refuse, in the order of [`Call`]; [`Unsupported`](Refusal::Unsupported) if the structure does not have the
    /// operator. On error the structure is unchanged.
    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let _ = call;
        Err(Refusal::Unsupported)
    }

    /// Applies an operator that makes an edge, and returns its half-edge.
    ///
    /// # Errors
    /// The errors of [`apply`](Self::apply); [`Unsupported`](Refusal::Unsupported) if it returns no half-edge.
    fn make_edge(&mut self, call: CallOf<Self>) -> Result<Self::HalfEdge, Refusal> {
        match self.apply(call)? {
            Some(Handle::HalfEdge(half_edge)) => Ok(half_edge),
            _ => Err(Refusal::Unsupported),
        }
    }
}

/// Writes the types and questions of a [`Subject`](crate::program::Subject) that delegates to another one. Use it inside `impl Subject
/// for …`, next to `apply`, with the type of the other subject and an expression for it.
#[macro_export]
macro_rules! delegate_subject {
    ($subject:ty, |$this:ident| $get:expr) => {
        type Vertex = <$subject as $crate::program::Subject>::Vertex;
        type HalfEdge = <$subject as $crate::program::Subject>::HalfEdge;
        type Face = <$subject as $crate::program::Subject>::Face;

        fn is_named(&self) -> bool {
            let $this = self;
            $crate::program::Subject::is_named($get)
        }
        fn unbounded_face(&self) -> Option<Self::Face> {
            let $this = self;
            $crate::program::Subject::unbounded_face($get)
        }
        fn half_edge_at(&self, index: usize) -> Option<Self::HalfEdge> {
            let $this = self;
            $crate::program::Subject::half_edge_at($get, index)
        }
        fn vertex_at(&self, index: usize) -> Option<Self::Vertex> {
            let $this = self;
            $crate::program::Subject::vertex_at($get, index)
        }
        fn face_of(&self, corner: $crate::program::CornerOf<Self>) -> Result<Self::Face, $crate::program::Refusal> {
            let $this = self;
            $crate::program::Subject::face_of($get, corner)
        }
        fn origin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, $crate::program::Refusal> {
            let $this = self;
            $crate::program::Subject::origin_of($get, half_edge)
        }
        fn twin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, $crate::program::Refusal> {
            let $this = self;
            $crate::program::Subject::twin_of($get, half_edge)
        }
        fn next_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, $crate::program::Refusal> {
            let $this = self;
            $crate::program::Subject::next_of($get, half_edge)
        }
    };
}

/// Writes the types and questions of a [`Subject`](crate::program::Subject) whose handles are the indices of its
/// [`View`](crate::validate::View). Use it inside `impl Subject for …`, next to `apply`.
///
/// If every operator of the structure takes one half-edge, as the operators of meshes do, the macro also writes `apply` from the names
/// of operators and methods: `MeshFlipEdge => Self::flip`. The method takes `&mut self` and the index; its value is dropped, and its
/// error becomes a [`Refusal`](crate::program::Refusal) by `From`.
///
/// Operators must leave half-edges at their indices; [`mesh::Named`](crate::program::mesh::Named) is for meshes that move them.
///
/// There is no unbounded face (the default). If the structure reuses the indices of removed records, stale handles look live: see
/// [`Conformance::without_stale_handles`](crate::program::conformance::Conformance::without_stale_handles).
///
/// A half-edge whose slot is vacant is [`Stale`](crate::program::Refusal::Stale). If `next` is nil, or if half-edges store neither face
/// nor boundary component and the structure has no slots for faces, the answer is
/// [`Unsupported`](crate::program::Refusal::Unsupported); a half-edge without face is on the
/// [`Border`](crate::program::Refusal::Border).
///
/// ```
/// use twinedge::program::{Corner, Refusal, Subject};
/// use twinedge::validate::{Table, View};
/// use twinedge::{delegate_view, subject_by_index};
///
/// struct Mine(Table);
/// impl View for Mine {
///     delegate_view!(|this| &this.0);
/// }
/// impl Subject for Mine {
///     subject_by_index!();
/// }
///
/// // A loop on a sphere.
/// let mine = Mine("V 1 0 - H 2 0 1 0 0 0 0 0 1 1 1 B 2 0 h0 o 1 h1 o F 2 0 0 1 0".parse()?);
/// assert_eq!(mine.twin_of(0), Ok(1));
/// assert_eq!(mine.face_of(Corner::At(1)), Ok(1));
/// assert_eq!(mine.twin_of(2), Err(Refusal::Stale));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[macro_export]
macro_rules! subject_by_index {
    ($($operator:ident => $method:expr),+ $(,)?) => {
        $crate::subject_by_index!();

        fn apply(
            &mut self,
            call: $crate::program::CallOf<Self>,
        ) -> Result<Option<$crate::program::HandleOf<Self>>, $crate::program::Refusal> {
            match call {
                $($crate::program::Call::$operator { half_edge } => match $method(self, half_edge) {
                    Ok(_) => Ok(None),
                    Err(refused) => Err($crate::program::Refusal::from(refused)),
                },)+
                _ => Err($crate::program::Refusal::Unsupported),
            }
        }
    };
    () => {
        type Vertex = usize;
        type HalfEdge = usize;
        type Face = usize;

        fn half_edge_at(&self, index: usize) -> Option<usize> {
            Some(index)
        }
        fn vertex_at(&self, index: usize) -> Option<usize> {
            Some(index)
        }
        fn face_of(&self, corner: $crate::program::Corner<usize, usize>) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::face_of(self, corner)
        }
        fn origin_of(&self, half_edge: usize) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::link(self, half_edge, $crate::validate::View::origin)
        }
        fn twin_of(&self, half_edge: usize) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::link(self, half_edge, $crate::validate::View::twin)
        }
        fn next_of(&self, half_edge: usize) -> Result<usize, $crate::program::Refusal> {
            $crate::program::by_index::link(self, half_edge, $crate::validate::View::next)
        }
    };
}

/// The face of a half-edge, stored directly or in its boundary component.
pub(in crate::program) fn view_face_of<V: View + ?Sized>(view: &V, h: usize) -> Link {
    view.boundary(h).map_or_else(|| view.face(h), |boundary| view.boundary_face(boundary))
}

/// The isolated vertices of a view, each with the face that lists it.
pub(in crate::program) fn isolated_of<V: View + ?Sized>(view: &V) -> impl Iterator<Item = (usize, usize)> + '_ {
    let faces = (0..view.face_slots()).filter(|f| view.is_face(*f));
    faces.flat_map(|f| (0..view.inner_count(f)).map(move |i| (f, i))).filter_map(|(f, i)| {
        let start = match view.inner(f, i) {
            Some(b) => view.boundary_start(b),
            None => view.inner_start(f, i),
        };
        match start? {
            Start::Vertex(v) => Some((f, v)),
            Start::HalfEdge(_) => None,
        }
    })
}

/// Answers the questions of [`subject_by_index!`](crate::subject_by_index).
#[doc(hidden)]
pub mod by_index {
    use super::{Corner, Link, Refusal, View, isolated_of, view_face_of};

    fn is_live<V: View>(view: &V, half_edge: usize) -> bool {
        half_edge < view.half_edge_slots() && view.is_half_edge(half_edge)
    }

    /// A link of a half-edge.
    pub fn link<V: View>(view: &V, half_edge: usize, kept: fn(&V, usize) -> Link) -> Result<usize, Refusal> {
        if !is_live(view, half_edge) {
            return Err(Refusal::Stale);
        }
        kept(view, half_edge).ok_or(Refusal::Unsupported)
    }

    /// The face in which a corner lies.
    pub fn face_of<V: View>(view: &V, corner: Corner<usize, usize>) -> Result<usize, Refusal> {
        match corner {
            Corner::At(h) if !is_live(view, h) => Err(Refusal::Stale),
            Corner::At(_) if view.face_slots() == 0 => Err(Refusal::Unsupported),
            Corner::At(h) => view_face_of(view, h).ok_or(Refusal::Border),
            Corner::Isolated(v) if v >= view.vertex_slots() || !view.is_vertex(v) => Err(Refusal::Stale),
            Corner::Isolated(v) => {
                let leaves = |h| is_live(view, h) && view.origin(h) == Some(v);
                if (0..view.half_edge_slots()).any(leaves) {
                    return Err(Refusal::NotIsolated);
                }
                let place = isolated_of(view).find(|(_, isolated)| *isolated == v);
                place.map(|(f, _)| f).ok_or(Refusal::Unsupported)
            }
        }
    }
}
