//! Writes views: as lists of answers, or by delegation to another view, as references, boxes and views that forward some questions do.

use super::parts::Parts;
use super::view::{HalfEdgeColumns, View};
use alloc::boxed::Box;

/// Writes the methods of a [`View`](crate::validate::View) that forward their questions to another view.
///
/// Use it inside `impl View for …`, with a closure from the structure to the other view, and the methods to write: all
/// methods but `half_edge_columns`, `except` some, or `only` some. A view whose answers are all forwarded implements
/// `half_edge_columns` by hand.
///
/// ```
/// use twinedge::delegate_view;
/// use twinedge::validate::{Collect, Expectation, Link, Rule, Table, View, validate};
///
/// /// A table in which half-edge 0 is its own twin.
/// struct Corrupt(Table);
///
/// impl View for Corrupt {
///     delegate_view!(|this| &this.0; except twin);
///
///     fn twin(&self, half_edge: usize) -> Link {
///         if half_edge == 0 { Some(0) } else { self.0.twin(half_edge) }
///     }
/// }
///
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let report = validate(&Corrupt(edge), &Expectation::plane(), Collect::All);
/// assert_eq!(report.first().unwrap().rule(), Rule::L1);
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
///
/// Several views can share the questions:
///
/// ```
/// use twinedge::delegate_view;
/// use twinedge::validate::{Table, View};
///
/// /// The records of one table, with the boundary components and faces of another.
/// struct Joined {
///     map: Table,
///     faces: Table,
/// }
///
/// impl View for Joined {
///     delegate_view!(|this| &this.faces; only boundary_slots, is_boundary, boundary_face, boundary_start, boundary_place);
///     delegate_view!(|this| &this.faces; only face_slots, is_face, outer, inner_count, inner);
///     delegate_view!(|this| &this.map; only parts, vertex_slots, is_vertex, leaving, isolated);
///     delegate_view!(|this| &this.map; only half_edge_slots, is_half_edge, origin, twin, next, prev, boundary);
/// }
///
/// let joined = Joined { map: "V 1 - 0 H 0 B 0 F 0".parse()?, faces: "V 0 H 0 B 1 0 v0 i0 F 1 - 1 0".parse()? };
/// assert_eq!(Table::copy_of(&joined).unwrap().to_string(), "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0");
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[macro_export]
macro_rules! delegate_view {
    (|$this:ident| $view:expr) => {
        $crate::delegate_view!(|$this| $view; except);
    };
    (|$this:ident| $view:expr; only $($method:ident),+ $(,)?) => {
        $($crate::delegate_view!(@write [$this $view] $method);)+
    };
    (|$this:ident| $view:expr; except $($excepted:ident),* $(,)?) => {
        $crate::delegate_view!(@unless [$this $view] vertex_slots [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] half_edge_slots [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] boundary_slots [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] face_slots [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] is_vertex [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] is_half_edge [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] is_boundary [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] is_face [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] origin [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] parts [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] twin [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] next [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] prev [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] boundary [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] face [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] leaving [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] isolated [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] boundary_face [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] boundary_start [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] boundary_place [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] outer [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] inner_count [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] inner [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] outer_half_edge [$($excepted)*]);
        $crate::delegate_view!(@unless [$this $view] inner_start [$($excepted)*]);
    };

    // Writes a method unless it is excluded.
    (@unless $to:tt vertex_slots [vertex_slots $($others:ident)*]) => {};
    (@unless $to:tt half_edge_slots [half_edge_slots $($others:ident)*]) => {};
    (@unless $to:tt boundary_slots [boundary_slots $($others:ident)*]) => {};
    (@unless $to:tt face_slots [face_slots $($others:ident)*]) => {};
    (@unless $to:tt is_vertex [is_vertex $($others:ident)*]) => {};
    (@unless $to:tt is_half_edge [is_half_edge $($others:ident)*]) => {};
    (@unless $to:tt is_boundary [is_boundary $($others:ident)*]) => {};
    (@unless $to:tt is_face [is_face $($others:ident)*]) => {};
    (@unless $to:tt origin [origin $($others:ident)*]) => {};
    (@unless $to:tt parts [parts $($others:ident)*]) => {};
    (@unless $to:tt twin [twin $($others:ident)*]) => {};
    (@unless $to:tt next [next $($others:ident)*]) => {};
    (@unless $to:tt prev [prev $($others:ident)*]) => {};
    (@unless $to:tt boundary [boundary $($others:ident)*]) => {};
    (@unless $to:tt face [face $($others:ident)*]) => {};
    (@unless $to:tt leaving [leaving $($others:ident)*]) => {};
    (@unless $to:tt isolated [isolated $($others:ident)*]) => {};
    (@unless $to:tt boundary_face [boundary_face $($others:ident)*]) => {};
    (@unless $to:tt boundary_start [boundary_start $($others:ident)*]) => {};
    (@unless $to:tt boundary_place [boundary_place $($others:ident)*]) => {};
    (@unless $to:tt outer [outer $($others:ident)*]) => {};
    (@unless $to:tt inner_count [inner_count $($others:ident)*]) => {};
    (@unless $to:tt inner [inner $($others:ident)*]) => {};
    (@unless $to:tt outer_half_edge [outer_half_edge $($others:ident)*]) => {};
    (@unless $to:tt inner_start [inner_start $($others:ident)*]) => {};
    (@unless $to:tt $method:ident [$other:ident $($others:ident)*]) => {
        $crate::delegate_view!(@unless $to $method [$($others)*]);
    };
    (@unless $to:tt $method:ident []) => {
        $crate::delegate_view!(@write $to $method);
    };

    // Each method by its name.
    (@write $to:tt vertex_slots) => { $crate::delegate_view!(@method $to vertex_slots() -> usize); };
    (@write $to:tt half_edge_slots) => { $crate::delegate_view!(@method $to half_edge_slots() -> usize); };
    (@write $to:tt boundary_slots) => { $crate::delegate_view!(@method $to boundary_slots() -> usize); };
    (@write $to:tt face_slots) => { $crate::delegate_view!(@method $to face_slots() -> usize); };
    (@write $to:tt is_vertex) => { $crate::delegate_view!(@method $to is_vertex(vertex) -> bool); };
    (@write $to:tt is_half_edge) => { $crate::delegate_view!(@method $to is_half_edge(half_edge) -> bool); };
    (@write $to:tt is_boundary) => { $crate::delegate_view!(@method $to is_boundary(boundary) -> bool); };
    (@write $to:tt is_face) => { $crate::delegate_view!(@method $to is_face(face) -> bool); };
    (@write $to:tt origin) => { $crate::delegate_view!(@method $to origin(half_edge) -> $crate::validate::Link); };
    (@write $to:tt parts) => { $crate::delegate_view!(@method $to parts() -> $crate::validate::Parts); };
    (@write $to:tt twin) => { $crate::delegate_view!(@method $to twin(half_edge) -> $crate::validate::Link); };
    (@write $to:tt next) => { $crate::delegate_view!(@method $to next(half_edge) -> $crate::validate::Link); };
    (@write $to:tt prev) => { $crate::delegate_view!(@method $to prev(half_edge) -> $crate::validate::Link); };
    (@write $to:tt boundary) => { $crate::delegate_view!(@method $to boundary(half_edge) -> $crate::validate::Link); };
    (@write $to:tt face) => { $crate::delegate_view!(@method $to face(half_edge) -> $crate::validate::Link); };
    (@write $to:tt leaving) => { $crate::delegate_view!(@method $to leaving(vertex) -> $crate::validate::Link); };
    (@write $to:tt isolated) => { $crate::delegate_view!(@method $to isolated(vertex) -> $crate::validate::Link); };
    (@write $to:tt boundary_face) => { $crate::delegate_view!(@method $to boundary_face(boundary) -> $crate::validate::Link); };
    (@write $to:tt boundary_start) => { $crate::delegate_view!(@method $to boundary_start(boundary) -> Option<$crate::validate::Start>); };
    (@write $to:tt boundary_place) => { $crate::delegate_view!(@method $to boundary_place(boundary) -> Option<$crate::validate::BoundaryPlace>); };
    (@write $to:tt outer) => { $crate::delegate_view!(@method $to outer(face) -> $crate::validate::Link); };
    (@write $to:tt inner_count) => { $crate::delegate_view!(@method $to inner_count(face) -> usize); };
    (@write $to:tt inner) => { $crate::delegate_view!(@method $to inner(face, position) -> $crate::validate::Link); };
    (@write $to:tt outer_half_edge) => { $crate::delegate_view!(@method $to outer_half_edge(face) -> $crate::validate::Link); };
    (@write $to:tt inner_start) => { $crate::delegate_view!(@method $to inner_start(face, position) -> Option<$crate::validate::Start>); };
    (@method [$this:ident $view:expr] $method:ident($($argument:ident),*) -> $answer:ty) => {
        #[inline]
        fn $method(&self, $($argument: usize),*) -> $answer {
            let $this = self;
            $crate::validate::View::$method($view, $($argument),*)
        }
    };
}

