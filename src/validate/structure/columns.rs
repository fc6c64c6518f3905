//! Columns of half-edges that a structure lends.

/// The links of all half-edges as columns of slots, as lent by [`View::half_edge_columns`](super::View::half_edge_columns).
///
/// The twin of half-edge `h` is `h ^ 1`. Each column has an entry for each half-edge slot, including vacant ones; columns of links that are not stored are empty. `u32::MAX`
/// is nil.
#[derive(Clone, Copy, Debug)]
pub struct HalfEdgeColumns<'a> {
    /// The vertex where each half-edge starts.
    pub origin: &'a [u32],
    /// The next half-edge of each half-edge.
    pub next: &'a [u32],
    /// The previous half-edge of each half-edge.
    pub prev: &'a [u32],
    /// The boundary component that each half-edge names.
    pub boundary: &'a [u32],
    /// The face that each half-edge names.
    pub face: &'a [u32],
    /// An odd number for each live edge (the edge of half-edges `2e` and `2e + 1`), and an even one for each vacant edge; `None` if no
    /// half-edge slot is vacant.
    pub live_edges: Option<&'a [u32]>,
}
