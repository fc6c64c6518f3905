//! Structures as they are: adapters from what a structure keeps to what a [`View`](super::View) answers.
//!
//! Implement [`View`](super::View) with the links that the structure keeps, answer nil for those that it does not, wrap it in an
//! adapter for what is missing, and validate that. Adapters can be nested, inner first in this table.
//!
//! | your structure keeps | do |
//! | --- | --- |
//! | half-edges with origin, twin and next | nothing: implement [`View`](super::View) |
//! | `prev` and not `next` | [`Backward`] |
//! | `next` and not `prev` | nothing: [`parts`](super::View::parts) leaves out [`Part::Prev`](super::Part::Prev) |
//! | half-edges along a border, without `next` and face | [`Borders`], and [`open`](super::Expectation::open) |
//! | half-edges along a border, with `next`, without face | [`open`](super::Expectation::open) |
//! | no half-edge on the far side of a border edge | answer `twin` with nil, and [`open`](super::Expectation::open) |
//! | the target of each half-edge | [`Targets`] |
//! | the same, in a structure that changes | answer `origin(h)` with `target(prev(h))`, if it has `prev` or its faces are triangles; if every half-edge has a twin, with `target(twin(h))` |
//! | a half-edge that arrives at each vertex | answer `leaving` with its twin; if that is nil, with its next |
//! | no half-edge at the vertices | leave [`Part::Leaving`](super::Part::Leaving) out of the parts |
//! | the face of each half-edge, nothing in the faces | [`FaceLabels`] |
//! | one half-edge in each face | answer `outer_half_edge`; of the parts about faces, [`Part::Faces`](super::Part::Faces) alone |
//! | outer half-edge and holes in each face | answer `outer_half_edge`, `inner_count`, `inner_start`; leave [`Part::BoundaryComponents`](super::Part::BoundaryComponents) out of the parts |
//! | no faces | leave [`Part::Faces`](super::Part::Faces) out of the parts |
//! | keys, handles or pointers instead of indices | [`Index`], one for each kind, or [`Ids`]; [`Report::named`](super::Report::named) prints reports with them |
//! | half-edges that operators move to other indices | nothing to validate it; to test its operators, `program::mesh::Named` (feature `dcel`) |
//! | vacant slots | answer `is_vertex`, `is_half_edge`, `is_face` |
//!
//! | family | half-edge `h` is | missing | tested in `tests/validate/families/` |
//! | --- | --- | --- | --- |
//! | textbook (de Berg et al. 2008) | a record | nothing | `textbook` |
//! | CCB records (CGAL arrangements) | a record | origins: [`Targets`] | `ccb` |
//! | OpenMesh | a record; its twin is `h ^ 1` | origins: [`Targets`] | `openmesh` |
//! | CGAL `Surface_mesh` | a record; its twin is `h ^ 1` | origins: [`Targets`]; its vertices keep one that arrives | `surface_mesh` |
//! | tri-mesh | a record with a key | origins: [`Targets`]; borders: [`Borders`]; [`Index`] | `keyed_mesh` |
//! | corner table (Rossignac 1999) | the side opposite to corner `h` | lists of faces: [`FaceLabels`] | `corner_table` |
//! | quad-edge (Guibas and Stolfi 1985) | a primal quarter: `next = Rot ∘ Onext ∘ Rot⁻¹`, `prev = Sym ∘ Onext` | lists of faces: [`FaceLabels`] | `quad_edge` |
//! | winged edge (Baumgart 1975) | a side of an edge: `next` and `prev` are its wings | nothing | `winged_edge` |
//!
//! An adapter derives links, and a link that is derived agrees with those that it is derived from. What can still be compared,
//! and so what a fault breaks, is said on the page of each adapter. The tests set each link that a small structure of each
//! family keeps to each other value, and compare the verdict with one that uses no adapter.
//!
//! Adapters are views like all others: no answer of the structure makes them panic or loop, and they cost linear time and
//! memory. They read the structure when they are made, and keep what they derived: after a change of the structure, make a new one.

mod backward;
mod borders;
mod cycles;
mod index;
mod inverse;
mod labels;
mod nesting;
mod targets;

pub use backward::Backward;
pub use borders::Borders;
pub use index::{Ids, Index};
pub use labels::FaceLabels;
pub use targets::Targets;