impl<V: View + ?Sized> View for &V {
    delegate_view!(|this| *this);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        (**self).half_edge_columns()
    }
}

impl<V: View + ?Sized> View for Box<V> {
    delegate_view!(|this| &**this);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        (**self).half_edge_columns()
    }
}

/// Writes the methods of a [`View`](crate::validate::View), one answer per line.
///
/// Use it inside `impl View for …`. First comes the name of the structure, then each question with the names of its arguments,
/// which are indices, and its answer. Omitted questions keep the defaults of the trait.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Parts, View, validate};
/// use twinedge::view_answers;
///
/// /// A closed mesh. The twin of half-edge `h` is `h ^ 1`.
/// struct Mesh {
///     vertices: usize,
///     origin: Vec<usize>,
///     next: Vec<usize>,
/// }
///
/// impl View for Mesh {
///     view_answers! { |mesh|
///         parts => Parts::NONE,
///         vertex_slots => mesh.vertices,
///         half_edge_slots => mesh.next.len(),
///         origin(h) => Some(mesh.origin[h]),
///         twin(h) => Some(h ^ 1),
///         next(h) => Some(mesh.next[h]),
///     }
/// }
///
/// let pillow = Mesh { vertices: 3, origin: vec![0, 1, 1, 2, 2, 0], next: vec![2, 5, 4, 1, 0, 3] };
/// assert!(validate(&pillow, &Expectation::surface(), Collect::All).is_valid());
/// ```
#[macro_export]
macro_rules! view_answers {
    (|$this:ident| $($method:ident $(($($argument:ident),+))? => $answer:expr),+ $(,)?) => {
        $($crate::view_answers!(@write [$this $answer] $method $($($argument)+)?);)+
    };

    // Each method by its name.
    (@write $answer:tt vertex_slots) => { $crate::view_answers!(@method $answer vertex_slots() -> usize); };
    (@write $answer:tt half_edge_slots) => { $crate::view_answers!(@method $answer half_edge_slots() -> usize); };
    (@write $answer:tt boundary_slots) => { $crate::view_answers!(@method $answer boundary_slots() -> usize); };
    (@write $answer:tt face_slots) => { $crate::view_answers!(@method $answer face_slots() -> usize); };
    (@write $answer:tt is_vertex $a:ident) => { $crate::view_answers!(@method $answer is_vertex($a) -> bool); };
    (@write $answer:tt is_half_edge $a:ident) => { $crate::view_answers!(@method $answer is_half_edge($a) -> bool); };
    (@write $answer:tt is_boundary $a:ident) => { $crate::view_answers!(@method $answer is_boundary($a) -> bool); };
    (@write $answer:tt is_face $a:ident) => { $crate::view_answers!(@method $answer is_face($a) -> bool); };
    (@write $answer:tt origin $a:ident) => { $crate::view_answers!(@method $answer origin($a) -> $crate::validate::Link); };
    (@write $answer:tt parts) => { $crate::view_answers!(@method $answer parts() -> $crate::validate::Parts); };
    (@write $answer:tt twin $a:ident) => { $crate::view_answers!(@method $answer twin($a) -> $crate::validate::Link); };
    (@write $answer:tt next $a:ident) => { $crate::view_answers!(@method $answer next($a) -> $crate::validate::Link); };
    (@write $answer:tt prev $a:ident) => { $crate::view_answers!(@method $answer prev($a) -> $crate::validate::Link); };
    (@write $answer:tt boundary $a:ident) => { $crate::view_answers!(@method $answer boundary($a) -> $crate::validate::Link); };
    (@write $answer:tt face $a:ident) => { $crate::view_answers!(@method $answer face($a) -> $crate::validate::Link); };
    (@write $answer:tt leaving $a:ident) => { $crate::view_answers!(@method $answer leaving($a) -> $crate::validate::Link); };
    (@write $answer:tt isolated $a:ident) => { $crate::view_answers!(@method $answer isolated($a) -> $crate::validate::Link); };
    (@write $answer:tt boundary_face $a:ident) => { $crate::view_answers!(@method $answer boundary_face($a) -> $crate::validate::Link); };
    (@write $answer:tt boundary_start $a:ident) => { $crate::view_answers!(@method $answer boundary_start($a) -> Option<$crate::validate::Start>); };
    (@write $answer:tt boundary_place $a:ident) => { $crate::view_answers!(@method $answer boundary_place($a) -> Option<$crate::validate::BoundaryPlace>); };
    (@write $answer:tt outer $a:ident) => { $crate::view_answers!(@method $answer outer($a) -> $crate::validate::Link); };
    (@write $answer:tt inner_count $a:ident) => { $crate::view_answers!(@method $answer inner_count($a) -> usize); };
    (@write $answer:tt inner $a:ident $b:ident) => { $crate::view_answers!(@method $answer inner($a, $b) -> $crate::validate::Link); };
    (@write $answer:tt outer_half_edge $a:ident) => { $crate::view_answers!(@method $answer outer_half_edge($a) -> $crate::validate::Link); };
    (@write $answer:tt inner_start $a:ident $b:ident) => { $crate::view_answers!(@method $answer inner_start($a, $b) -> Option<$crate::validate::Start>); };
    (@method [$this:ident $answer:expr] $method:ident($($argument:ident),*) -> $type:ty) => {
        fn $method(&self, $($argument: usize),*) -> $type {
            let $this = self;
            // Some answers ignore the structure.
            let _ = $this;
            $answer
        }
    };
}

/// A structure restricted to some parts.
///
/// [`parts`](View::parts) answers the parts in both sets; all other questions are forwarded. It costs nothing.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Only, Part, Parts, Rule, Table, validate};
/// // An edge between two vertices. Half-edge 0 says that it precedes itself.
/// let table: Table = "V 2 0 - 1 - H 2 0 1 1 0 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let report = validate(&table, &Expectation::plane(), Collect::All);
/// assert_eq!(report.broken_rules().next(), Some(Rule::L2));
/// let without_prev = Only::new(&table, Parts::ALL.without(Part::Prev));
/// assert!(validate(&without_prev, &Expectation::plane(), Collect::All).is_valid());
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Only<V> {
    view: V,
    parts: Parts,
}

impl<V> Only<V> {
    /// Restricts the structure to these parts.
    #[must_use]
    pub const fn new(view: V, parts: Parts) -> Self {
        Self { view, parts }
    }

    /// Returns the whole structure. O(1).
    pub const fn whole(&self) -> &V {
        &self.view
    }
}

impl<V: View> View for Only<V> {
    crate::delegate_view!(|this| &this.view; except parts);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        self.view.half_edge_columns()
    }

    fn parts(&self) -> Parts {
        self.view.parts().intersection(self.parts)
    }
}
