//! The choice of the unbounded face.

/// The choice of the unbounded face in [`Dcel::from_view`](crate::dcel::Dcel::from_view).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Outside {
    /// The unbounded face of the structure, whose expectation has [`Part::UnboundedFace`](crate::validate::Part).
    #[default]
    Given,
    /// This face of a closed mesh, by its index in the view. Its cycle becomes an inner boundary component, so the mesh
    /// is unrolled into the plane with that face around it.
    Face(usize),
    /// The part beyond the border of an open mesh: beyond half-edges without a twin, or whose twin has no face. Several
    /// components may lie side by side, each with one border.
    Border,
}
