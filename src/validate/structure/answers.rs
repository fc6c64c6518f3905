//! Writes views as lists of answers.

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
