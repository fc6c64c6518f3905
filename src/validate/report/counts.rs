//! The counts of a validation.

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
    /// Cycles of `next` that are no border loops. Without faces, all of them.
    pub cycles: Option<usize>,
    /// Border loops, which T3 counts with the cycles: cycles of half-edges that have no face, and cycles that the missing twins
    /// of half-edges would make. So both ways of keeping a border have the same number.
    pub borders: Option<usize>,
    /// The sum of the genera of the components.
    pub genus: Option<usize>,
}

impl Counts {
    /// Nothing counted.
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

    /// χ = V − E + F of the whole, F being the faces, or, where there are none, the cycles that are no border loops. `None` if
    /// components could not be counted.
    ///
    /// Where each face has one cycle, T3 adds up to `χ = 2 · components − isolated_vertices − 2 · genus − borders`. For a map in
    /// the plane with its unbounded face, `χ = 1 + components`. It does not depend on the way in which a border is kept.
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

/// The bounds of T4, for a simple map: the most edges and faces that its number of vertices allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounds {
    /// `3V − 6`, the most edges possible.
    pub most_edges: usize,
    /// `2V − 4`, the most faces possible.
    pub most_faces: usize,
}
