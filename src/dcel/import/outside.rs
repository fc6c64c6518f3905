//! The choice of the unbounded face.

/// The choice of the unbounded face for a structure that comes in by [`Dcel::from_view`](crate::dcel::Dcel::from_view).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum Outside {
    /// The unbounded face that the structure has. Its expectation has [`Part::UnboundedFace`](crate::validate::Part).
    #[default]
    Given,
    /// This face of a closed mesh, given by its index in the view. Its cycle becomes an inner boundary component, so the
    /// mesh is unrolled into the plane with that face around it.
    Face(usize),
    /// The part beyond the border of an open mesh: half-edges without twin, or with a twin but without a face. Several
    /// components may lie side by side, each with one border.
    Border,
}
