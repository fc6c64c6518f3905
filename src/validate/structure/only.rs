//! Restricts a structure to some parts.

use super::columns::HalfEdgeColumns;
use super::parts::Parts;
use super::view::View;

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
