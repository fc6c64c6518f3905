//! Adapters from the links that a structure stores to the answers of a [`View`](super::View).
//!
//! Implement [`View`](super::View) with the stored links, answer nil for the others, wrap the structure in an adapter that derives
//! the missing links, and validate the result. Adapters can be nested, inner first in this table.
//!
//! | your structure keeps | do |
//! | --- | --- |
//! | half-edges with origin, twin and next | nothing: implement [`View`](super::View) |
//! | `prev` and not `next` | answer `next` from the inverse of `prev` |
//! | `next` and not `prev` | nothing: [`parts`](super::View::parts) leaves out [`Part::Prev`](super::Part::Prev) |
//! | half-edges along a border, without `next` and face | [`Borders`], and [`open`](super::Expectation::open) |
//! | half-edges along a border, with `next`, without face | [`open`](super::Expectation::open) |
//! | no half-edge on the far side of a border edge | answer nil for `twin`, and [`open`](super::Expectation::open) |
//! | the target of each half-edge | [`Targets`] |
//! | the target of each half-edge, in a structure that changes | answer `target(prev(h))` for `origin(h)`, if it has `prev` or its faces are triangles; `target(twin(h))` if every half-edge has a twin |
//! | an arriving half-edge at each vertex | answer `leaving` with its twin; if that is nil, with its next |
//! | no half-edge at the vertices | omit [`Part::Leaving`](super::Part::Leaving) from the parts |
//! | the face of each half-edge, nothing in the faces | [`FaceLabels`] |
//! | one half-edge in each face | answer `outer_half_edge`; the only part about faces is [`Part::Faces`](super::Part::Faces) |
//! | outer half-edge and holes in each face | answer `outer_half_edge`, `inner_count`, `inner_start`; omit [`Part::BoundaryComponents`](super::Part::BoundaryComponents) from the parts |
//! | no faces | omit [`Part::Faces`](super::Part::Faces) from the parts |
//! | keys, handles or pointers instead of indices | [`Index`], one for each kind, or [`Ids`]; [`Report::named`](super::Report::named) prints reports with them |
//! | half-edges that operators move to other indices | nothing for validation; to test its operators, `program::mesh::Named` (feature `dcel`) |
//! | vacant slots | answer `is_vertex`, `is_half_edge`, `is_face` |
//!
//! | family | half-edge `h` is | missing | tested in `tests/validate/families/` |
//! | --- | --- | --- | --- |
//! | textbook (de Berg et al. 2008) | a record | nothing | `textbook` |
//! | CCB records (CGAL arrangements) | a record | origins: [`Targets`] | `ccb` |
//! | OpenMesh | a record; its twin is `h ^ 1` | origins: [`Targets`] | `openmesh` |
//! | CGAL `Surface_mesh` | a record; its twin is `h ^ 1` | origins: [`Targets`]; vertices store an arriving half-edge | `surface_mesh` |
//! | tri-mesh | a record with a key | origins: [`Targets`]; borders: [`Borders`]; [`Index`] | `keyed_mesh` |
//! | corner table (Rossignac 1999) | the side opposite to corner `h` | lists of faces: [`FaceLabels`] | `corner_table` |
//! | quad-edge (Guibas and Stolfi 1985) | a primal quarter: `next = Rot ∘ Onext ∘ Rot⁻¹`, `prev = Sym ∘ Onext` | lists of faces: [`FaceLabels`] | `quad_edge` |
//! | winged edge (Baumgart 1975) | a side of an edge: `next` and `prev` are its wings | nothing | `winged_edge` |
//!
//! A derived link always agrees with the links from which it is derived. The page of each adapter lists the comparisons that
//! remain, and so the rules that a fault breaks. The tests set every stored link of a small structure of each family to every other
//! value, and compare the verdict with one that uses no adapter.
//!
//! Like all views, adapters never make the validator panic or loop, and they take linear time and memory. They read the structure
//! once: after a change, create a new adapter.

mod borders;
mod cycles;
mod index;
mod labels;
mod targets;

pub use borders::Borders;
pub use index::{Ids, Index};
pub use labels::FaceLabels;
pub use targets::Targets;
