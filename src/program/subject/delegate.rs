//! Structures that do as another one does.

/// Writes the methods of a [`Subject`](crate::program::Subject) that hand their calls on to another subject: all questions, and all
/// operators, `except` some. Without the method that runs an
/// operator, only questions; `operators Self::run` writes only operators.
///
/// It stands inside `impl Subject for …`, and names the type of the other subject, the method that gives it, and the method that runs an
/// operator on it.
///
/// ```
/// use twinedge::dcel::{Dcel, Turn};
/// use twinedge::program::{Refusal, Subject, conformance};
/// use twinedge::validate::{Expectation, View};
/// use twinedge::{delegate_subject, delegate_view};
///
/// /// A structure that turns edges the wrong way.
/// #[derive(Clone, Default)]
/// struct Wrong(Dcel);
///
/// impl Wrong {
///     fn right(&self) -> &Dcel { &self.0 }
///     fn run<T>(&mut self, operator: impl FnOnce(&mut Dcel) -> T) -> T { operator(&mut self.0) }
/// }
/// impl View for Wrong {
///     delegate_view!(|this| &this.0);
/// }
/// impl Subject for Wrong {
///     delegate_subject!(Dcel, Self::right, Self::run; except flip_edge);
///
///     fn flip_edge(&mut self, half_edge: Self::HalfEdge, turn: Turn) -> Result<(), Refusal> {
///         Subject::flip_edge(&mut self.0, half_edge, turn.reversed())
///     }
/// }
/// assert!(conformance::check(Wrong::default, &Expectation::plane()).is_err());
/// ```
#[macro_export]
macro_rules! delegate_subject {
    (operators $run:expr $(; except $($excepted:ident),+)?) => {
        $crate::delegate_subject!(@operators $run, [$($($excepted)+)?]
            add_isolated_vertex(face: Self::Face) -> Self::Vertex;
            remove_isolated_vertex(vertex: Self::Vertex) -> ();
            connect(
                from: $crate::program::CornerOf<Self>,
                to: $crate::program::CornerOf<Self>,
                new_face: $crate::program::Side,
                inner: &[$crate::program::CornerOf<Self>]
            ) -> Self::HalfEdge;
            remove_edge(half_edge: Self::HalfEdge) -> Option<Self::Face>;
            split_edge(half_edge: Self::HalfEdge) -> Self::HalfEdge;
            join_edges(half_edge: Self::HalfEdge) -> ();
            split_vertex(from: $crate::program::CornerOf<Self>, to: $crate::program::CornerOf<Self>) -> Self::HalfEdge;
            contract_edge(half_edge: Self::HalfEdge) -> Self::Vertex;
            flip_edge(half_edge: Self::HalfEdge, turn: $crate::program::Turn) -> ();
            move_inner(inner: $crate::program::CornerOf<Self>, face: Self::Face) -> ();
            mesh_flip_edge(half_edge: Self::HalfEdge) -> ();
            mesh_split_edge(half_edge: Self::HalfEdge) -> ();
            mesh_split_face(half_edge: Self::HalfEdge) -> ();
            mesh_collapse_edge(half_edge: Self::HalfEdge) -> ();
        );
    };
    ($subject:ty, $get:expr, $run:expr $(; except $($excepted:ident),+)?) => {
        $crate::delegate_subject!($subject, $get);
        $crate::delegate_subject!(operators $run $(; except $($excepted),+)?);
    };
    ($subject:ty, $get:expr) => {
        type Vertex = <$subject as $crate::program::Subject>::Vertex;
        type HalfEdge = <$subject as $crate::program::Subject>::HalfEdge;
        type Face = <$subject as $crate::program::Subject>::Face;

        fn is_named(&self) -> bool {
            $crate::program::Subject::is_named($get(self))
        }
        fn unbounded_face(&self) -> Option<Self::Face> {
            $crate::program::Subject::unbounded_face($get(self))
        }
        fn half_edge_at(&self, index: usize) -> Option<Self::HalfEdge> {
            $crate::program::Subject::half_edge_at($get(self), index)
        }
        fn vertex_at(&self, index: usize) -> Option<Self::Vertex> {
            $crate::program::Subject::vertex_at($get(self), index)
        }
        fn face_of(&self, corner: $crate::program::CornerOf<Self>) -> Result<Self::Face, $crate::program::Refusal> {
            $crate::program::Subject::face_of($get(self), corner)
        }
        fn origin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::Vertex, $crate::program::Refusal> {
            $crate::program::Subject::origin_of($get(self), half_edge)
        }
        fn twin_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, $crate::program::Refusal> {
            $crate::program::Subject::twin_of($get(self), half_edge)
        }
        fn next_of(&self, half_edge: Self::HalfEdge) -> Result<Self::HalfEdge, $crate::program::Refusal> {
            $crate::program::Subject::next_of($get(self), half_edge)
        }
    };

    (@operators $run:expr, $excepted:tt $($name:ident $arguments:tt -> $answer:ty;)*) => {
        $($crate::delegate_subject!(@unless $run, $excepted $name $arguments $answer);)*
    };
    // Writes an operator unless it is among those excepted.
    (@unless $run:expr, [add_isolated_vertex $($others:ident)*] add_isolated_vertex $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [remove_isolated_vertex $($others:ident)*] remove_isolated_vertex $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [connect $($others:ident)*] connect $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [remove_edge $($others:ident)*] remove_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [split_edge $($others:ident)*] split_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [join_edges $($others:ident)*] join_edges $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [split_vertex $($others:ident)*] split_vertex $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [contract_edge $($others:ident)*] contract_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [flip_edge $($others:ident)*] flip_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [move_inner $($others:ident)*] move_inner $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [mesh_flip_edge $($others:ident)*] mesh_flip_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [mesh_split_edge $($others:ident)*] mesh_split_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [mesh_split_face $($others:ident)*] mesh_split_face $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [mesh_collapse_edge $($others:ident)*] mesh_collapse_edge $arguments:tt $answer:ty) => {};
    (@unless $run:expr, [$other:ident $($others:ident)*] $name:ident $arguments:tt $answer:ty) => {
        $crate::delegate_subject!(@unless $run, [$($others)*] $name $arguments $answer);
    };
    (@unless $run:expr, [] $name:ident ($($argument:ident: $type:ty),*) $answer:ty) => {
        fn $name(&mut self, $($argument: $type),*) -> Result<$answer, $crate::program::Refusal> {
            $run(self, |subject| $crate::program::Subject::$name(subject, $($argument),*))
        }
    };
}
