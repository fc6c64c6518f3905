//! The counts of a validation.

/// The numbers of records, components, cycles, borders and handles. A number is `None` if a rule that its counting relies on is
/// broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Counts {
    /// V.
    pub vertices: usize,
    /// Half-edges.
    pub half_edges: usize,
    /// E: pairs of twins, plus half-edges without twin at open boundaries.
    pub edges: usize,
    /// F: face records, including the unbounded face.
    pub faces: usize,
    /// Boundary components listed as outer.
    pub outer_boundaries: usize,
    /// Boundary components listed as inner, including isolated vertices.
    pub inner_boundaries: usize,
    /// Vertices that no half-edge leaves.
    pub isolated_vertices: usize,
    /// C: connected components.
    pub components: Option<usize>,
    /// Cycles of `next`, not counting border loops. Without faces, all cycles.
    pub cycles: Option<usize>,
    /// Border loops, which T3 counts with the cycles: cycles of half-edges without face, and cycles that missing twins would
    /// form. Both representations of a border yield the same number.
    pub borders: Option<usize>,
    /// The sum of the genera of the components.
    pub genus: Option<usize>,
}

impl Counts {
    pub(crate) const NOTHING: Self = Self {
        vertices: 0,
        half_edges: 0,
        edges: 0,
        faces: 0,
        outer_boundaries: 0,
        inner_boundaries: 0,
        isolated_vertices: 0,
        components: None,
        cycles: None,
        borders: None,
        genus: None,
    };

    /// χ = V − E + F of the whole, where F is the number of faces, or without faces the number of cycles that are not border
    /// loops. `None` if components could not be counted.
    ///
    /// If each face has one cycle, the sum of T3 over all components is `χ = 2 · components − isolated_vertices − 2 · genus −
    /// borders`. For a map in the plane with its unbounded face, `χ = 1 + components`. It does not depend on the representation
    /// of borders.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Table, validate};
    /// // An edge in the unbounded face.
    /// let table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
    /// let report = validate(&table, &Expectation::plane(), Collect::All);
    /// assert_eq!(report.counts().euler_characteristic(), Some(2));
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    #[must_use]
    pub fn euler_characteristic(&self) -> Option<isize> {
        self.components?;
        let faces = if self.faces > 0 { self.faces } else { self.cycles? };
        let [vertices, edges, faces] = [self.vertices, self.edges, faces].map(|n| isize::try_from(n).ok());
        vertices?.checked_sub(edges?)?.checked_add(faces?)
    }
}

/// The bounds of T4: the maximum numbers of edges and faces of a simple map with this number of vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounds {
    /// `3V − 6`, the maximum number of edges.
    pub most_edges: usize,
    /// `2V − 4`, the maximum number of faces.
    pub most_faces: usize,
}
