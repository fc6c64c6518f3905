//! Structures that answer as another does.

/// The methods of a `View` that hand the question on to these fields.
macro_rules! delegate {
    ($($to:ident: $($name:ident($($arg:ident),*) -> $out:ty),+;)*) => {$($(
        fn $name(&self, $($arg: usize),*) -> $out {
            ::twinedge::validate::View::$name(&self.$to, $($arg),*)
        }
    )+)*};
}

/// All methods of a `View`: whether there is a record from one field, and what it says from another.
macro_rules! delegate_view {
    ($live:ident, $rows:ident) => {
        $crate::support::delegate::delegate! {
            $live: vertex_slots() -> usize, half_edge_slots() -> usize, boundary_slots() -> usize, face_slots() -> usize;
            $live: is_vertex(v) -> bool, is_half_edge(h) -> bool, is_boundary(b) -> bool, is_face(f) -> bool;
            $rows: origin(h) -> Link, twin(h) -> Link, next(h) -> Link, prev(h) -> Link, boundary(h) -> Link, face(h) -> Link;
            $rows: leaving(v) -> Link, isolated(v) -> Link, boundary_face(b) -> Link, boundary_start(b) -> Option<Start>;
            $rows: boundary_place(b) -> Option<BoundaryPlace>, outer(f) -> Link, inner_count(f) -> usize, inner(f, i) -> Link;
            $rows: outer_half_edge(f) -> Link, inner_start(f, i) -> Option<Start>;
        }
    };
}

pub(crate) use {delegate, delegate_view};
