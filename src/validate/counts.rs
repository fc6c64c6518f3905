//! What a validation counts.

/// The numbers of records, and of components, cycles, borders and handles. `None` is what could not be counted because a
/// rule that the counting relies on is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Counts {
    /// V.
    pub vertices: usize,
    /// Half-edges.
    pub half_edges: usize,
    /// E: pairs of twins, and half-edges without twin where the boundary is open.
    pub edges: usize,
    /// F: face records, the unbounded one included.
    pub faces: usize,
    /// Boundary components listed as outer.
    pub outer_boundaries: usize,
    /// Boundary components listed as inner, isolated vertices included.
    pub inner_boundaries: usize,
    /// Vertices that no half-edge leaves.
    pub isolated_vertices: usize,
    /// C: connected components.
    pub components: Option<usize>,
    /// Cycles of `next`.
    pub cycles: Option<usize>,
    /// Open boundaries of half-edges without twin: the cycles that their missing twins would make. T3 counts them with the
    /// cycles.
    pub borders: Option<usize>,
    /// The sum of the genera of the components.
    pub genus: Option<usize>,
}

/// The bounds of T4, for a simple map: the most edges and faces that its number of vertices allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounds {
    /// `3V − 6`, the most edges possible.
    pub most_edges: usize,
    /// `2V − 4`, the most faces possible.
    pub most_faces: usize,
}
